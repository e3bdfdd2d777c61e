#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A CT scan as a participating medium: bone in a thin fog of skin and tissue, lit by two lights.

Without a file, the skull of Debian's package invesalius-examples."""

import argparse
import sys
from pathlib import Path

from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow, vtkVolume

from participating_media import vtkSingleScatteringVolumeMapper
from participating_media.picture import RenderingError, finish
from participating_media.presets import hounsfield_property
from participating_media.readers import UnreadableVolume, read_volume

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "Data"))
from cranium import read_cranium  # noqa: E402

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("volume", nargs="?", help="a .vti, .nii, .nii.gz, .mhd, .mha, .nrrd or .inv3 "
                    "file or a folder of DICOM slices, in HU and mm")
parser.add_argument("--output", default="ct.png", help="the PNG to write")
parser.add_argument("--size", type=int, default=512, help="pixels along an edge")
parser.add_argument("--step", type=float, help="mm along a ray, twice that to a light, in FixedStep; "
                    "without it the mapper finds a step for an error of 4/255")
parser.add_argument("--interactive", action="store_true", help="open a window")
options = parser.parse_args()


def light(position, colour, irradiance):
    """A lamp far away; irradiance is what a surface that faces it receives."""
    lamp = vtkLight()
    lamp.SetLightTypeToSceneLight()
    lamp.SetPosition(position)
    lamp.SetFocalPoint(0, 0, 0)
    lamp.SetColor(colour)
    lamp.SetIntensity(irradiance)
    return lamp


try:
    mapper = vtkSingleScatteringVolumeMapper()
    mapper.SetInputData(read_volume(options.volume) if options.volume else read_cranium())
    if options.step:
        mapper.SetIntegratorToFixedStep()
        mapper.SetSampleDistance(options.step)
        mapper.SetLightSampleDistance(2 * options.step)
    else:
        mapper.SetIntegratorToErrorControlled()
        mapper.SetMaximumError(4 / 255)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(hounsfield_property())  # extinction in 1/mm and albedo by CT number

    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    renderer.AddLight(light((1.0, 1.4, 1.2), (1.0, 0.95, 0.88), 10))
    renderer.AddLight(light((-1.5, -0.5, 0.3), (0.55, 0.72, 1.0), 6.5))
    renderer.SetBackground(0.02, 0.025, 0.035)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 1, 0)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.Azimuth(-40)
    camera.Elevation(8)
    renderer.ResetCamera()
    camera.Zoom(1.55)
    camera.SetWindowCenter(0, -0.12)  # a head is in the lower half of its scan
    window = vtkRenderWindow()
    window.SetSize(options.size, options.size)
    window.AddRenderer(renderer)
    finish(window, {"CT": mapper}, options.output, options.interactive)
except (UnreadableVolume, RenderingError) as error:
    print(f"CT.py: {error}", file=sys.stderr)
    sys.exit(2)
