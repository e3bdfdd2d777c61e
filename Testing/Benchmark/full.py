# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the full run adds: other scenes, Exact, the paper and other renderers at the sizes that count, the
processor's builds, and the cost against the volume's size."""

import builds
import large
import numpy as np
import peers
import repaired
import variants
from page import slope
from points import errors, measure, setting, truth_of

SIZES = (64, 128, 256)
#: Of the pictures of all sizes; with 128³ voxels it is what Mitsuba is compared at.
SIZES_PIXELS = 256
CONTROLLED = (("ErrorControlled", (4, 1, 0.25)),)
AT_ONE = (("ErrorControlled", (1,)),)
NO_CACHE = "ErrorControlled, no cache"
#: What Mitsuba draws, whose time hardly depends on it.
CLOUDS = ("faded-cloud", "cloud")


def cost_against_size(options) -> tuple:
    """Milliseconds with a moved camera, of building a moved light's cache, final and dragged, and their
    slopes; and the records."""
    found, records = {}, []
    for field in options.progress(options.fields, "sizes"):
        points = [large.controlled(setting(field, n, SIZES_PIXELS), options.device, options.frames)
                  for n in SIZES]
        records += points
        costs = {"camera": [p["camera_moved"]["median"] for p in points],
                 "build": [p["stages_light"]["build"] for p in points],
                 "dragged": [p["stages_dragged"]["build"] for p in points]}
        slopes = {f"{name}_slope": slope(SIZES, np.maximum(spent, 1e-3))
                  for name, spent in costs.items()}
        found[field] = {"sizes": list(SIZES), **costs, **slopes}
    return found, records


def exact(options) -> list:
    records = []
    for field in options.progress(options.fields, "Exact"):
        what = setting(field, 64, 128)
        truth = truth_of(what, options.stride, 1e-5)
        records.append(measure(what, "Exact", 0, truth, options.device, frames=2))
    return records


def other_scenes(options, sweep) -> tuple:
    """Records, and why there is no CT."""
    records = []
    for field in options.progress(options.fields, "variants"):
        for what in variants.swept(field):
            records += sweep(what, CONTROLLED, options)
        for what in variants.tried(field):
            records += sweep(what, AT_ONE, options)
    head, why = variants.ct()
    if head is not None:
        records += sweep(head, CONTROLLED, options)
    return records, why


def small_scattering(options, sweep) -> tuple:
    """VTK's own scattering at 64³, on the cube and in boxes that are none, and ours in these."""
    records, why = [], ""
    cube = setting("cloud", 64, 128)
    for what in options.progress([cube, *variants.flat_boxes()], "VTK scattering"):
        found, why = peers.vtk_scattering(what, peers.SMALL_STEPS, truth_of(what, 1, 1e-5))
        records += found
        if what is not cube:
            records += sweep(what, CONTROLLED, options)
    return records, why


def large_scattering(options, dense: dict) -> tuple:
    """VTK's own scattering at 256³, 512²; its errors are over all pixels."""
    records, why = [], ""
    for field in options.progress(options.fields, "VTK scattering, 256³"):
        found, why = peers.vtk_scattering(setting(field, 256, 512), peers.LARGE_STEPS, dense[field],
                                          dense[field])
        records += found
    return records, why


def without_caches(field: str, options, dense) -> dict:
    """ErrorControlled that marches its light rays, at 256³, 512²; its errors are over all pixels."""
    found, image = repaired.timed(setting(field, 256, 512), NO_CACHE, 1, options.device, options.frames)
    return {**found, **errors(image, dense)}


def mitsuba(options) -> tuple:
    records, why = [], ""
    for field in options.progress(CLOUDS, "Mitsuba"):
        what = setting(field, 128, SIZES_PIXELS)
        found, why = peers.mitsuba(what, truth_of(what, options.stride, 1e-5))
        records += found
    return records, why


def measure_all(options, sweep, dense: dict) -> dict:
    """dense: the truth of all pixels at 256³, by field. Each part says how long it took."""
    full, skipped = {"records": exact(options)}, {}
    for part in (other_scenes, small_scattering):
        found, why = part(options, sweep)
        full["records"] += found
        if why:
            skipped["CT" if part is other_scenes else "VTK scattering"] = why
        options.done(part.__name__)
    full["scattering_large"], _ = large_scattering(options, dense)
    options.done("large_scattering")
    full["mitsuba"], why = mitsuba(options)
    if why:
        skipped["Mitsuba"] = why
    options.done("mitsuba")
    full["paper_large"] = repaired.paper(setting("binary", 256, 512), options.device, large.STRIDE,
                                         options.frames)
    options.done("the paper")
    full["no_cache_large"] = [without_caches(field, options, dense[field]) for field in options.fields]
    options.done("without caches")
    full["sizes"], full["sizes_records"] = cost_against_size(options)
    options.done("sizes")
    full["builds"], why = builds.measure()
    if why:
        skipped["Google Benchmark"] = why
    options.done("builds")
    return {**full, "skipped": skipped}
