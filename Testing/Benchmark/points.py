# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""One measured point: a method at one setting of its knob, its error and its cost."""

import statistics
import time
from dataclasses import dataclass, replace

import numpy as np
from against_closed_forms import paper_stage, step_at
from mapper import Stage, pixels_of
from page import largest_error
from scenes import Scene, grid_of
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction

#: A record's fields; None where the point does not have one. Errors are in 1/255 of the peak (over the
#: reference's pixels; max_error_all: over all pixels, against a fine FixedStep), costs are
#: {median, quartiles} in milliseconds of wall-clock time, eye_step is the longest step in voxels.
FIELDS = ("method", "field", "volume", "image", "knob", "max_error", "max_error_all", "relative_rmse",
          "p99_9", "cold", "light_changed", "light_dragged", "camera_moved", "taps", "bytes", "device",
          "estimated_error", "light_method", "pixel_edge", "eye_step", "stages_cold", "stages_light",
          "stages_dragged", "scene")
METHODS = ("FixedStep", "ErrorControlled", "ErrorControlled, no cache", "Exact", "Paper")
LIGHT_METHODS = ("marched", "looked up", "marched to its cache", "in closed form")
STAGES = ("Gather", "Upload", "Build", "Calibrate", "Compile", "Integrate", "Frame")
#: Of the binary field, whose values between voxels are interpolated: where Paper's medium begins.
THRESHOLD = 0.5
EXTINCTION = {"smooth": 8, "cloud": 20, "faded-cloud": 20, "binary": 8, "CT": 40}
#: Elevation 45 degrees, along no diagonal of the lattice.
LIGHT = (0.6, 1, 0.8)
#: A function of the density with bends, as parts of the extinction: empty below, a peak, a valley.
BENT = ((0, 0), (0.15, 0), (0.4, 1), (0.7, 0.2), (1, 0.8))
#: Milliseconds of a cold frame beyond which a moved camera is timed once.
SLOW = 3000
_grids = {}


@dataclass(frozen=True)
class Setting:
    """What is drawn: a scene, in a few words of the page, and what scenes cannot say."""

    scene: Scene
    words: str = "cube, one light, g = 0"
    more_lights: tuple = ()  #: directions of lights beside the scene's own
    cone: float = 0  #: degrees: its own, at a position, is a spot of this half angle
    bent: bool = False  #: the extinction is BENT of the density
    grid: np.ndarray = None  #: None: the scene's own

    def values(self) -> np.ndarray:
        key = self.scene.grid, self.scene.points
        if self.grid is None and key not in _grids:
            _grids[key] = grid_of(self.scene)
        return _grids[key] if self.grid is None else self.grid


def setting(field: str, points: int, pixels: int, **changes) -> Setting:
    own = {name: changes.pop(name) for name in ("words", "more_lights", "cone", "bent", "grid")
           if name in changes}
    scene = Scene(field, field, EXTINCTION[field], 0, LIGHT, points=points, pixels=pixels)
    return Setting(replace(scene, **changes), **own)


def stage_of(what: Setting, method: str) -> Stage:
    """A fresh window, whose first frame is a cold one."""
    make = paper_stage if method == "Paper" else Stage
    stage = make(what.scene, what.values())
    for direction in what.more_lights:
        light = type(stage.light)()
        light.SetLightTypeToSceneLight()
        light.SetPosition(direction)
        light.SetFocalPoint(0, 0, 0)
        stage.renderer.AddLight(light)
    if what.cone:
        stage.light.SetConeAngle(what.cone)
    if what.bent:
        function = vtkPiecewiseFunction()
        for at, part in BENT:
            function.AddPoint(at, part * what.scene.extinction)
        stage.medium.SetExtinctionScale(1)
        stage.medium.SetExtinctionFunction(function)
    if method.endswith("no cache"):
        stage.mapper.SetLightCachesToNever()
    return stage


def draw(stage: Stage, method: str, knob: float) -> np.ndarray:
    """The knob is a step in voxels, or an allowed error in 1/255 of the peak."""
    if method == "FixedStep":
        return stage.fixed_step(knob)
    if method == "Paper":
        return stage.paper(knob, THRESHOLD)
    if method == "Exact":
        return stage.exact()
    return stage.error_controlled(knob / 255)


