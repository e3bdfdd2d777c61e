# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""How the error falls with the step."""

import numpy as np
from against_closed_forms import paper_stage, step_at
from mapper import Stage
from page import largest_error, mean_error, plot_convergence, slope, table
from scenes import Scene, grid_of

FIELDS = ("linear", "smooth", "cloud", "binary")
STEPS = (2, 1, 0.5, 0.25, 0.125)
#: Steps through which the slope is taken: those that resolve the voxels.
FITTED = slice(1, None)
#: The level of the smooth field at which Paper's medium begins.
THRESHOLD = 0.3
#: Accuracy of the truth, as a fraction of the peak: far below the smallest error here.
TOLERANCE = 1e-7


def linear_grid(points: int = 32) -> np.ndarray:
    """Density 0.1 to 1 along the box's diagonal: interpolation gives it back without a kink."""
    x = np.linspace(0, 1, points)
    sum_of_three = x[:, None, None] + x[:, None] + x
    return (0.1 + 0.3 * sum_of_three).astype(np.float32)


def fixed_step(options, field: str) -> dict:
    scene = Scene(field, field, 20 if field == "cloud" else 8, 0.6, (0.5, 1, 0.8),
                  pixels=options.pixels)
    stage = Stage(scene, linear_grid() if field == "linear" else None)
    truth = stage.reference(TOLERANCE)
    images = [stage.fixed_step(step) for step in options.progress(STEPS, field)]
    return {"largest": [largest_error(image, truth) for image in images],
            "mean": [mean_error(image, truth) for image in images],
            "exact": largest_error(stage.exact(), truth),
            "controlled": largest_error(stage.error_controlled(), truth)}


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
    fields = {field: fixed_step(options, field) for field in FIELDS}
    by_paper = paper(options)
    rows, panels = [], []
    for name, errors in [*fields.items(), ("Paper, smooth field above a level", by_paper)]:
        rows.append([name, *errors["largest"], f"{slope(STEPS[FITTED], errors['largest'][FITTED]):.2f}",
                     f"{slope(STEPS[FITTED], errors['mean'][FITTED]):.2f}",
                     errors.get("exact", "–"), errors.get("controlled", "–")])
        panels.append((name, {"largest": (STEPS, errors["largest"]),
                              "mean": (STEPS, errors["mean"])}))
    plot_convergence(options.images / "accuracy-convergence.png", panels)
    head = ["field", *(f"{step:g}" for step in STEPS), "slope of the largest", "slope of the mean",
            "Exact", "ErrorControlled"]
    return f"""## Convergence

FixedStep on a linear field and on the three test fields, 32³ points, g = 0.6, one directional light;
Paper on a homogeneous medium above a level of the smooth field, without jitter. Exact and
ErrorControlled (asked for 1/255 = 3.9e-3 of the peak) are beside them. Columns
are steps of both rays, in voxels; errors are the largest over {options.pixels} × {options.pixels} pixels, as a fraction of the peak,
against the reference at a tolerance of {TOLERANCE:g} (Paper: 1e-5). Slopes are of log error against log
step, from 1 voxel down.

{table(head, rows)}

![Error against step](images/accuracy-convergence.png)

*Dotted and dashed: first and second order. Horizontal: 1/255.*

Theory: nested midpoint rules are of second order where the field has bounded second derivatives inside
each step: the linear field, which interpolation gives back without a kink, shows it alone. Elsewhere
interpolated data has a kink at every cell face, which costs h² times the jump of the slope there, with a
factor that depends on where the samples fall beside the face. Its mean over a picture falls as h²; its
largest value is that of one unlucky pixel, and falls by uneven steps, which is why the slope of the
largest error scatters about 2 (most on the smooth field, where kinks are small and chance decides).
Exact halves a part of a cell until two combinations of its samples, which vanish for cubics and bound the
error of one kink or jump anywhere in it, are small.
Paper's left Riemann sums are of first order; what its linear search misses because it is thinner than a
step adds to the largest error.
"""
