#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fog in VTK's wavelet as a quilt for a holographic display: 45 off-axis views in one picture, 5
columns by 9 rows, from the leftmost eye at the bottom left to the rightmost one at the top right.
All views share one mapper, which builds what they need once; the same views as single cold frames,
each by a mapper of its own, show what that saves."""

import argparse
import sys

from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkRenderWindow, vtkVolume

from participating_media import vtkSingleScatteringVolumeMapper
from participating_media.picture import RenderingError, render, write_png
from participating_media.presets import ramp_property
from participating_media.views import add_grid, beside, quilt_offsets

COLUMNS, ROWS = 5, 9

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--output", default="quilt.png", help="the PNG to write")
parser.add_argument("--size", type=int, default=256, help="pixels along an edge of each view")
parser.add_argument("--points", type=int, default=128, help="points along an edge of the volume")
parser.add_argument("--cone", type=float, default=40.0, help="degrees between the outermost views")
parser.add_argument("--skip-cold", action="store_true", help="leave the single cold frames out")
options = parser.parse_args()

half = (options.points - 1) // 2
wavelet = vtkRTAnalyticSource()
wavelet.SetWholeExtent(-half, half, -half, half, -half, half)
fog = ramp_property(150, 260, extinction=20 / half)
light = vtkLight()
light.SetLightTypeToSceneLight()
light.SetPosition(half, 3 * half, 2 * half)
light.SetIntensity(14)
camera = vtkCamera()
camera.SetPosition(0, 1.3 * half, 5.2 * half)
camera.SetFocalPoint(0, 0, 0)
camera.SetClippingRange(0.1 * half, 20 * half)
eyes = [beside(camera, offset, aspect=1)
        for offset in quilt_offsets(camera, COLUMNS * ROWS, options.cone)]


def draw(cameras, columns):
    """A window with a view of each camera, its mapper, and the milliseconds that it took."""
    mapper = vtkSingleScatteringVolumeMapper()
    mapper.SetInputConnection(wavelet.GetOutputPort())
    mapper.SetIntegratorToErrorControlled()
    mapper.SetLightCachesToAlways()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(fog)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(columns * options.size, -(-len(cameras) // columns) * options.size)
    for renderer in add_grid(window, cameras, columns):
        renderer.AddLight(light)
        renderer.AddVolume(volume)
    return window, mapper, render(window, mapper)


try:
    wavelet.Update()
    draw(eyes[:1], columns=1)  # so that neither of the two pays for the first window
    quilt, quilt_mapper, warm = draw(eyes, COLUMNS)
    write_png(quilt, options.output)
    done = quilt_mapper.GetStatistics()
    print(f"{options.output}: {done.GetFrames()} views of {options.size} x {options.size} pixels in "
          f"{warm:.0f} ms: {done.GetTextureUploads()} textures, {done.GetLightCacheBuilds()} light "
          f"caches, {done.GetCalibrations()} calibrations, {done.GetProgramCompiles()} programs")
    if not options.skip_cold:
        cold = sum(draw([eye], columns=1)[2] for eye in eyes)
        print(f"  the same views as {len(eyes)} single cold frames: {cold:.0f} ms, "
              f"{cold / warm:.1f} times as long")
except RenderingError as error:
    sys.exit(f"Quilt.py: {error}")
