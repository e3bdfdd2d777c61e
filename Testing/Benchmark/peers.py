# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The same picture by what others wrote. Each returns records, or says why it was left out."""

import importlib.util
import os
import time

import render_vtk
from points import errors, moved_camera, record, times_of
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

#: Paths of each pixel, and the relative RMSE that their time is told for.
SAMPLES, RMSE = 256, 0.01


def point(what, method: str, knob: float, device: str, image, truth, **costs) -> dict:
    return record(method=method, field=what.scene.grid, knob=knob, device=device, scene=what.words,
                  volume=list(what.values().shape[::-1]), image=[what.scene.pixels] * 2,
                  **errors(image, truth), **costs)


def vtk_scattering(what, device: str, truth, steps=(1, 0.5, 0.25)) -> tuple:
    if not hasattr(vtkGPUVolumeRayCastMapper, "SetVolumetricScatteringBlending"):
        return [], f"VTK {vtkVersion.GetVTKVersion()} has no volumetric scattering (9.2 has)"
    found = []
    for step in steps:
        image = render_vtk.render(what.scene, step)
        window = render_vtk.window_of(what.scene, step, what.values())
        times_of(window, lambda: None, 1)
        moved = times_of(window, moved_camera(window.GetRenderers().GetFirstRenderer()), 3)
        found.append(point(what, "VTK scattering", step, device, image, truth, camera_moved=moved))
    return found, ""


def mitsuba(what, truth) -> tuple:
    """One run; its time at 1 % relative RMSE follows from its noise, which falls as 1/√samples."""
    if importlib.util.find_spec("mitsuba") is None:
        return [], "no Python package mitsuba is installed"
    import mitsuba as mi
    try:
        mi.set_variant("llvm_ad_rgb")
        import render_mitsuba
        start = time.perf_counter()
        image, _ = render_mitsuba.render(what.scene, SAMPLES, 1)
    except (ImportError, RuntimeError) as reason:
        return [], f"Mitsuba did not run: {reason}"
    spent = 1000 * (time.perf_counter() - start)
    found = point(what, "Mitsuba", SAMPLES, f"LLVM, {os.cpu_count()} cores", image, truth,
                  camera_moved={"median": spent, "quartiles": [spent, spent]})
    return [found], ""


def mitsuba_at_rmse(found: dict) -> float:
    """Milliseconds."""
    return found["camera_moved"]["median"] * (found["relative_rmse"] / RMSE) ** 2
