# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page about time and error, from the numbers of one run."""

import math
import sys

import builds
import peers
import repaired
import variants
from page import table
from points import SLOW
from ratios import BASE, plot_errors, plot_sizes, point_table, ratio_table
from targets import WORDS, target_table

METHODS = ("FixedStep", BASE, "ErrorControlled, no cache", "Paper")


def cost_table(result: dict) -> str:
    rows = []
    for r in result["large"]:
        cells = [f"{r[cost]['median']:.0f} ({r[cost]['quartiles'][0]:.0f}–{r[cost]['quartiles'][1]:.0f})"
                 if r[cost] else "–"
                 for cost in ("cold", "light_changed", "light_dragged", "camera_moved")]
        taps = f"{r['taps'] / 1e6:.2f}" if r["taps"] else "–"
        rate = f"{r['taps'] / r['camera_moved']['median'] / 1000:.0f}" if r["taps"] else "–"
        size = f"{r['bytes'] / math.prod(r['volume']):.1f}" if r["bytes"] else "–"
        error, everywhere, estimate = ("–" if r[key] is None else f"{r[key]:.2f}" for key in (
            "max_error", "max_error_all", "estimated_error"))
        rows.append([r["field"], r["method"], *cells, taps, rate, size, r["light_method"] or "–",
                     "–" if r["pixel_edge"] is None else f"{r['pixel_edge']:g}",
                     "–" if r["eye_step"] is None else f"{r['eye_step']:.2g}", error, everywhere,
                     estimate])
    return table(["field", "method", "cold", "light moved", "light dragged", "camera moved", "10⁶ taps",
                  "10⁶ taps/s", "bytes a voxel", "light", "pixel edge", "eye step", "largest error",
                  "of all pixels", "estimated"], rows)


def stage_table(result: dict) -> str:
    rows = []
    for r in result["large"]:
        for words, key in (("cold", "stages_cold"), ("light moved", "stages_light"),
                           ("light dragged", "stages_dragged")):
            if r[key]:
                rows.append([r["field"], r["method"], words,
                             *(f"{r[key][stage]:.0f}" for stage in (*WORDS, "frame"))])
    return table(["field", "method", "frame", *WORDS.values(), "all"], rows)


def flat_table(records: list) -> str:
    """Errors in a box that is no cube: VTK's own scattering by its step, ours by what is allowed."""
    rows = []
    for words in variants.FLAT_LIGHTS:
        scene = f"{variants.FLAT_WORDS}, light {words}"
        errors = {(r["method"], r["knob"]): f"{r['max_error']:.2f}" for r in records
                  if r["scene"] == scene}
        rows.append([words, *(errors.get(("VTK scattering", step), "–") for step in peers.SMALL_STEPS),
                     *(errors.get((BASE, allowed), "–") for allowed in (4, 1, 0.25))])
    return table(["light", *(f"VTK, {step:g} voxel" for step in peers.SMALL_STEPS),
                  "ours, 4/255 allowed", "1/255", "0.25/255"], rows)


def method_words(record: dict) -> str:
    """Others say which version they are."""
    method = record["method"]
    return f"{method}, {record['device']}" if method in ("VTK scattering", "Mitsuba") else method


def others_table(full: dict) -> str:
    records = [*full["fixed_large"], *full["no_cache_large"], *full["paper_large"],
               *full["scattering_large"], *full["mitsuba"]]
    return table(["field", "method", "voxels", "pixels", "knob", "largest error", "relative RMSE", "ms"], [
        [r["field"], method_words(r), f"{r['volume'][0]}³", f"{r['image'][0]}²", f"{r['knob']:g}",
         "–" if r["max_error"] is None else f"{r['max_error']:.2f}",
         r["relative_rmse"] or "–", f"{r['camera_moved']['median']:.0f}"] for r in records])


def fixed_words(result: dict) -> str:
    left = ", ".join(f"{facts['dense_error']:.2f} ({field})"
                     for field, facts in result["facts"].items())
    return (f"FixedStep's steps are halved from {repaired.FIXED_STEPS[0]:g} voxels on until by the last "
            f"halving less than {repaired.LEFT:g}/255 is left of its error, or they are a quarter of a "
            "voxel. That image is the truth of **all pixels**; what is left of its error, in 1/255: "
            f"{left}, which is also its own row's largest error below.")


