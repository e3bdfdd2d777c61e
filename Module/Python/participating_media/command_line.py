# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command line ``participating-media``: renders a volume file to a PNG picture."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow, vtkVolume

from .picture import RenderingError, peak_radiance, render, statistics_line, write_png
from .presets import hounsfield_property, ramp_property
from .readers import UnreadableVolume, read_volume
from .vtkParticipatingMediaRendering import vtkSingleScatteringVolumeMapper

#: A ramp's extinction is such that this optical depth lies across the volume's diagonal.
RAMP_OPTICAL_DEPTH = 20.0
#: The brightest value of an automatically exposed picture, a little below white.
EXPOSED_PEAK = 0.95
#: Names as the mapper has them, SetOutputTo… and SetIntegratorTo….
MODES = ("radiance", "first-hit", "distance", "transmittance", "optical-depth", "depth",
         "sample-count")
INTEGRATORS = ("error-controlled", "fixed-step", "paper", "exact")


def _number(low: float, high: float):
    def parse(text: str) -> float:
        value = float(text)
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(f"{text} is outside {low:g} … {high:g}")
        return value

    parse.__name__ = "number"
    return parse


def _numbers(count: int, separator: str, kind: type):
    def parse(text: str) -> tuple:
        values = tuple(kind(part) for part in text.split(separator))
        if len(values) != count or not all(math.isfinite(value) for value in values):
            raise argparse.ArgumentTypeError(
                f"{text}: expected {count} numbers with '{separator}' between")
        return values

    parse.__name__ = "numbers"
    return parse


def _size(text: str) -> tuple[int, int]:
    size = _numbers(2, "x", int)(text)
    if not all(1 <= side <= 16384 for side in size):
        raise argparse.ArgumentTypeError(f"{text}: each side must be 1 … 16384 pixels")
    return size


class _Parser(argparse.ArgumentParser):
    """An ArgumentParser whose errors are one line, with exit code 2."""

    def error(self, message: str):
        self.exit(2, f"{self.prog}: {message} (--help lists the options)\n")


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(
        prog="participating-media", description="Renders a volume as a participating medium, lit "
        "by single scattering, to a PNG. Lengths are the file's own units, commonly mm. A list "
        "that begins with a minus needs an equals sign: --light=-1,0,0.")
    add = parser.add_argument
    add("volume", type=Path,
        help="a .vti, .nii, .nii.gz, .mhd, .mha, .nrrd, .nhdr or .inv3 file, or a folder of DICOM "
        "slices")
    add("-o", "--output", type=Path, default=Path("picture.png"), metavar="PNG",
        help="the picture to write (%(default)s)")
    add("--size", type=_size, default=(512, 512), metavar="WxH",
        help="pixels of the picture (512x512)")
    add("--mode", choices=MODES, default=MODES[0],
        help="radiance, or as grey: the distance to the medium or through it, transmittance, "
        "optical depth, mean depth, work (%(default)s)")
    add("--integrator", choices=INTEGRATORS,
        help="error-controlled chooses the step by itself; fixed-step takes --step; paper is for what "
        "a threshold fills; exact is slow (error-controlled, or fixed-step where there is a --step)")
    add("--step", type=_number(0, sys.float_info.max), default=0.0, metavar="LENGTH",
        help="longest step along the eye and light rays (0: one voxel)")
    add("--threshold", type=float, metavar="SCALAR",
        help="paper: the scalar from which on a voxel is filled (the middle of the range)")
    add("--medium", choices=("auto", "ct", "ramp"), default="auto",
        help="ct: HU, bone in a thin fog of tissue; ramp: white, denser with the scalar; auto: ct "
        "if there are scalars below -500 (%(default)s)")
    add("--range", type=_numbers(2, ",", float), metavar="LOW,HIGH",
        help="ramp: the scalars at its foot and top (the volume's range)")
    add("--extinction", type=_number(0, sys.float_info.max), metavar="PER_LENGTH",
        help="ramp: extinction at its top, per unit of length (an optical depth of "
        f"{RAMP_OPTICAL_DEPTH:g} along the diagonal)")
    add("--anisotropy", type=_number(-1, 1), default=0.0, metavar="G",
        help="mean cosine of the phase function, -1 (back) to 1 (forward) (0)")
    add("--light", type=_numbers(3, ",", float), default=(-1.0, -1.4, -1.2), metavar="X,Y,Z",
        help="the way the light travels (-1,-1.4,-1.2: from the right, front and above)")
    add("--irradiance", type=_number(0, sys.float_info.max), metavar="E",
        help="of a surface that faces the light (such that nothing is clipped)")
    add("--azimuth", type=float, default=-30.0, metavar="DEGREES",
        help="around z, 0 looks at the front (+y) of the volume (-30)")
    add("--elevation", type=_number(-89, 89), default=15.0, metavar="DEGREES",
        help="above the horizon (15)")
    return parser


