# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A head of formulas in CT numbers (HU, mm) with the preset for CT: bone under thin fog of skin."""

import baseline
import numpy as np
from vtkmodules.vtkRenderingCore import vtkVolume

from participating_media import vtkSingleScatteringVolumeMapper
from participating_media.presets import hounsfield_property

MILLIMETRES = 200


EDGE = 9  # mm over which a scanner's voxels go from one tissue to the next


def head(x, y, z):
    """CT numbers: air -1000, skin and fat -50, muscle 50, bone 1200, brain 35, eyes 20."""
    place = [MILLIMETRES * p for p in (x, y, z)]

    def inside(centre, axes, above=None):
        """1 in the ellipsoid, 0 outside, a straight ramp between; only above that height."""
        radius = np.sqrt(sum(((p - c) / a) ** 2 for p, c, a in zip(place, centre, axes)))
        ramp = np.clip(0.5 + (1 - radius) * min(axes) / EDGE, 0, 1)
        return ramp if above is None else ramp * np.clip(0.5 + (place[2] - above) / EDGE, 0, 1)

    hu = np.full_like(x, -1000.0)
    for number, part in (
            (-50, inside((0, 0, 0), (72, 90, 95))),
            (50, inside((0, 0, 0), (67, 84, 89))),
            (1200, inside((0, 0, 0), (63, 79, 84), -60)),
            (35, inside((0, 4, 10), (55, 66, 68))),
            (20, inside((-30, -72, 8), (20, 26, 18))),
            (20, inside((30, -72, 8), (20, 26, 18))),
            (-1000, inside((0, -80, -22), (11, 20, 20)))):  # the nose's cavity
        hu += part * (number - hu)
    return hu


image = baseline.voxels(64, head)
image.SetSpacing([MILLIMETRES / 63] * 3)
image.SetOrigin([-MILLIMETRES / 2] * 3)
mapper = vtkSingleScatteringVolumeMapper()
mapper.SetIntegratorToFixedStep()
mapper.SetInputData(image)
mapper.SetSampleDistance(2)
mapper.SetLightSampleDistance(4)
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(hounsfield_property())
window = baseline.window_of(200, 200)
view = baseline.view_of(window)
view.AddVolume(volume)
view.AddLight(baseline.sun((-1.5, -2, 1.5), (1, 0.95, 0.88), 15))
view.AddLight(baseline.sun((2, -0.5, 0.5), (0.55, 0.72, 1), 10))
camera = view.GetActiveCamera()
camera.SetPosition(0.7, -2, 0.5)
camera.SetFocalPoint(0, 0, 0)
camera.SetViewUp(0, 0, 1)
view.ResetCamera()
camera.Zoom(1.6)

baseline.compare(window, "lengths taken for centimetres",
                 lambda: volume.GetProperty().SetScalarOpacityUnitDistance(10))
