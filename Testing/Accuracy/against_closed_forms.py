# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The reference and each integrator against formulas that share nothing with them."""

import closed_forms
import numpy as np
from mapper import Stage
from page import largest_error, table
from scenes import Scene
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction

NONE = "–"
SIGMA = 3.0
#: Points of the table that gives form D its exponential; the renderer's own has 4096 intervals.
TABLE = 4097


def paper_stage(scene: Scene, grid=None) -> Stage:
    stage = Stage(scene, grid)
    stage.medium.SetExtinctionArrayName(None)
    stage.medium.SetExtinction(scene.extinction)
    return stage


def homogeneous_box(pixels: int) -> list:
    """Form A in a box of unequal edges: forward, isotropic, and dense."""
    rows = []
    for words, sigma, g in (("g = 0.6", SIGMA, 0.6), ("isotropic", SIGMA, 0), ("dense", 40, 0)):
        scene = Scene("box", "uniform", sigma, g, (0.5, 1, 0.8), size=(1, 0.7, 0.4), points=32,
                      pixels=pixels)
        origin, direction = closed_forms.rays(scene)
        to_light = np.array(scene.light) / np.linalg.norm(scene.light)
        truth = closed_forms.box_radiance(origin, direction, np.array(scene.size), to_light, sigma)
        truth = truth * closed_forms.henyey_greenstein(direction @ to_light, g)
        stage = Stage(scene)
        paper = NONE  # has Schlick's phase function only, which is this one where g = 0
        if g == 0:
            paper = largest_error(paper_stage(scene).paper(0.25, 0.5), truth)
        rows.append([f"A. box, {words}, extinction {sigma:g}",
                     largest_error(stage.reference(1e-12), truth),
                     largest_error(stage.exact(), truth),
                     largest_error(stage.fixed_step(1), truth),
                     largest_error(stage.fixed_step(0.25), truth), paper])
    return rows


def step_at(value: float, height: float, highest: float) -> vtkPiecewiseFunction:
    """0 below a value, `height` above."""
    function = vtkPiecewiseFunction()
    for at, level in ((0, 0), (value - 1e-7, 0), (value + 1e-7, height), (highest, height)):
        function.AddPoint(at, level)
    return function


def sphere(pixels: int) -> list:
    """Form B. The grid holds the distance from the surface, which is straight lines between points
    only: that, not the integrator, is most of the error."""
    radius, points = 0.4, 64
    x = np.linspace(-0.5, 0.5, points)
    distance = np.sqrt(x[:, None, None] ** 2 + x[:, None] ** 2 + x ** 2)
    grid = np.maximum(1 - distance, 0).astype(np.float32)
    at = ((2 * np.arange(pixels) + 1) / pixels - 1) * 0.5
    away = np.hypot(at[:, None], at)
    chord = 2 * np.sqrt(np.maximum(radius ** 2 - away ** 2, 0))
    inside = away < 0.9 * radius  # at the silhouette the chord's slope is infinite
    rows = []
    for words, towards, along in (("behind", (0, 0, -1), True), ("at the camera", (0, 0, 1), False)):
        scene = Scene("sphere", "radius", SIGMA, 0, towards, points=points, pixels=pixels)
        truth = closed_forms.sphere_radiance(chord, SIGMA, along)
        stage, paper = Stage(scene, grid), paper_stage(scene, grid)
        stage.medium.SetExtinctionScale(1)
        stage.medium.SetExtinctionFunction(step_at(1 - radius, SIGMA, 1))
        for each in stage, paper:
            each.look_parallel((0, 0, -1), (0, 1, 0), 0.5)
        rows.append([f"B. sphere, light {words}",
                     *(largest_error(image, truth, inside) for image in (
                         stage.reference(1e-6), stage.exact(), stage.fixed_step(1),
                         stage.fixed_step(0.25), paper.paper(0.25, 1 - radius)))])
    return rows


