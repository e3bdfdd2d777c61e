#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A procedural, non-convex engine-like block: a stand-in for the well-known Engine.

256 x 256 x 128 voxels of uint8 with spacing 1, as the real one: 0 outside, 120 in the cast, 230 in
the bolts and cylinder liners. Run as a script, it writes the block as a .vti file.
"""

import argparse
import hashlib
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkBox, vtkCylinder, vtkImageData, vtkImplicitBoolean
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkImagingMath import vtkImageMathematics
from vtkmodules.vtkImagingCore import vtkImageThreshold
from vtkmodules.vtkIOImage import vtkImageReader2
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

SIZE = (256, 256, 128)
CAST, STEEL = 120, 230
#: SHA-512 of the real Engine, 256 x 256 x 128 raw bytes.
ENGINE_SHA512 = (
    "f17228483b1b5edb90146eac90ba979531629a2880d9e7a0493a98290da8af6a"
    "c2cf80f2c567a3d08695dc7dd854916c861dad8856b2d5721501954e913de13f")


def combine(operation, *functions):
    """A vtkImplicitBoolean; Union, Intersection or (first minus the others) Difference."""
    boolean = vtkImplicitBoolean()
    getattr(boolean, f"SetOperationTypeTo{operation}")()
    for function in functions:
        boolean.AddFunction(function)
    return boolean


def box(*bounds):
    """The box of x0, x1, y0, y1, z0, z1."""
    function = vtkBox()
    function.SetBounds(bounds)
    return function


def rod(axis, center, radius, low, high):
    """A cylinder along axis 0, 1 or 2 from low to high; center has the other two coordinates."""
    position, bounds = list(center), [-1000, 1000] * 3
    position.insert(axis, 0)
    bounds[2 * axis:2 * axis + 2] = low, high
    cylinder = vtkCylinder()
    cylinder.SetAxis([float(i == axis) for i in range(3)])
    cylinder.SetCenter(position)
    cylinder.SetRadius(radius)
    return combine("Intersection", cylinder, box(*bounds))


def cast():
    """The block, its flange and pipes, less bores, water jackets, crank case and oil channels."""
    bores = [(84, 128), (172, 128)]
    bolts = [(x, y) for x in (28, 128, 228) for y in (56, 200)]
    pipes = [(84, 72), (172, 72)]
    solid = combine(
        "Union", box(34, 222, 74, 182, 14, 100), box(14, 242, 42, 214, 92, 106),
        *[rod(2, at, 46, 14, 112) for at in bores], *[rod(1, at, 20, 18, 90) for at in pipes],
        rod(0, (182, 36), 26, 22, 234))
    jackets = [combine("Difference", rod(2, at, 43, 34, 86), rod(2, at, 37, 30, 90))
               for at in bores]
    hollow = combine(
        "Union", *[rod(2, at, 30, 0, 128) for at in bores], *jackets,
        *[rod(1, at, 13, 0, 100) for at in pipes], rod(0, (128, 26), 18, 0, 256),
        rod(0, (182, 36), 17, 0, 256), *[rod(2, at, 5, 80, 128) for at in bolts],
        rod(1, (128, 50), 9, 0, 256), rod(0, (86, 84), 6, 0, 256), rod(0, (170, 84), 6, 0, 256))
    return combine("Difference", solid, hollow)


def steel():
    """Liners in the bores, and bolts of which every second one stands out of the flange."""
    liners = [combine("Difference", rod(2, at, 30, 20, 116), rod(2, at, 26, 0, 128))
              for at in [(84, 128), (172, 128)]]
    bolts = [rod(2, (x, y), 5, 70, 120) for x, y in ((28, 56), (228, 56), (128, 200))]
    heads = [rod(2, (x, y), 10, 106, 118) for x, y in ((28, 56), (228, 56), (128, 200))]
    return combine("Union", *liners, *bolts, *heads)


def filled(function, value):
    """uint8 voxels: value where the function is negative, else 0."""
    samples = vtkSampleFunction()
    samples.SetImplicitFunction(function)
    samples.SetSampleDimensions(SIZE)
    samples.SetModelBounds(0, SIZE[0] - 1, 0, SIZE[1] - 1, 0, SIZE[2] - 1)
    samples.ComputeNormalsOff()
    samples.SetOutputScalarTypeToFloat()
    voxels = vtkImageThreshold()
    voxels.SetInputConnection(samples.GetOutputPort())
    voxels.ThresholdByLower(0)
    voxels.SetInValue(value)
    voxels.SetOutValue(0)
    voxels.SetOutputScalarTypeToUnsignedChar()
    return voxels


def engine_block() -> vtkImageData:
    """The stand-in."""
    parts = filled(cast(), CAST), filled(steel(), STEEL)
    both = vtkImageMathematics()
    both.SetOperationToMax()
    for input_port, part in enumerate(parts):
        both.SetInputConnection(input_port, part.GetOutputPort())
    both.Update()
    return both.GetOutput()


def read_engine(path: Path) -> tuple[vtkImageData, str]:
    """The real Engine from its raw file, and a label that says whether it is that file."""
    voxels = path.read_bytes()
    size = SIZE[0] * SIZE[1] * SIZE[2]
    if len(voxels) != size:
        raise ValueError(f"{path}: {len(voxels)} bytes, expected {size}; give the raw uint8 Engine")
    known = hashlib.sha512(voxels).hexdigest() == ENGINE_SHA512
    reader = vtkImageReader2()
    reader.SetFileName(str(path))
    reader.SetFileDimensionality(3)
    reader.SetDataExtent(0, SIZE[0] - 1, 0, SIZE[1] - 1, 0, SIZE[2] - 1)
    reader.SetDataScalarTypeToUnsignedChar()
    reader.FileLowerLeftOn()
    reader.Update()
    return reader.GetOutput(), "Engine" if known else f"{path.name}, not the known Engine"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=Path("engine_block.vti"))
    output = parser.parse_args().output
    output.parent.mkdir(parents=True, exist_ok=True)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(output))
    writer.SetInputData(engine_block())
    if not writer.Write():
        raise SystemExit(f"cannot write {output}")
    print(output)


if __name__ == "__main__":
    main()
