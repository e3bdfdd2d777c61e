# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke under a mask, clipped open: what the mask leaves out lets light through."""

import baseline
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkRenderingCore import vtkVolume

from participating_media import vtkParticipatingMedium, vtkSingleScatteringVolumeMapper

POINTS = 41

image = baseline.voxels(POINTS, lambda x, y, z: 0.6 + 0.4 * np.sin(9 * x) * np.cos(7 * y))
axis = np.linspace(-0.5, 0.5, POINTS)
z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
ball = x ** 2 + y ** 2 + z ** 2 < 0.45 ** 2
shaft = (abs(x + 0.15) < 0.08) & (abs(y) < 0.2)
mask = vtkImageData()
mask.SetDimensions(POINTS, POINTS, POINTS)
mask.AllocateScalars(3, 1)  # VTK_UNSIGNED_CHAR
vtk_to_numpy(mask.GetPointData().GetScalars())[:] = (ball & ~shaft).ravel()

medium = vtkParticipatingMedium()
medium.SetExtinctionArrayName("density")
medium.SetExtinctionScale(8)
medium.SetAlbedo(1, 0.93, 0.85)
mapper = vtkSingleScatteringVolumeMapper()
mapper.SetIntegratorToFixedStep()
mapper.SetInputData(image)
mapper.SetMaskInput(mask)
mapper.SetMedium(medium)
plane = vtkPlane()
plane.SetNormal(0, 1, 0)
plane.SetOrigin(0, -0.1, 0)
mapper.AddClippingPlane(plane)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetInterpolationTypeToLinear()
window = baseline.window_of(200, 200)
view = baseline.view_of(window)
view.AddVolume(volume)
view.AddLight(baseline.sun((-0.3, -0.4, 3), (1, 1, 1), 22))
view.GetActiveCamera().SetPosition(0.8, -3, 0.7)
view.GetActiveCamera().SetFocalPoint(0, 0, 0)
view.GetActiveCamera().SetViewUp(0, 0, 1)
view.ResetCamera()
view.GetActiveCamera().Zoom(1.7)

baseline.compare(window, "no mask", lambda: mapper.SetMaskInput(None))
