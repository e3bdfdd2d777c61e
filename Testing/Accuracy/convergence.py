# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""How the error falls with the step."""

from against_closed_forms import paper_stage, step_at
from mapper import Stage
from page import largest_error, mean_error, plot_convergence, slope, table
from scenes import Scene, grid_of

STEPS = (2, 1, 0.5, 0.25, 0.125)
#: Steps through which the slope is taken: those that resolve the voxels.
FITTED = slice(1, None)
#: The level of the smooth field at which Paper's medium begins.
THRESHOLD = 0.3
#: Accuracy of the truth, as a fraction of the peak: far below the smallest error here.
TOLERANCE = 1e-7


def fixed_step(options, field: str) -> dict:
    scene = Scene(field, field, 20 if field == "cloud" else 8, 0.6, (0.5, 1, 0.8),
                  pixels=options.pixels)
    stage = Stage(scene)
    truth = stage.reference(TOLERANCE)
    images = [stage.fixed_step(step) for step in options.progress(STEPS, field)]
    return {"largest": [largest_error(image, truth) for image in images],
            "mean": [mean_error(image, truth) for image in images],
            "exact": largest_error(stage.exact(), truth)}


def paper(options) -> dict:
    """Paper's medium is homogeneous above a level of the smooth field; the truth has it as a step of
    the extinction's function."""
    scene = Scene("paper", "smooth", 8, 0, (0.5, 1, 0.8), pixels=options.pixels)
    grid = grid_of(scene)
    stage = Stage(scene, grid)
    stage.medium.SetExtinctionScale(1)
    stage.medium.SetExtinctionFunction(step_at(THRESHOLD, scene.extinction, 1))
    truth = stage.reference(1e-5)
    drawn = paper_stage(scene, grid)
    images = [drawn.paper(step, THRESHOLD) for step in options.progress(STEPS, "Paper")]
    return {"largest": [largest_error(image, truth) for image in images],
            "mean": [mean_error(image, truth) for image in images]}


def measure(options) -> str:
    fields = {field: fixed_step(options, field) for field in ("smooth", "cloud", "binary")}
    by_paper = paper(options)
    rows, panels = [], []
    for name, errors in [*fields.items(), ("Paper, smooth field above a level", by_paper)]:
        rows.append([name, *errors["largest"], f"{slope(STEPS[FITTED], errors['largest'][FITTED]):.2f}",
                     f"{slope(STEPS[FITTED], errors['mean'][FITTED]):.2f}",
                     errors.get("exact", "–")])
        panels.append((name, {"largest": (STEPS, errors["largest"]),
                              "mean": (STEPS, errors["mean"])}))
    plot_convergence(options.images / "accuracy-convergence.png", panels)
    head = ["field", *(f"{step:g}" for step in STEPS), "slope of the largest", "slope of the mean",
            "Exact"]
    return f"""## Convergence

FixedStep on the three test fields, 32³ points, g = 0.6, one directional light; Paper on a homogeneous
medium above a level of the smooth field, without jitter. Columns are steps of both rays, in voxels;
errors are the largest over {options.pixels} × {options.pixels} pixels, as a fraction of the peak,
against the reference at a tolerance of {TOLERANCE:g} (Paper: 1e-5). Slopes are of log error against log
step, from 1 voxel down.

{table(head, rows)}

![Error against step](images/accuracy-convergence.png)

*Dotted and dashed: first and second order. Horizontal: 1/255.*

Theory: nested midpoint rules are of second order as long as the field has bounded second derivatives
inside the step. Interpolated data has kinks at every cell face, which cost a midpoint rule h² times the
jump of the derivative: small where neighbouring cells have similar slopes (smooth), large where a field
jumps from 0 to 1 within a voxel (binary). Where the kinks fall relative to the samples is a matter of
chance from step to step, so the largest error of rough fields falls by steps rather than along a line,
and its slope scatters about 2. Paper's left Riemann sums are of first order; in addition its linear
search misses what is thinner than a step, which the largest error shows.
"""
