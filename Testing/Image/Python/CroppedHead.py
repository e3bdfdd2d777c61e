# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A shell of tissue around a dark core, cropped open at a corner that light falls into."""

import baseline
import numpy as np
from vtkmodules.vtkRenderingCore import vtkVolume

from participating_media import vtkParticipatingMedium, vtkSingleScatteringVolumeMapper


def shells(x, y, z):
    """Two shells with a gap between them."""
    radius = np.sqrt(x ** 2 + y ** 2 + z ** 2)
    return np.clip(12 * (0.06 - abs(radius - 0.4)), 0, 1) + np.clip(8 * (0.2 - radius), 0, 1)


medium = vtkParticipatingMedium()
medium.SetExtinctionArrayName("density")
medium.SetExtinctionScale(30)
medium.SetAlbedo(1, 0.8, 0.7)
mapper = vtkSingleScatteringVolumeMapper()
mapper.SetIntegratorToFixedStep()
mapper.SetInputData(baseline.voxels(49, shells))
mapper.SetMedium(medium)
mapper.CroppingOn()
mapper.SetCroppingRegionPlanes(0, 1, -1, 0, 0, 1)
mapper.SetCroppingRegionFlags(0x7FFFFFF & ~(1 << (1 + 3 * 1 + 9 * 1)))  # all but one octant
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetInterpolationTypeToLinear()
window = baseline.window_of(200, 200)
view = baseline.view_of(window)
view.AddVolume(volume)
view.AddLight(baseline.sun((2, -2, 2.4), (1, 1, 1), 16))
view.GetActiveCamera().SetPosition(2, -2.6, 1.5)
view.GetActiveCamera().SetFocalPoint(0, 0, 0)
view.GetActiveCamera().SetViewUp(0, 0, 1)
view.ResetCamera()
view.GetActiveCamera().Zoom(1.6)

baseline.compare(window, "another octant cut out",
                 lambda: mapper.SetCroppingRegionPlanes(-1, 0, -1, 0, 0, 1))
