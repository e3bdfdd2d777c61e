#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Table 1 of Han, Ki and Oh: frames per second of a cube and an engine-like block in three modes,
512 x 512 pixels, 256^3 and 256 x 256 x 128 voxels, beside the paper's GeForce 8800 GTX of 2007.

The Engine is a procedural stand-in. AssumeConvex is on, as in the paper. A loop of look-ups without
light, in the same run, says how many the machine does. Run it alone on the machine:

    <build>/python Testing/Benchmark/table1.py [--output FILE.json]
"""

import argparse
import datetime
import json
import platform
import statistics
import sys
import time
from pathlib import Path

import numpy
from tqdm import tqdm
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow, vtkVolume

from participating_media import vtkSingleScatteringVolumeMapper

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Examples" / "Data"))
from engine_block import engine_block  # noqa: E402

PAPER = {"cube": (669, 428, 92), "engine stand-in": (1068, 679, 64)}
MODES = ("FirstHit", "Distance", "Radiance")


def fog_cube():
    """160^3 ones in the middle of 256^3 voxels."""
    voxels = numpy.zeros((256, 256, 256), numpy.uint8)
    voxels[48:208, 48:208, 48:208] = 1
    image = vtkImageData()
    image.SetDimensions(256, 256, 256)
    image.GetPointData().SetScalars(numpy_to_vtk(voxels.ravel(), deep=True))
    return image


def scene(image, size):
    """A window that shows the image, filled with fog of an optical depth of 3 over 75 voxels."""
    mapper = vtkSingleScatteringVolumeMapper()
    mapper.SetInputData(image)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 1 - numpy.exp(-0.04))
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetScalarOpacity(opacity)
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.PositionalOn()
    light.SetConeAngle(180)
    light.SetPosition(-350, -250, 420)
    light.SetFocalPoint(128, 128, 64)
    light.SetIntensity(15)
    renderer = vtkRenderer()
    renderer.AddVolume(volume)
    renderer.AddLight(light)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(size, size)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(-1, -1.5, 1)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    return mapper, window, camera


def measure(mapper, window, camera, frames):
    """Median milliseconds of a frame whose camera has moved, their quartiles, and its look-ups."""
    window.Render()  # uploads and compiles
    times = []
    for _ in range(frames):
        camera.Azimuth(0.01)
        window.Render()
        times.append(mapper.GetStatistics().GetFrameMilliseconds())
    mapper.GetStatistics().CountTapsOn()
    window.Render()
    taps = mapper.GetStatistics().GetTaps()
    mapper.GetStatistics().CountTapsOff()
    low, middle, high = statistics.quantiles(times, n=4)
    return {"milliseconds": middle, "quartiles": [low, high], "taps": taps,
            "taps_per_second": 1000 * taps / middle}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", help="a JSON file to write")
    parser.add_argument("--frames", type=int, default=5, help="frames a median is taken of")
    parser.add_argument("--size", type=int, default=512, help="pixels along an edge")
    options = parser.parse_args()

    rows = []
    images = {"cube": fog_cube(), "engine stand-in": engine_block()}
    for name, image in tqdm(images.items(), desc="Table 1", unit="volume"):
        mapper, window, camera = scene(image, options.size)
        mapper.SetIntegratorToPaper()
        mapper.AssumeConvexOn()
        for mode, paper in zip(MODES, PAPER[name]):
            getattr(mapper, f"SetOutputTo{mode}")()
            row = measure(mapper, window, camera, options.frames)
            rows.append({"volume": name, "mode": mode, "paper_fps": paper,
                         "fps": 1000 / row["milliseconds"], **row})
        if name == "cube":
            mapper.SetIntegratorToFixedStep()
            mapper.SetOutputToOpticalDepth()
            loop = measure(mapper, window, camera, options.frames)
    lines = window.ReportCapabilities().splitlines()
    device = next((line.split(":", 1)[1].strip() for line in lines if "renderer string" in line), "")
    result = {"date": datetime.date.today().isoformat(), "device": device,
              "cpu": platform.processor() or platform.machine(), "vtk": vtkVersion.GetVTKVersion(),
              "size": options.size, "rows": rows, "loop_of_look_ups": loop,
              "finished": time.strftime("%H:%M:%S")}
    print(f"{device}, VTK {result['vtk']}, {options.size} x {options.size}")
    print("volume           mode       frames/s   paper    ms   10^6 look-ups   10^6/s")
    for row in rows:
        print(f"{row['volume']:16s} {row['mode']:9s} {row['fps']:9.2f} {row['paper_fps']:7d} "
              f"{row['milliseconds']:8.1f} {row['taps'] / 1e6:9.1f} "
              f"{row['taps_per_second'] / 1e6:12.1f}")
    print(f"a loop of look-ups: {loop['taps_per_second'] / 1e6:.1f} million a second")
    if options.output:
        Path(options.output).write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
