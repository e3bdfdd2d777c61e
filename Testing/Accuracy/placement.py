# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Whether the error depends on the shape of the voxels, or on how the volume is placed."""

from dataclasses import replace

import numpy as np
from mapper import Stage
from page import largest_error, table
from scenes import RESULTS, VTK, Scene, read_result
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform

CUBE = Scene("placement", "cloud", 20, 0.6, (-0.6, 0.7, 0.3))


def turned() -> vtkMatrix4x4:
    transform = vtkTransform()
    transform.RotateWXYZ(50, 1, 0.7, -0.4)
    return transform.GetMatrix()


def sheared() -> vtkMatrix4x4:
    matrix = vtkMatrix4x4()
    matrix.SetElement(0, 1, 0.5)
    matrix.SetElement(2, 0, -0.3)
    return matrix


def mirrored() -> vtkMatrix4x4:
    matrix = vtkMatrix4x4()
    matrix.SetElement(0, 0, -1)
    return matrix


def by_the_mapper(options) -> list:
    flat = (1, 0.7, 0.4)
    places = (("unit cube", {}, None), ("box 1 × 0.7 × 0.4", {"size": flat}, None),
              ("box 1 × 0.3 × 0.1", {"size": (1, 0.3, 0.1)}, None),
              ("unit cube, rotated", {}, turned()), ("unit cube, sheared", {}, sheared()),
              ("unit cube, mirrored", {}, mirrored()),
              ("box 1 × 0.7 × 0.4, rotated", {"size": flat}, turned()))
    rows = []
    for words, changes, matrix in options.progress(places, "placements"):
        # The same optical depth along the shortest edge, so that the boxes are alike to the light.
        sigma = CUBE.extinction / min(changes.get("size", (1,)))
        stage = Stage(replace(CUBE, pixels=options.pixels, extinction=sigma, **changes))
        if matrix:
            stage.volume.SetUserMatrix(matrix)
        truth = stage.reference()
        rows.append([words, largest_error(stage.fixed_step(1), truth),
                     largest_error(stage.fixed_step(0.5), truth),
                     largest_error(stage.exact(), truth)])
    return rows


def by_vtk(options) -> list:
    """VTK's own scattering: its error, and its brightness against the truth where that is bright."""
    rows = []
    for scene in options.progress(VTK, "VTK's own scattering"):
        _, image, change = read_result(RESULTS / f"{scene.name}.csv")
        truth = Stage(scene).reference()
        scale = (image * truth).sum() / (image ** 2).sum()
        ratio = (image / np.where(truth > 0, truth, 1))[truth > 0.1 * truth.max()]
        rows.append([scene.name.replace("vtk-", "").replace("-", " "),
                     f"{ratio.min():.2f} … {np.median(ratio):.2f} … {ratio.max():.2f}",
                     largest_error(scale * image, truth), float(change.max() / image.max())])
    return rows


def measure(options) -> str:
    own = table(["volume", "FixedStep, 1 voxel", "FixedStep, ½ voxel", "Exact"],
                by_the_mapper(options))
    head, _, _ = read_result(RESULTS / f"{VTK[0].name}.csv")
    vtk = table(["volume, light", "radiance ÷ truth: least … median … largest",
                 "largest error after the best scale", "change from twice the step"],
                by_vtk(options))
    return f"""## Voxels that are not cubes, and volumes that are turned

The cloud in each of these placements, 32³ points; its extinction is scaled so that the shortest edge
has the same optical depth. Largest error as a fraction of the peak, against the reference; the step is
in voxels, of the shortest edge.

{own}

VTK's own volumetric scattering on the cloud ({head['renderer']}; {head['date']}, by
`{head['command']}`), against the reference, 32 × 32 pixels. It is right in a cube, to first order in
its step; in a flat box it measures the way to the light and the angle of scattering in texture
coordinates, and no step mends that.

{vtk}
"""