def truth_of(what: Setting, stride: int, tolerance: float, method: str = "") -> np.ndarray:
    """Every stride-th pixel by the reference; Paper's medium is homogeneous above its threshold."""
    stage = stage_of(what, "")
    if method == "Paper":
        stage.medium.SetExtinctionScale(1)
        stage.medium.SetExtinctionFunction(step_at(THRESHOLD, what.scene.extinction, 1))
    reference = stage.truth(tolerance)
    reference.SetPixelStride(stride)
    image = vtkImageData()
    if not reference.GetColorImage(image):
        raise RuntimeError("the reference gave no image")
    return pixels_of(image)


def pixels_like(image: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Those that the truth has; it was asked for every stride-th one."""
    stride = -(-image.shape[0] // truth.shape[0])
    return image[::stride, ::stride]


def errors(image: np.ndarray, truth: np.ndarray) -> dict:
    """Over the pixels that the truth has."""
    seen = pixels_like(image, truth)
    off = np.abs(seen - truth)
    return {"max_error": 255 * largest_error(seen, truth),
            "relative_rmse": float(np.sqrt((off ** 2).mean()) / truth.mean()),
            "p99_9": 255 * float(np.quantile(off, 0.999) / truth.max())}


def times_of(window, change, count: int) -> dict:
    """Frames up to the driver's completion, each after a change."""
    times = []
    for _ in range(count):
        change()
        start = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        times.append(1000 * (time.perf_counter() - start))
    low, _, high = statistics.quantiles(times, n=4) if count > 1 else times * 3
    return {"median": statistics.median(times), "quartiles": [low, high]}


def moved_camera(renderer):
    return lambda: renderer.GetActiveCamera().Azimuth(0.01)


def stages_of(statistics_) -> dict:
    return {name.lower(): getattr(statistics_, f"Get{name}Milliseconds")() for name in STAGES}


def record(**known) -> dict:
    unknown = set(known) - set(FIELDS)
    if unknown:
        raise ValueError(f"a record has no {', '.join(sorted(unknown))}")
    return {**dict.fromkeys(FIELDS), **known}


def moved_frames(stage: Stage, count: int) -> dict:
    """Times with a moved camera, and the taps of one frame; a single frame is timed while it counts, which
    costs it a few milliseconds."""
    counted, move = stage.mapper.GetStatistics(), moved_camera(stage.renderer)
    counted.SetCountTaps(count == 1)
    times = times_of(stage.window, move, count)
    if count > 1:
        counted.CountTapsOn()
        times_of(stage.window, move, 1)
    taps = counted.GetTaps()
    counted.CountTapsOff()
    return {"camera_moved": times, "taps": taps}


def cold_frame(what: Setting, method: str, knob: float, device: str) -> tuple:
    """The first frame of a window: its stage, its image, and what a record says of it."""
    stage = stage_of(what, method)
    start = time.perf_counter()
    image = draw(stage, method, knob)
    cold = 1000 * (time.perf_counter() - start)
    counted = stage.mapper.GetStatistics()
    known = {"method": method, "field": what.scene.grid, "volume": list(what.values().shape[::-1]),
             "image": [what.scene.pixels] * 2, "knob": knob, "device": device, "scene": what.words,
             "cold": {"median": cold, "quartiles": [cold, cold]}, "stages_cold": stages_of(counted),
             "bytes": counted.GetGPUBytes(), "pixel_edge": counted.GetPixelEdge(),
             "eye_step": counted.GetEyeStep() / min(stage.mapper.GetInput().GetSpacing()),
             "light_method": LIGHT_METHODS[counted.GetLightMethod()]}
    if method.startswith("ErrorControlled"):
        known["estimated_error"] = 255 * stage.mapper.GetEstimatedError()
    return stage, image, known


def measure(what: Setting, method: str, knob: float, truth, device: str, frames: int = 5,
            dense=None) -> dict:
    """A cold frame, its errors (dense: the truth of all pixels), then frames with a moved camera."""
    stage, image, known = cold_frame(what, method, knob, device)
    if truth is not None:
        known.update(errors(image, truth))
    if dense is not None:
        known["max_error_all"] = errors(image, dense)["max_error"]
    if frames:
        known.update(moved_frames(stage, 1 if known["cold"]["median"] > SLOW else frames))
    if stage.failed:
        raise RuntimeError("the mapper refused to draw; its error is above")
    return record(**known)
