#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fog in VTK's wavelet as a side-by-side stereo picture: the left eye's view on the left, the right
eye's on the right. Both eyes share one mapper, and with it all that it builds."""

import argparse
import sys

from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkRenderWindow, vtkVolume

from participating_media import vtkSingleScatteringVolumeMapper
from participating_media.picture import RenderingError, finish
from participating_media.presets import ramp_property
from participating_media.views import add_grid, beside

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--output", default="stereo.png", help="the PNG to write")
parser.add_argument("--size", type=int, default=512, help="pixels along an edge of each eye's picture")
parser.add_argument("--separation", type=float, default=4.0,
                    help="between the eyes, in units of the wavelet, which is 20 wide")
options = parser.parse_args()

wavelet = vtkRTAnalyticSource()
mapper = vtkSingleScatteringVolumeMapper()
mapper.SetInputConnection(wavelet.GetOutputPort())
mapper.SetIntegratorToErrorControlled()
mapper.SetLightCachesToAlways()
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(ramp_property(150, 260, extinction=2.0))
light = vtkLight()
light.SetLightTypeToSceneLight()
light.SetPosition(10, 30, 20)
light.SetIntensity(14)

camera = vtkCamera()
camera.SetPosition(12, 14, 46)
camera.SetFocalPoint(0, 0, 0)
camera.SetClippingRange(1, 200)
window = vtkRenderWindow()
window.SetSize(2 * options.size, options.size)
eyes = [beside(camera, side * options.separation / 2, aspect=1) for side in (-1, 1)]
for renderer in add_grid(window, eyes, columns=2):
    renderer.AddLight(light)
    renderer.AddVolume(volume)

try:
    finish(window, {"both eyes": mapper}, options.output)
except RenderingError as error:
    sys.exit(f"Stereo.py: {error}")
done = mapper.GetStatistics()
print(f"  {done.GetFrames()} views, {done.GetTextureUploads()} textures, "
      f"{done.GetLightCacheBuilds()} light caches, {done.GetCalibrations()} calibrations")
