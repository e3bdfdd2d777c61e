# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What a frame of a large volume costs: cold, with another light, with another camera, and beside VTK's
own mapper without scattering."""

import numpy as np
import render_vtk
from points import (
    draw,
    measure,
    moved_camera,
    moved_frames,
    record,
    setting,
    stage_of,
    stages_of,
    times_of,
    truth_of,
)

METHOD = "ErrorControlled"
#: Frames a second that a window asks for while something is dragged.
DRAGGED = 15
#: The reference's pixels among 512 x 512.
STRIDE = 32


def turned_light(stage):
    """Another direction each time, by half a degree about the vertical."""
    def turn() -> None:
        x, y, z = stage.light.GetPosition()
        c, s = np.cos(np.radians(0.5)), np.sin(np.radians(0.5))
        stage.light.SetPosition(c * x + s * z, y, c * z - s * x)
    return turn


def controlled(what, device: str, frames: int, dense=None, stride: int = STRIDE) -> dict:
    """ErrorControlled at 1/255 with all its costs."""
    truth = truth_of(what, stride, 1e-5)
    point = measure(what, METHOD, 1, truth, device, frames, dense)
    stage = stage_of(what, METHOD)
    draw(stage, METHOD, 1)
    turn = turned_light(stage)
    point["light_changed"] = times_of(stage.window, turn, frames)
    point["stages_light"] = stages_of(stage.mapper.GetStatistics())
    stage.window.SetDesiredUpdateRate(DRAGGED)
    times_of(stage.window, turn, 1)  # compiles what hurried frames need
    point["light_dragged"] = times_of(stage.window, turn, frames)
    point["stages_dragged"] = stages_of(stage.mapper.GetStatistics())
    return point


def bare_loop(what, step: float, frames: int) -> float:
    """Look-ups a second of a loop without light, whose steps of so many voxels meet the processor's caches
    as often as those of the frame that it is compared with."""
    stage = stage_of(what, "FixedStep")
    stage.mapper.SetOutputToOpticalDepth()
    stage.fixed_step(step)
    found = moved_frames(stage, max(frames, 2))
    return 1000 * found["taps"] / found["camera_moved"]["median"]


def unshadowed(what, device: str, frames: int) -> dict:
    """VTK's composite mapper, shaded, at one-voxel steps."""
    window = render_vtk.window_of(what.scene, 1, what.values(), scattering=False)
    cold = times_of(window, lambda: None, 1)
    moved = times_of(window, moved_camera(window.GetRenderers().GetFirstRenderer()), frames)
    return record(method="VTK, no scattering", field=what.scene.grid, knob=1, device=device,
                  volume=list(what.values().shape[::-1]), image=[what.scene.pixels] * 2, cold=cold,
                  camera_moved=moved, scene=what.words)


def bytes_a_voxel(what) -> float:
    """Of 16-bit data, in a picture so small that its frame targets do not count."""
    values = np.round(65535 * what.values()).astype(np.uint16)
    small = setting(what.scene.grid, what.scene.points, 16, grid=values,
                    extinction=what.scene.extinction / 65535)
    return measure(small, METHOD, 1, None, "", frames=0)["bytes"] / values.size


def measure_field(field: str, device: str, points: int = 256, pixels: int = 512,
                  frames: int = 5, dense=None, stride: int = STRIDE) -> tuple:
    """Records, and the facts beside them; dense: the truth of all pixels, where it is known."""
    what = setting(field, points, pixels)
    ours = controlled(what, device, frames, dense, stride)
    records = [ours, unshadowed(what, device, frames),
               measure(what, "FixedStep", 1, None, device, frames=0)]
    facts = {"loop_taps_per_second": bare_loop(what, ours["eye_step"], frames),
             "bytes_a_voxel": bytes_a_voxel(what)}
    return records, facts
