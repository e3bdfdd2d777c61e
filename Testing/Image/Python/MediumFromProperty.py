# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The medium is the volume's property: shells of the opacity function, in colours that the colour
function gives by density."""

import baseline
import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume, vtkVolumeProperty

from participating_media import vtkSingleScatteringVolumeMapper

opacity = vtkPiecewiseFunction()
for density, alpha in ((0, 0), (0.12, 0), (0.2, 0.03), (0.28, 0), (0.55, 0), (0.65, 0.5), (1, 0.5)):
    opacity.AddPoint(density, alpha)
colour = vtkColorTransferFunction()
colour.AddRGBPoint(0.2, 0.3, 0.6, 1.0)
colour.AddRGBPoint(0.6, 1.0, 0.75, 0.35)
medium = vtkVolumeProperty()
medium.SetScalarOpacity(opacity)
medium.SetColor(colour)
medium.SetScalarOpacityUnitDistance(0.02)
medium.SetInterpolationTypeToLinear()

mapper = vtkSingleScatteringVolumeMapper()
mapper.SetIntegratorToFixedStep()
mapper.SetInputData(baseline.voxels(56, lambda x, y, z: np.clip(
    1 - 2 * np.sqrt(x * x + y * y + z * z) * (1 + 0.12 * np.cos(14 * x) * np.cos(14 * y)), 0, 1)))
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(medium)
window = baseline.window_of(200, 200)
view = baseline.view_of(window)
view.AddVolume(volume)
view.AddLight(baseline.sun((-2, -2, 3), (1, 1, 1), 20))
view.GetActiveCamera().SetPosition(1, -3, 1.5)
view.GetActiveCamera().SetViewUp(0, 0, 1)
view.ResetCamera()
view.GetActiveCamera().Zoom(1.7)

baseline.compare(window, "a unit distance 4 times as long",
                 lambda: medium.SetScalarOpacityUnitDistance(0.08))
