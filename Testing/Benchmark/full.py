# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the full run adds: other boxes, phase functions and lights, a real CT, Exact, other renderers, and
the cost against the volume's size."""

import large
import numpy as np
import peers
from cranium import read_cranium
from page import slope
from points import measure, setting, truth_of
from vtkmodules.util.numpy_support import vtk_to_numpy

from participating_media.readers import UnreadableVolume

SIZES = (64, 128, 256)
CONTROLLED = (("ErrorControlled", (4, 1, 0.25)),)
#: Three more lights of four: above, from behind and grazing.
MORE_LIGHTS = ((0, 1, 0.2), (-0.7, 0.4, -1), (1, 0.1, -0.3))
#: HU at which the CT's extinction begins and where it is largest.
SOFT_TISSUE, BONE = 100, 1500


def scenes(field: str) -> list:
    """The variants, each with the words for the page."""
    flat = {"size": (1, 0.7, 0.4), "words": "1 × 0.7 × 0.4 box, g = 0.6", "g": 0.6}
    return [setting(field, 64, 128, **flat),
            setting(field, 64, 128, g=0.6, words="cube, g = 0.6"),
            setting(field, 64, 128, g=-0.4, words="cube, g = −0.4"),
            setting(field, 64, 128, more_lights=MORE_LIGHTS, words="cube, four lights")]


def ct(pixels: int = 128):
    """The head, its extinction a straight line in HU; None and why where it isn't installed."""
    try:
        image = read_cranium()
    except UnreadableVolume as reason:
        return None, str(reason).rpartition("; ")[2]
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
    grid = np.clip((values.astype(np.float32) - SOFT_TISSUE) / (BONE - SOFT_TISSUE), 0, 1)
    edges = (np.array(image.GetDimensions()) - 1) * np.array(image.GetSpacing())
    return setting("CT", max(image.GetDimensions()), pixels, grid=grid, words="CT of a head",
                   size=tuple(edges / edges.max())), ""


def cost_against_size(options) -> dict:
    """Milliseconds with a moved camera, of building a moved light's cache, and their slopes."""
    found = {}
    for field in options.progress(("smooth", "cloud", "binary"), "sizes"):
        points = [large.controlled(setting(field, n, 256), options.device, options.frames, 32)
                  for n in SIZES]
        camera = [p["camera_moved"]["median"] for p in points]
        build = [p["stages_light"]["build"] for p in points]
        found[field] = {"camera": camera, "build": build, "camera_slope": slope(SIZES, camera),
                        "build_slope": slope(SIZES, np.maximum(build, 1e-3)),
                        "sizes": list(SIZES)}
    return found


def exact(options) -> list:
    records = []
    for field in options.progress(("smooth", "cloud", "binary"), "Exact"):
        what = setting(field, 64, 128)
        truth = truth_of(what, options.stride, 1e-5)
        records.append(measure(what, "Exact", 0, truth, options.device, frames=2))
    return records


def measure_all(options, sweep) -> dict:
    records, skipped = exact(options), {}
    for field in options.progress(("smooth", "cloud", "binary"), "variants"):
        for what in scenes(field):
            records += sweep(what, CONTROLLED, options)
    head, reason = ct()
    if head is None:
        skipped["CT"] = reason
    else:
        records += sweep(head, CONTROLLED, options)
    cube, flat = setting("cloud", 64, 128), scenes("cloud")[0]
    for what in (cube, flat):
        found, reason = peers.vtk_scattering(what, options.device, truth_of(what, 1, 1e-5))
        records += found
        if reason:
            skipped["VTK scattering"] = reason
    found, reason = peers.mitsuba(cube, truth_of(cube, 1, 1e-5))
    records += found
    if reason:
        skipped["Mitsuba"] = reason
    repaired = [measure(setting(field, 256, 512), "ErrorControlled, no cache", 1, None,
                        options.device, frames=0) for field in ("smooth", "cloud", "binary")]
    return {"records": records, "skipped": skipped, "sizes": cost_against_size(options),
            "repaired_large": repaired}