def _medium(options: argparse.Namespace, image: vtkImageData):
    low, high = options.range or image.GetScalarRange()
    kind = options.medium
    if kind == "auto":
        kind = "ct" if not options.range and low < -500 else "ramp"
    if kind == "ct":
        return hounsfield_property()
    if not low < high:
        raise RenderingError(f"the ramp runs from {low:g} to {high:g}; "
                             "give --range LOW,HIGH with LOW < HIGH")
    extinction = options.extinction
    if extinction is None:
        extinction = RAMP_OPTICAL_DEPTH / image.GetLength()
    return ramp_property(low, high, extinction)


def _setter_name(option: str) -> str:
    """fixed-step -> FixedStep."""
    return option.title().replace("-", "")


def _mapper(options: argparse.Namespace, image: vtkImageData) -> vtkSingleScatteringVolumeMapper:
    mapper = vtkSingleScatteringVolumeMapper()
    mapper.SetInputData(image)
    integrator = options.integrator or ("fixed-step" if options.step else "error-controlled")
    getattr(mapper, f"SetIntegratorTo{_setter_name(integrator)}")()
    getattr(mapper, f"SetOutputTo{_setter_name(options.mode)}")()
    mapper.SetSampleDistance(options.step)
    mapper.SetLightSampleDistance(options.step)
    mapper.SetAnisotropy(options.anisotropy)
    threshold = options.threshold
    mapper.SetPaperThreshold(sum(image.GetScalarRange()) / 2 if threshold is None else threshold)
    return mapper


def _draw(options: argparse.Namespace) -> None:
    print(f"reading {options.volume}", flush=True)
    image = read_volume(options.volume)
    mapper = _mapper(options, image)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(_medium(options, image))
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition([-component for component in options.light])
    light.SetFocalPoint(0, 0, 0)
    light.SetIntensity(options.irradiance if options.irradiance is not None else 1.0)
    renderer = vtkRenderer()
    renderer.AddLight(light)
    renderer.AddVolume(volume)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 1, 0)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.Azimuth(options.azimuth)
    camera.Elevation(options.elevation)
    renderer.ResetCamera()
    camera.Zoom(1.4)  # the bounding sphere that the camera was set to has much air in it
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(options.size)
    window.AddRenderer(renderer)
    columns, rows, slices = image.GetDimensions()
    print(f"rendering {columns} x {rows} x {slices} voxels to {options.size[0]} x "
          f"{options.size[1]} pixels", flush=True)
    milliseconds = render(window, mapper)
    peak = peak_radiance(mapper)
    if options.mode == "radiance" and options.irradiance is None and peak > 0:
        # Radiance is proportional to the light, so that one frame tells the exposure.
        light.SetIntensity(EXPOSED_PEAK / peak)
        print(f"irradiance {light.GetIntensity():.3g}", flush=True)
        milliseconds = render(window, mapper)
    write_png(window, options.output)
    print(f"{options.output}: frame {milliseconds:.1f} ms, {statistics_line(mapper)}")


def main(arguments: list[str] | None = None) -> int:
    """Runs the command line; returns 0, or 2 after one line on stderr that says what was wrong."""
    parser = _parser()
    options = parser.parse_args(arguments)
    try:
        if not any(options.light):
            raise RenderingError("--light 0,0,0 has no direction; give one that is not zero")
        _draw(options)
    except (UnreadableVolume, RenderingError, OSError) as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return 2
    return 0
