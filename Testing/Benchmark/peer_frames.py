# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Frames of other renderers, in a Python of their own that has vtk or mitsuba. Called by peers.py.

usage: peer_frames.py JOB

JOB is a JSON file {renderer, scene, knobs, folder}: steps in voxels, or samples of a pixel. Each image
goes into the folder as an .npy file; what is printed last is JSON, {version, frames}.
"""

import json
import os
import statistics
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(1, str(Path(__file__).resolve().parents[1] / "Reference"))
import scenes  # noqa: E402 (after its folder is known)

#: Seconds of a frame beyond which a moved camera is timed once.
SLOW, FRAMES = 3, 3


def summary(times: list) -> dict:
    """Seconds to the milliseconds of a record."""
    times = [1000 * t for t in times]
    low, _, high = statistics.quantiles(times, n=4) if len(times) > 1 else times * 3
    return {"median": statistics.median(times), "quartiles": [low, high]}


def seconds(act) -> float:
    start = time.perf_counter()
    act()
    return time.perf_counter() - start


def vtk_frames(scene: scenes.Scene, knobs) -> tuple:
    import render_vtk
    grid = scenes.grid_of(scene)
    for knob in knobs:
        window = render_vtk.window_of(scene, knob, grid)
        render_vtk.use_float_framebuffer(window, scene)

        def draw(window=window):
            window.Render()
            window.WaitForCompletion()

        cold = seconds(draw)
        image = render_vtk.image_of(window, scene)
        camera = window.GetRenderers().GetFirstRenderer().GetActiveCamera()
        times = []
        for _ in range(FRAMES if cold < SLOW else 1):
            camera.Azimuth(0.01)
            times.append(seconds(draw))
        yield knob, image, summary(times)


def mitsuba_frames(scene: scenes.Scene, knobs) -> tuple:
    """The first compiles."""
    import mitsuba as mi
    mi.set_variant("llvm_ad_rgb")
    import render_mitsuba
    render_mitsuba.render(scene, render_mitsuba.BATCHES, 1)
    for knob in knobs:
        start = time.perf_counter()
        image, _ = render_mitsuba.render(scene, knob, 1 + knob)
        yield knob, image[1], summary([time.perf_counter() - start])


def version_of(renderer: str) -> str:
    if renderer == "vtk":
        from vtkmodules.vtkCommonCore import vtkVersion
        return f"VTK {vtkVersion.GetVTKVersion()}"
    import mitsuba as mi
    return f"Mitsuba {mi.__version__}, LLVM, {os.cpu_count()} cores"


def main() -> None:
    job = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    scene = scenes.Scene(**{key: tuple(value) if isinstance(value, list) else value
                            for key, value in job["scene"].items()})
    draw = vtk_frames if job["renderer"] == "vtk" else mitsuba_frames
    frames = []
    for knob, image, times in draw(scene, job["knobs"]):
        file = str(Path(job["folder"]) / f"{knob:g}.npy")
        np.save(file, image)
        frames.append({"knob": knob, "image": file, "camera_moved": times})
    print(json.dumps({"version": version_of(job["renderer"]), "frames": frames}))


if __name__ == "__main__":
    main()
