# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Compares what a window shows with a picture that was looked at and found right.

As Cxx/Baseline.h does, with the same limits: pixels are compared besides VTK's own comparison, and
the same scene with one deliberate mistake must be rejected.
"""

import os
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkLight, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)
from vtkmodules.vtkTestingRendering import vtkTesting

#: See Cxx/Baseline.cxx for the reasons.
LARGEST_MEAN = 0.5
DIFFERENT_LEVEL = 8
LARGEST_FRACTION = 0.002
MARGIN = 4
SMALLEST_SUBJECT = 0.02
THRESHOLD_OF_VTK = 0.05


def window_of(width: int, height: int) -> vtkRenderWindow:
    """An off-screen window without multi-sampling."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    return window


def view_of(window: vtkRenderWindow, left: float = 0, right: float = 1) -> vtkRenderer:
    """A view on these columns of the window, 0 to 1, without any lights."""
    view = vtkRenderer()
    view.SetViewport(left, 0, right, 1)
    view.AutomaticLightCreationOff()
    window.AddRenderer(view)
    return view


def sun(towards, colour, irradiance: float) -> vtkLight:
    """A light at infinity; irradiance is what arrives on a surface that faces it."""
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(towards)
    light.SetFocalPoint(0, 0, 0)
    light.SetColor(colour)
    light.SetIntensity(irradiance)
    return light


def voxels(points: int, density) -> vtkImageData:
    """A cube 1 long around the origin, with the density(x, y, z) of arrays of coordinates."""
    axis = np.linspace(-0.5, 0.5, points)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    image = vtkImageData()
    image.SetDimensions(points, points, points)
    image.SetSpacing([1 / (points - 1)] * 3)
    image.SetOrigin(-0.5, -0.5, -0.5)
    image.AllocateScalars(10, 1)  # VTK_FLOAT
    image.GetPointData().GetScalars().SetName("density")
    vtk_to_numpy(image.GetPointData().GetScalars())[:] = density(x, y, z).ravel()
    return image


def _capture(window: vtkRenderWindow, which: str) -> vtkImageData:
    """What the window shows; ends the program if there was an error, or nothing to see."""
    errors = []
    reports = vtkOutputWindow.GetInstance()
    tag = reports.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
    window.Render()
    reports.RemoveObserver(tag)
    frame = vtkWindowToImageFilter()
    frame.SetInput(window)
    frame.ReadFrontBufferOff()
    frame.ShouldRerenderOff()
    frame.Update()
    if errors or not _shows_something(frame.GetOutput()):
        sys.exit(f"FAILED: {which} is empty, or there was an error")
    return frame.GetOutput()


def _read(path: Path) -> vtkImageData:
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def _write(picture: vtkImageData, path: Path) -> None:
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetCompressionLevel(9)
    writer.SetInputData(picture)
    writer.Write()


def _levels(picture: vtkImageData) -> np.ndarray:
    width, height, _ = picture.GetDimensions()
    return vtk_to_numpy(picture.GetPointData().GetScalars()).reshape(height, width, -1).astype(int)


def _difference(a: vtkImageData, b: vtkImageData) -> tuple[float, float, int]:
    """Mean, fraction of different pixels, largest difference; all is different if sizes are."""
    if a.GetDimensions() != b.GetDimensions():
        return 255.0, 1.0, 255
    difference = np.abs(_levels(a) - _levels(b))
    fraction = (difference.max(axis=2) > DIFFERENT_LEVEL).mean()
    return float(difference.mean()), float(fraction), int(difference.max())


def _shows_something(picture: vtkImageData) -> bool:
    levels = _levels(picture)
    return bool((levels != levels[0, 0]).any(axis=2).mean() >= SMALLEST_SUBJECT)


def _accepted_by_vtk(picture: vtkImageData, folder: Path, arguments: list[str]) -> bool:
    testing = vtkTesting()
    for argument in (*arguments, "-T", str(folder)):
        testing.AddArgument(argument)
    producer = vtkTrivialProducer()
    producer.SetOutput(picture)
    return testing.RegressionTest(producer, THRESHOLD_OF_VTK) == vtkTesting.PASSED


def compare(window: vtkRenderWindow, mistake: str, make_mistake) -> None:
    """Compares with the baseline that -V names, then wants the picture after make_mistake() to be
    rejected, and ends the program. `mistake` says what was done."""
    arguments = sys.argv[1:]
    named = dict(zip(arguments, arguments[1:]))
    path, folder = Path(named["-V"]), Path(named["-T"])
    faults = []

    picture = _capture(window, "the picture")
    if "PARTICIPATING_MEDIA_UPDATE_BASELINES" in os.environ:
        _write(picture, path)
        print(f"Wrote {path}; look at it before it is committed")
    if not path.exists():
        sys.exit(f"FAILED: {path} is missing; see Testing/Image/README.md")
    baseline = _read(path)

    mean, fraction, largest = _difference(picture, baseline)
    described = "mean {:.3g}, {:.3%} of the pixels differ by more than {}, largest {}"
    print("As it should be:", described.format(mean, fraction, DIFFERENT_LEVEL, largest))
    if mean > LARGEST_MEAN or fraction > LARGEST_FRACTION:
        faults.append("the picture differs from its baseline")
    if not _accepted_by_vtk(picture, folder, arguments):
        faults.append("VTK's comparison rejects the picture")

    make_mistake()
    wrong = _capture(window, f"the picture with {mistake}")
    (folder / "Wrong").mkdir(exist_ok=True)
    _write(wrong, folder / "Wrong" / path.name)
    mean, fraction, largest = _difference(wrong, baseline)
    print(f"With {mistake}:", described.format(mean, fraction, DIFFERENT_LEVEL, largest))
    if mean < MARGIN * LARGEST_MEAN and fraction < MARGIN * LARGEST_FRACTION:
        faults.append(f"the picture with {mistake} is not clearly rejected")

    for fault in faults:
        print("FAILED:", fault)
    sys.exit(bool(faults))
