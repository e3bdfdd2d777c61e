# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The package installed under the given prefix has its public classes, and its mapper draws."""

import sys

import participating_media
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkVolume

assert participating_media.__file__.startswith(sys.argv[1]), participating_media.__file__
for name in participating_media.__all__:
    assert isinstance(getattr(participating_media, name), type), name

wavelet = vtkRTAnalyticSource()
wavelet.SetWholeExtent(-8, 8, -8, 8, -8, 8)
opacity = vtkPiecewiseFunction()
opacity.AddPoint(0, 0.0)
opacity.AddPoint(300, 0.5)

mapper = participating_media.vtkSingleScatteringVolumeMapper()
mapper.SetInputConnection(wavelet.GetOutputPort())
volume = vtkVolume()
volume.SetMapper(mapper)
volume.GetProperty().SetScalarOpacity(opacity)

renderer = vtkRenderer()
renderer.AddVolume(volume)
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(64, 64)
window.AddRenderer(renderer)
window.Render()
frames = mapper.GetStatistics().GetFrames()
assert frames == 1, f"{frames} frames were drawn, not 1"
