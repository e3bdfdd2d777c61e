# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A cube of fog in the paper's three modes: first intersection, distance, single scattering."""

import math

import baseline
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import (
    vtkCamera, vtkColorTransferFunction, vtkVolume, vtkVolumeProperty)

from participating_media import vtkSingleScatteringVolumeMapper

fog = vtkVolumeProperty()
opacity = vtkPiecewiseFunction()
opacity.AddPoint(0, 0)
opacity.AddPoint(1, -math.expm1(-0.08))  # extinction 8 per unit of length
fog.SetScalarOpacity(opacity)
fog.SetScalarOpacityUnitDistance(0.01)
albedo = vtkColorTransferFunction()
albedo.AddRGBPoint(1, 1, 1, 1)
fog.SetColor(albedo)

cube = baseline.voxels(
    64, lambda x, y, z: np.maximum.reduce([abs(x), abs(y), abs(z)]) < 0.3)
window = baseline.window_of(360, 120)
camera = vtkCamera()
camera.SetPosition(1.1, -1.5, 1.0)
camera.SetViewUp(0, 0, 1)
mappers = []
for column, mode in enumerate(("FirstHit", "Distance", "Radiance")):
    mapper = vtkSingleScatteringVolumeMapper()
    mapper.SetInputData(cube)
    mapper.SetIntegratorToPaper()
    getattr(mapper, f"SetOutputTo{mode}")()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(fog)
    view = baseline.view_of(window, column / 3, (column + 1) / 3)
    view.AddVolume(volume)
    view.AddLight(baseline.sun((-1, -1.5, 1.5), (1, 1, 1), 16))
    view.SetActiveCamera(camera)
    view.ResetCameraClippingRange()
    mappers.append(mapper)


def exchange():
    mappers[0].SetOutputToDistance()
    mappers[1].SetOutputToFirstHit()


baseline.compare(window, "first intersection and distance exchanged", exchange)