def point_light(pixels: int) -> list:
    """Form C: the source is inside, so that no way crosses a face before it reaches the medium."""
    scene = Scene("point", "uniform", SIGMA, 0, (0.13, 0.07, 0.11), point_light=True, points=32,
                  pixels=pixels)
    origin, direction = closed_forms.rays(scene)
    enter, leave = closed_forms.box_interval(origin, direction, np.ones(3))
    truth = np.where(enter < leave, closed_forms.point_light_radiance(
        origin, direction, enter, leave, np.array(scene.light), SIGMA), 0)
    stage = Stage(scene)
    return [["C. point light inside", largest_error(stage.reference(1e-9), truth),
             largest_error(stage.exact(), truth), largest_error(stage.fixed_step(1), truth),
             largest_error(stage.fixed_step(0.25), truth),
             largest_error(paper_stage(scene).paper(0.25, 0.5), truth)]]


def optical_depths(pixels: int) -> list:
    """Forms D and E, as the OpticalDepth output. The grid holds the height, 0 to 1."""
    points = 32
    height = np.linspace(0, 1, points, dtype=np.float32)
    grid = np.broadcast_to(height[:, None, None], (points, points, points)).copy()
    rows = []
    for words in ("D. exponential atmosphere", "E. linear ramp"):
        scene = Scene("depth", "height", 4, 0, (0.5, 1, 0.8), points=points, pixels=pixels)
        stage = Stage(scene, grid)
        origin, direction = closed_forms.rays(scene)
        enter, leave = closed_forms.box_interval(origin, direction, np.ones(3))
        length, z = leave - enter, (origin + enter[..., None] * direction)[..., 2] + 0.5
        if words.startswith("D"):
            function = vtkPiecewiseFunction()
            function.BuildFunctionFromTable(
                0, 1, TABLE, np.exp(-np.linspace(0, 1, TABLE) / 0.25).tolist())
            stage.medium.SetExtinctionFunction(function)
            truth = 4 * closed_forms.exponential_depth(z, direction[..., 2], length, 0.25)
        else:
            truth = 4 * closed_forms.linear_depth(z, direction[..., 2], length)
        truth = np.where(enter < leave, truth, 0)
        reference = stage.truth()
        by_reference = np.zeros_like(truth)
        for index in zip(*np.nonzero(enter < leave)):
            ends = (origin[index] + t * direction[index] for t in (0, leave[index] + 1))
            by_reference[index] = reference.OpticalDepth(*(tuple(end) for end in ends))
        stage.mapper.SetOutputToOpticalDepth()
        rows.append([words, largest_error(by_reference, truth),
                     largest_error(stage.exact(), truth), largest_error(stage.fixed_step(1), truth),
                     largest_error(stage.fixed_step(0.25), truth), NONE])
    return rows


def furnace(pixels: int) -> list:
    """Form F with the light inside the medium itself: emission in proportion to extinction makes the
    radiance B (1 - T), whatever the density. Taken against the transmittance of the reference."""
    scene = Scene("furnace", "cloud", 20, 0, (0, 0, 1), albedo=0, pixels=pixels)
    stage = Stage(scene)
    stage.medium.SetEmissionArrayName("")
    stage.medium.SetEmissionScale(0.7 * scene.extinction)
    truth = 0.7 * stage.reference(1e-12, channel=3)
    return [["F. furnace, cloud", largest_error(stage.reference(1e-12), truth),
             largest_error(stage.exact(), truth), largest_error(stage.fixed_step(1), truth),
             largest_error(stage.fixed_step(0.25), truth), NONE]]


def measure(options) -> str:
    forms = (homogeneous_box, sphere, point_light, optical_depths, furnace)
    rows = [row for form in options.progress(forms, "closed forms")
            for row in form(options.pixels)]
    head = ["form", "reference", "Exact", "FixedStep, 1 voxel", "FixedStep, ¼ voxel",
            "Paper, ¼ voxel"]
    return f"""## Closed forms

Largest error over {options.pixels} × {options.pixels} pixels, as a fraction of the formula's peak.
The formulas are those of a homogeneous box (A), a sphere (B), a point light inside (C; Sun et al. 2005,
doi:10.1145/1073204.1073309), an exponential atmosphere (D) and a ramp (E), the last two as optical
depth, and a furnace (F). The sphere is drawn from a grid of distances, 64 points wide, and compared
where a ray passes the centre within 0.9 of the radius: the reference's error is that of the grid,
which is straight lines between points; FixedStep adds the width of the step in which the extinction
jumps, and Paper finds the jump by bisection. Paper has neither coefficients from arrays nor phase
functions but Schlick's, so some of its cells are empty.

{table(head, rows)}
"""
