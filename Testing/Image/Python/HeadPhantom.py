# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A head of formulas in CT numbers (HU, mm) with the preset for CT: bone under a thin fog of skin."""

import baseline
import numpy as np
from vtkmodules.vtkRenderingCore import vtkVolume

from participating_media import vtkSingleScatteringVolumeMapper
from participating_media.presets import hounsfield_property

MILLIMETRES = 200


def radius(x, y, z, centre, axes):
    """1 on an ellipsoid, less inside; lengths in mm."""
    return np.sqrt(sum(((p - c) / a) ** 2 for p, c, a in zip((x, y, z), centre, axes)))


def head(x, y, z):
    """CT numbers: air -1000, skin and fat -50, muscle 50, brain 35, bone 1200."""
    x, y, z = x * MILLIMETRES, y * MILLIMETRES, z * MILLIMETRES
    outside = radius(x, y, z, (0, 0, 0), (72, 90, 95))
    hu = np.where(outside < 1, -50.0, -1000.0)
    hu[outside < 0.94] = 50
    hu[(outside < 0.88) & (z > -60)] = 1200
    hu[radius(x, y, z, (0, 4, 10), (58, 70, 72)) < 1] = 35
    for side in (-1, 1):  # eyes, and the sockets around them
        hu[radius(x, y, z, (side * 30, -72, 8), (20, 26, 18)) < 1] = 20
    hu[radius(x, y, z, (0, -80, -22), (11, 20, 20)) < 1] = -1000  # the nose's cavity
    hu[outside >= 1] = -1000
    return hu


image = baseline.voxels(72, head)
image.SetSpacing([MILLIMETRES / 71] * 3)
image.SetOrigin([-MILLIMETRES / 2] * 3)
mapper = vtkSingleScatteringVolumeMapper()
mapper.SetInputData(image)
mapper.SetLightSampleDistance(2 * MILLIMETRES / 71)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(hounsfield_property())
window = baseline.window_of(220, 220)
view = baseline.view_of(window)
view.AddVolume(volume)
view.AddLight(baseline.sun((-1.5, -2, 1.5), (1, 0.95, 0.88), 18))
view.AddLight(baseline.sun((2, -0.5, 0.5), (0.55, 0.72, 1), 10))
camera = view.GetActiveCamera()
camera.SetPosition(0.7, -2, 0.5)
camera.SetFocalPoint(0, 0, 0)
camera.SetViewUp(0, 0, 1)
view.ResetCamera()
camera.Zoom(1.6)

baseline.compare(window, "lengths taken for centimetres",
                 lambda: volume.GetProperty().SetScalarOpacityUnitDistance(10))
