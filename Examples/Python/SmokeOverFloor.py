#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A ball of smoke in the sun, and its shadow on the floor: the light that reaches each point of the floor
through the smoke is multiplied into the floor's colour."""

import argparse
import math
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume,
    vtkVolumeProperty)

from participating_media import (
    vtkParticipatingMedium, vtkSingleScatteringReference, vtkSingleScatteringVolumeMapper)
from participating_media.picture import RenderingError, finish

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("--output", default="smoke_over_floor.png", help="the PNG to write")
parser.add_argument("--size", type=int, default=512, help="pixels along an edge of the picture")
parser.add_argument("--interactive", action="store_true", help="open a window")
options = parser.parse_args()

# A ball of radius 1 around (0, 0, 1.4) that is dense in its middle, of 33^3 points.
POINTS = 33
smoke = vtkImageData()
smoke.SetDimensions(POINTS, POINTS, POINTS)
smoke.SetSpacing([2 / (POINTS - 1)] * 3)
smoke.SetOrigin(-1, -1, 0.4)
smoke.AllocateScalars(10, 1)  # VTK_FLOAT
density = smoke.GetPointData().GetScalars()
for index in range(smoke.GetNumberOfPoints()):
    x, y, z = smoke.GetPoint(index)
    density.SetValue(index, max(1 - x * x - y * y - (z - 1.4) ** 2, 0))

medium = vtkParticipatingMedium()
medium.SetExtinctionArrayName("")  # the active scalars
medium.SetExtinctionScale(1.2, 1.6, 2.2)  # blue light is weakened most
medium.SetAlbedo(0.95)
mapper = vtkSingleScatteringVolumeMapper()
mapper.SetInputData(smoke)
mapper.SetMedium(medium)
linear = vtkVolumeProperty()
linear.SetInterpolationTypeToLinear()
volume = vtkVolume()
volume.SetMapper(mapper)
volume.SetProperty(linear)

sun = vtkLight()
sun.SetLightTypeToSceneLight()
sun.SetPosition(-1, -0.4, 1.5)
sun.SetFocalPoint(0, 0, 0)
sun.SetIntensity(6)  # irradiance

plane = vtkPlaneSource()
plane.SetOrigin(-2, -2, 0)
plane.SetPoint1(3, -2, 0)
plane.SetPoint2(-2, 3, 0)
plane.SetResolution(120, 120)
plane.Update()
floor = plane.GetOutput()

# The shadow: what is left of the sun at each point, times the floor's reflectance.
reference = vtkSingleScatteringReference()
reference.SetVolume(volume)
reference.SetMedium(medium)
left = vtkDoubleArray()
if not reference.LightTransmittance(sun, floor.GetPoints(), left):
    sys.exit("SmokeOverFloor.py: the floor's shadow could not be computed")
colors = vtkUnsignedCharArray()
colors.SetNumberOfComponents(3)
for index in range(left.GetNumberOfTuples()):
    colors.InsertNextTuple([round(255 * 0.5 * part) for part in left.GetTuple(index)])
floor.GetPointData().SetScalars(colors)

surface = vtkPolyDataMapper()
surface.SetInputData(floor)
actor = vtkActor()
actor.SetMapper(surface)
actor.GetProperty().SetAmbient(0)
actor.GetProperty().SetDiffuse(1 / math.pi)  # what Lambert's law reflects of the irradiance

renderer = vtkRenderer()
renderer.AddLight(sun)
renderer.AddActor(actor)
renderer.AddVolume(volume)
camera = renderer.GetActiveCamera()
camera.SetFocalPoint(0.3, 0.2, 0.75)
camera.SetPosition(2.5, -7, 4.5)
camera.SetViewUp(0, 0, 1)
camera.SetViewAngle(32)
renderer.ResetCameraClippingRange()
window = vtkRenderWindow()
window.SetSize(options.size, options.size)
window.AddRenderer(renderer)

try:
    finish(window, {"smoke": mapper}, options.output, options.interactive)
except RenderingError as error:
    sys.exit(f"SmokeOverFloor.py: {error}")
