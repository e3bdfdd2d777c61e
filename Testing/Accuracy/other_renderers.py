# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The same scenes by renderers that others wrote; their pictures are those of Testing/Reference."""

import closed_forms
import numpy as np
from mapper import Stage
from page import plot_pictures, table
from scenes import MITSUBA, OPENVDB, RESULTS, VTK, read_result
from test_independent_renderers import (
    BIAS,
    STEP,
    blocks_of,
    images_of,
    largest_chi_square,
    relative_rmse,
    scaled_to,
)


def chi_square(image, samples, error) -> str:
    """Of the 4 x 4-pixel blocks, and the largest that is accepted."""
    variance = blocks_of(error ** 2) / 16 + (BIAS * blocks_of(samples)) ** 2
    lit = blocks_of(samples) > BIAS * samples.max()
    value = ((blocks_of(image) - blocks_of(samples))[lit] ** 2 / variance[lit]).sum()
    return f"{value:.0f} (≤ {largest_chi_square(int(lit.sum())):.0f})"


def mitsuba_rows(options) -> list:
    rows = []
    for scene in options.progress(MITSUBA, "Mitsuba"):
        stage = Stage(scene)
        for stage.channel, ending in scene.channels().items():
            _, samples, error = read_result(RESULTS / f"mitsuba-{scene.name}{ending}.csv")
            spread = np.sqrt((error ** 2).sum()) / error.size / samples.mean()
            images = images_of(stage)
            rows.append([scene.name + ending, f"±{spread:.1e}",
                         *(f"{image.mean() / samples.mean() - 1:+.1e}" for image in images.values()),
                         *(chi_square(image, samples, error) for image in images.values())])
    return rows


def uniform_against_formula() -> str:
    """Mitsuba and the reference against form A."""
    scene = next(s for s in MITSUBA if s.name == "uniform")
    _, samples, _ = read_result(RESULTS / f"mitsuba-{scene.name}.csv")
    origin, direction = closed_forms.rays(scene)
    to_light = np.array(scene.light) / np.linalg.norm(scene.light)
    truth = closed_forms.box_radiance(origin, direction, np.array(scene.size), to_light,
                                      scene.extinction)
    truth *= closed_forms.henyey_greenstein(direction @ to_light, scene.g)
    return (f"{samples.mean() / truth.mean() - 1:+.1e} (Mitsuba) and "
            f"{Stage(scene).reference().mean() / truth.mean() - 1:+.1e} (reference)")


def openvdb_rows(options) -> list:
    rows = []
    for scene in options.progress(OPENVDB, "OpenVDB"):
        _, theirs, _ = read_result(RESULTS / f"openvdb-{scene.name}.csv")
        images = images_of(Stage(scene))
        truth = images["reference"]
        scale = (theirs * truth).sum() / (theirs ** 2).sum()
        rows.append([scene.name, f"{scale:.4f}",
                     *(f"{100 * relative_rmse(scaled_to(theirs, image), image):.2f} %"
                       for image in images.values())])
    return rows


def pictures(options) -> None:
    scene = next(s for s in MITSUBA if s.name == "cloud-flat-box")
    _, samples, _ = read_result(RESULTS / f"mitsuba-{scene.name}.csv")
    ours = Stage(scene).fixed_step(STEP)
    peak = ours.max()
    sideways = next(s for s in VTK if s.name == "vtk-flat-box-along-x")
    _, vtk, _ = read_result(RESULTS / f"{sideways.name}.csv")
    truth = Stage(sideways).reference()
    most = max(truth.max(), vtk.max())
    plot_pictures(options.images / "accuracy-renderers.png", [
        ("FixedStep", ours, 0, peak), ("Mitsuba", samples, 0, peak),
        ("difference × 50", 50 * (ours - samples), -peak, peak),
        ("light along x: reference", truth, 0, most), ("VTK's scattering", vtk, 0, most),
        ("difference × 1", vtk - truth, -most, most)])


def measure(options) -> str:
    mitsuba, _, _ = read_result(RESULTS / f"mitsuba-{MITSUBA[0].name}.csv")
    openvdb, _, _ = read_result(RESULTS / f"openvdb-{OPENVDB[0].name}.csv")
    pictures(options)
    return f"""## Other people's renderers

Pictures of the same grids, lights and cameras, 32 × 32 pixels through pixel centres, kept in
Testing/Reference/Results with the command of each; Testing/Reference/README.md says how they are made.
FixedStep has steps of {STEP:g} voxels here.

**{mitsuba['renderer']}**, {mitsuba['samples per pixel']} samples per pixel, {mitsuba['date']}. The mean
of the picture against Mitsuba's, Mitsuba's own standard error, and chi-square over blocks of 4 × 4
pixels with the largest value accepted at 99.9 %. The test allows 3 standard errors and {BIAS:g} of the
mean, because Mitsuba's own sums are off by more than their noise: in the homogeneous box, where form A
is the truth, the means are {uniform_against_formula()} beside it. The last scene's extinction has a
colour; Mitsuba rendered it by volpathmis.

{table(["scene", "Mitsuba's standard error", "reference: mean", "FixedStep: mean", "Exact: mean",
        "reference: chi-square", "FixedStep: chi-square", "Exact: chi-square"], mitsuba_rows(options))}

**{openvdb['renderer']}**, {openvdb['date']}, isotropic, steps of a sixteenth of a voxel: relative RMS
difference after one scale for the picture, which would be 1 if its steps were infinitely fine. At most
2 % is accepted.

{table(["scene", "scale", "reference", "FixedStep", "Exact"], openvdb_rows(options))}

![Pictures and their differences](images/accuracy-renderers.png)
"""
