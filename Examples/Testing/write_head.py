#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a small head-like scan in HU and mm: a skull of 1000 HU in a scalp of 40 HU, hollow.

usage: write_head.py FILE.vti"""

import sys
from pathlib import Path

from vtkmodules.vtkImagingSources import vtkImageEllipsoidSource
from vtkmodules.vtkImagingMath import vtkImageMathematics
from vtkmodules.vtkImagingCore import vtkImageChangeInformation
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

LAST = 63


def shell(inner: float, outer: float, value: float):
    """The value between two concentric ellipsoids, radii in voxels, and 0 elsewhere."""
    sources = []
    for radius in (outer, inner):
        source = vtkImageEllipsoidSource()
        source.SetWholeExtent(0, LAST, 0, LAST, 0, LAST)
        source.SetCenter([LAST / 2] * 3)
        source.SetRadius(radius, 1.15 * radius, radius)
        source.SetInValue(value)
        source.SetOutValue(0)
        source.SetOutputScalarTypeToShort()
        sources.append(source)
    return combine("Subtract", *sources)


def combine(operation: str, first, second):
    sum_of = vtkImageMathematics()
    getattr(sum_of, f"SetOperationTo{operation}")()
    sum_of.SetInputConnection(0, first.GetOutputPort())
    sum_of.SetInputConnection(1, second.GetOutputPort())
    sum_of.Update()
    return sum_of


def main() -> None:
    path = Path(sys.argv[1])
    path.parent.mkdir(parents=True, exist_ok=True)
    skull, scalp = shell(19, 22, 2024), shell(22, 25, 1064)
    layers = combine("Add", skull, scalp)
    air = vtkImageMathematics()
    air.SetOperationToAddConstant()
    air.SetConstantC(-1024)
    air.SetInputConnection(layers.GetOutputPort())
    scan = vtkImageChangeInformation()
    scan.SetInputConnection(air.GetOutputPort())
    scan.SetOutputSpacing(3, 3, 3)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(scan.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
