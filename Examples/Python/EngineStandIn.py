#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""An engine-like block filled with fog, as Han, Ki and Oh drew the Engine: on the left with their
assumption that the filled part is convex, which leaves holes, on the right without it."""

import argparse
import math
import sys
from pathlib import Path

import vtkmodules.vtkRenderingFreeType  # noqa: F401  registers the fonts
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import (
    vtkCamera, vtkColorTransferFunction, vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkVolume, vtkVolumeProperty)

from participating_media import vtkSingleScatteringVolumeMapper
from participating_media.picture import RenderingError, finish

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Data"))
from engine_block import engine_block, read_engine  # noqa: E402

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("engine", nargs="?", type=Path, help="the real Engine, 256x256x128 raw bytes")
parser.add_argument("--output", default="engine_stand_in.png", help="the PNG to write")
parser.add_argument("--size", type=int, default=512, help="pixels along an edge of each picture")
parser.add_argument("--interactive", action="store_true", help="open a window")
options = parser.parse_args()

try:
    image, name = engine_block(), "procedural stand-in, not the real Engine"
    if options.engine:
        image, name = read_engine(options.engine)

    # One medium for all that is filled: extinction 0.04 per voxel, and an albedo of warm metal.
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, -math.expm1(-0.04))
    albedo = vtkColorTransferFunction()
    albedo.AddRGBPoint(0, 1.0, 0.93, 0.82)
    metal = vtkVolumeProperty()
    metal.SetScalarOpacity(opacity)
    metal.SetColor(albedo)

    lamp = vtkLight()
    lamp.SetLightTypeToSceneLight()
    lamp.PositionalOn()
    lamp.SetConeAngle(180)
    lamp.SetPosition(-350, -250, 320)
    lamp.SetIntensity(15)
    camera = vtkCamera()
    camera.SetFocalPoint(128, 122, 60)
    camera.SetPosition(-145, -298, 330)
    camera.SetViewUp(0, 0, 1)
    window = vtkRenderWindow()
    window.SetSize(2 * options.size, options.size)
    mappers = {}
    for convex, title in ((True, "assumed convex"), (False, "every interval")):
        mapper = mappers[title] = vtkSingleScatteringVolumeMapper()
        mapper.SetInputData(image)
        mapper.SetIntegratorToPaper()
        mapper.SetPaperThreshold(60)
        mapper.SetAssumeConvex(convex)
        mapper.SetSampleDistance(2)
        volume = vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(metal)
        label = vtkTextActor()
        label.SetInput(f"{title}\n{name}")
        label.SetPosition(12, 10)
        renderer = vtkRenderer()
        renderer.SetViewport(0 if convex else 0.5, 0, 0.5 if convex else 1, 1)
        renderer.SetActiveCamera(camera)
        renderer.AddLight(lamp)
        renderer.AddVolume(volume)
        renderer.AddViewProp(label)
        renderer.ResetCameraClippingRange()
        window.AddRenderer(renderer)
    finish(window, mappers, options.output, options.interactive)
except (ValueError, OSError, RenderingError) as error:
    print(f"EngineStandIn.py: {error}", file=sys.stderr)
    sys.exit(2)
