# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page about time and error, from the numbers of one run."""

import math
import sys

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
        error = "–" if r["max_error"] is None else f"{r['max_error']:.2f}"
        estimate = "–" if r["estimated_error"] is None else f"{r['estimated_error']:.2f}"
        rows.append([r["field"], r["method"], *cells, taps, rate, size, r["light_method"] or "–",
                     "–" if r["pixel_edge"] is None else f"{r['pixel_edge']:g}", error, estimate])
    return table(["field", "method", "cold", "light moved", "light dragged", "camera moved", "10⁶ taps",
                  "10⁶ taps/s", "bytes a voxel", "light", "pixel edge", "largest error", "estimated"],
                 rows)


def stage_table(result: dict) -> str:
    rows = []
    for r in result["large"]:
        for words, key in (("cold", "stages_cold"), ("light moved", "stages_light")):
            if r[key]:
                rows.append([r["field"], r["method"], words,
                             *(f"{r[key][stage]:.0f}" for stage in (*WORDS, "frame"))])
    return table(["field", "method", "frame", *WORDS.values(), "all"], rows)


def full_part(options, result: dict) -> str:
    full = result.get("full")
    if not full:
        return ""
    sizes = full["sizes"]
    curves = {f"{field}, {key}": found[key] for field, found in sizes.items()
              for key in ("camera", "build")}
    plot_sizes(options.images / "performance-sizes.png", next(iter(sizes.values()))["sizes"], curves)
    skipped = "".join(f"\nLeft out: {name}: {why}.\n" for name, why in full["skipped"].items())
    return f"""## Other scenes, and other renderers

{point_table(full["records"])}
{skipped}
## Cost against the volume's size

N³ voxels, 256 × 256 pixels: a frame with a moved camera, and the build of a moved light's cache.

![Milliseconds against N](images/performance-sizes.png)
"""


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
window: upload, bricks, caches, programs and the step. Errors are of float images against
vtkSingleScatteringReference, in 1/255 of the peak radiance, over every {result["reference_stride"]}th pixel along each axis
(every 32nd at 256³). **No cache** is ErrorControlled that marches its light rays: the paper repaired, with midpoint steps
and empty space leapt. **Paper** is compared with the homogeneous medium that it models.

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

Where a frame's milliseconds go:

{stage_table(result)}

{full_part(options, result)}""", encoding="utf-8")
