# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The medium is a vtkParticipatingMedium: extinction from one array, albedo (RGB) from another."""

import baseline
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkRenderingCore import vtkVolume

from participating_media import vtkParticipatingMedium, vtkSingleScatteringVolumeMapper

POINTS = 48


def plume(x, y, z):
    """A column of smoke that winds upwards and widens."""
    turn = 9 * z
    width = 0.09 + 0.1 * (z + 0.5)
    away = (x - 0.14 * np.cos(turn)) ** 2 + (y - 0.14 * np.sin(turn)) ** 2
    return np.exp(-away / (2 * (0.6 * width) ** 2)) * np.clip(4 * (0.5 - abs(z)), 0, 1)


image = baseline.voxels(POINTS, plume)
albedo = vtkFloatArray()
albedo.SetName("albedo")
albedo.SetNumberOfComponents(3)
albedo.SetNumberOfTuples(POINTS ** 3)
height = np.repeat(np.linspace(0, 1, POINTS), POINTS ** 2)[:, None]
vtk_to_numpy(albedo)[:] = (1 - height) * (1.0, 0.45, 0.2) + height * (0.75, 0.8, 0.9)
image.GetPointData().AddArray(albedo)

medium = vtkParticipatingMedium()
medium.SetExtinctionArrayName("density")
medium.SetExtinctionScale(14)
medium.SetAlbedoArrayName("albedo")
mapper = vtkSingleScatteringVolumeMapper()
mapper.SetIntegratorToFixedStep()
mapper.SetInputData(image)
mapper.SetMedium(medium)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetInterpolationTypeToLinear()
window = baseline.window_of(200, 240)
view = baseline.view_of(window)
view.AddVolume(volume)
view.AddLight(baseline.sun((-3, -1.5, 1), (1, 1, 1), 20))
view.GetActiveCamera().SetPosition(0, -3, 0.6)
view.GetActiveCamera().SetViewUp(0, 0, 1)
view.ResetCamera()
view.GetActiveCamera().Zoom(1.5)

baseline.compare(window, "the albedo of one of its components",
                 lambda: medium.SetAlbedoComponent(2))