def full_part(options, result: dict) -> str:
    full = result.get("full")
    if not full:
        return ""
    sizes = full["sizes"]
    curves = {f"{field}, {words}": found[key] for field, found in sizes.items()
              for key, words in (("camera", "camera"), ("build", "final"), ("dragged", "dragged"))}
    plot_sizes(options.images / "performance-sizes.png", next(iter(sizes.values()))["sizes"], curves)
    skipped = "".join(f"\nLeft out: {name}: {why}.\n" for name, why in full["skipped"].items())
    built = builds.build_table(full["builds"]) if full["builds"] else ""
    return f"""## The paper and other renderers at the sizes that count

{fixed_words(result)} **FixedStep** marches its light rays in the same step as its eye rays and skips no empty
space. At the longest step that keeps 1/255 it is the paper with midpoint steps and energy-conserving
segments, but without empty space skipped. **No cache**, ErrorControlled without light caches, skips it, but has
more of ours: steps found for its error, which grow behind what hides them. The paper repaired lies between
the two.

**VTK scattering** is VTK's own (`SetVolumetricScatteringBlending(2)`, `SetGlobalIlluminationReach(1)`), its
brightness fitted to the truth in its favour. Steps of less than a voxel at 256³ end in llvmpipe's limit of loops, so
that {", ".join(f"{step:g}" for step in peers.LARGE_STEPS)} voxels give its slope. **Mitsuba** is `volpath` with
`max_depth=2`; its knob is samples of a pixel. A frame that takes over {SLOW / 1000:g} s was timed once; of the paper, FixedStep and
No cache it is then the time that integrating took.

{others_table(full)}

VTK's own scattering in a box that is no cube, at 64³ voxels; largest errors:

{flat_table(full["records"])}

## Other scenes

64³ voxels and 128 × 128 pixels, but for the CT.

{point_table(full["records"])}
{skipped}
## Cost against the volume's size

N³ voxels, {full["sizes_records"][0]["image"][0]} × {full["sizes_records"][0]["image"][0]} pixels: a frame with a moved camera, and the build of a moved light's cache, final and while
it is dragged.

![Milliseconds against N](images/performance-sizes.png)

What the processor builds, by Google Benchmark, wall-clock medians of three. A point light stands beside the cube or
inside of it; a dragged light's cache has half the points along each axis.

{built}
"""


FIELDS = """The fields: **smooth** is a sum of Gaussians, nothing of it empty; **faded-cloud** is fractal noise above a
threshold that fades to 0 towards a ball, so that all its slopes are finite, as in the experiment that the
targets come from; **cloud** is the same noise cut off at the ball, where it jumps as masked scans do; **binary** is 0 or 1. Both
clouds are here because jumps decide what an error costs: at steps of two voxels (256³) the faded one errs
by about 1/255, the one with a jump by about 15/255."""


def write(options, result: dict) -> None:
    fields = tuple(result["facts"])
    for cost, words in (("camera_moved", "ms, camera moved"), ("taps", "taps")):
        plot_errors(options.images / f"performance-error-{cost.replace('_', '-')}.png",
                    result["small"], METHODS, fields, cost, words)
    command = " ".join(["Testing/Benchmark/run", *sys.argv[1:]]) if "--output" not in sys.argv \
        else "Testing/Benchmark/run" + (" --quick" if result["quick"] else "")
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_text(f"""# How fast it is at a stated error

Made on {result["date"]} by `{command}` in {result["seconds"]} s, with VTK {result["vtk"]}, {result["device"]} and
{result["cores"]} cores. Every number and plot is of that run.

A directional light at an elevation of 45°, a unit cube, isotropic scattering, albedo 1, perspective, 32-bit data; early
termination off. Times are wall-clock milliseconds up to the driver's completion, medians of {options.frames} frames (of one,
where the cold frame took over {SLOW / 1000:g} s), each with the camera (or the light) moved a little; in brackets the quartiles. A cold frame is the first of a
window: upload, bricks, caches, programs and the step.

{FIELDS}

Errors are of float images against
vtkSingleScatteringReference, in 1/255 of the peak radiance, over one pixel in {result["reference_stride"]} along each axis
(in 32 at 256³; full runs add the largest of all pixels there). **No cache** is ErrorControlled that marches its light rays, empty space
leapt. **Paper** is compared with the homogeneous medium that it models. What was tried, and what of it paid, is on
[a page of its own](what-pays.md).

## Targets

At 256³ voxels, 512 × 512 pixels, where nothing else is said.

{target_table(result)}

## Time at equal error

64³ voxels, 128 × 128 pixels; how many times the milliseconds of ErrorControlled. ~: beyond the measured
points, along their slope, or a coarsest setting that is better than asked for.

{ratio_table(result["small"], METHODS, fields)}

![Error against time](images/performance-error-camera-moved.png)

![Error against taps](images/performance-error-taps.png)

{point_table(result["small"])}

## Large volumes

256³ voxels, 512 × 512 pixels; ErrorControlled at 1/255, the others at steps of one voxel. Milliseconds. Bytes are of
32-bit data and contain the frame's targets. The composite mapper is VTK's own, shaded, without shadows.

{cost_table(result)}

A bare loop, FixedStep's optical depth, is timed in steps as long as ErrorControlled's (eye step, voxels), since longer
steps find less in the processor's caches. Where a frame's milliseconds go:

{stage_table(result)}

{full_part(options, result)}""", encoding="utf-8")
