#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A cube of fog in a 0/1 volume of 256^3 voxels, in the three modes of Han, Ki and Oh's Table 1:
first intersection, distance from the first to the last intersection, single scattering."""

import argparse
import sys

import vtkmodules.vtkRenderingFreeType  # noqa: F401  registers the fonts
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkImagingCore import vtkImageConstantPad
from vtkmodules.vtkRenderingCore import (
    vtkCamera, vtkColorTransferFunction, vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkVolume, vtkVolumeProperty)

from participating_media import vtkSingleScatteringVolumeMapper
from participating_media.picture import RenderingError, finish

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--output", default="fog_cube.png", help="the PNG to write")
parser.add_argument("--size", type=int, default=512, help="pixels along an edge of each picture")
parser.add_argument("--interactive", action="store_true", help="open a window")
options = parser.parse_args()

# 160^3 ones in the middle of 256^3 voxels; the edge of the volume is 1 long.
ones = vtkImageData()
ones.SetDimensions(160, 160, 160)
ones.SetSpacing([1 / 255] * 3)
ones.AllocateScalars(3, 1)  # VTK_UNSIGNED_CHAR
ones.GetPointData().GetScalars().Fill(1)
voxels = vtkImageConstantPad()
voxels.SetInputData(ones)
voxels.SetConstant(0)
voxels.SetOutputWholeExtent(-48, 207, -48, 207, -48, 207)

# Extinction 5 per unit of length, an optical depth of 3 across the fog; all light is scattered.
opacity = vtkPiecewiseFunction()
opacity.AddPoint(0, 0.0)
opacity.AddPoint(1, 1 - 2.718281828 ** -0.05)
albedo = vtkColorTransferFunction()
albedo.AddRGBPoint(1, 1.0, 1.0, 1.0)
fog = vtkVolumeProperty()
fog.SetScalarOpacity(opacity)
fog.SetColor(albedo)
fog.SetScalarOpacityUnitDistance(0.01)

window = vtkRenderWindow()
window.SetSize(3 * options.size, options.size)
camera = vtkCamera()
camera.SetFocalPoint(0.31, 0.31, 0.27)
camera.SetPosition(1.5, -1.25, 1.15)
camera.SetViewUp(0, 0, 1)
lamp = vtkLight()
lamp.SetLightTypeToSceneLight()
lamp.PositionalOn()
lamp.SetConeAngle(180)
lamp.SetPosition(0.5, -1.3, 1.6)
lamp.SetIntensity(16)

mappers = {}
for column, mode in enumerate(("FirstHit", "Distance", "Radiance")):
    mapper = mappers[mode] = vtkSingleScatteringVolumeMapper()
    mapper.SetInputConnection(voxels.GetOutputPort())
    mapper.SetIntegratorToPaper()
    getattr(mapper, f"SetOutputTo{mode}")()
    mapper.SetSampleDistance(1 / 128)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(fog)
    label = vtkTextActor()
    label.SetInput({"FirstHit": "first intersection", "Distance": "distance",
                    "Radiance": "single scattering"}[mode])
    label.SetPosition(12, 10)
    renderer = vtkRenderer()
    renderer.SetViewport(column / 3, 0, (column + 1) / 3, 1)
    renderer.SetActiveCamera(camera)
    renderer.AddLight(lamp)
    renderer.AddVolume(volume)
    renderer.AddViewProp(label)
    renderer.ResetCameraClippingRange()
    window.AddRenderer(renderer)

try:
    finish(window, mappers, options.output, options.interactive)
except RenderingError as error:
    sys.exit(f"FogCube.py: {error}")
