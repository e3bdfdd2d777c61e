#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Joins the pictures of CT.py and FogCube.py to the one in the README: the CT on the left, on the
right the three modes of the cube, each a third as high.

    CT.py --size 600 --output ct.png; FogCube.py --size 200 --output cube.png
    montage.py ct.png cube.png --output Module/Documentation/images/examples.png
"""

import argparse

from vtkmodules.vtkFiltersCore import vtkImageAppend
from vtkmodules.vtkImagingCore import vtkExtractVOI, vtkImageChangeInformation
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

parser = argparse.ArgumentParser(description=__doc__.split(":")[0])
parser.add_argument("ct", help="the picture of CT.py, of size 3 n")
parser.add_argument("cube", help="the picture of FogCube.py, of size n")
parser.add_argument("--output", default="examples.png", help="the PNG to write")
options = parser.parse_args()

left, right = vtkPNGReader(), vtkPNGReader()
left.SetFileName(options.ct)
right.SetFileName(options.cube)
right.Update()
size = right.GetOutput().GetDimensions()[1]
column = vtkImageAppend()
column.SetAppendAxis(1)
for mode in (2, 1, 0):  # images begin at the bottom
    picture = vtkExtractVOI()
    picture.SetInputConnection(right.GetOutputPort())
    picture.SetVOI(mode * size, (mode + 1) * size - 1, 0, size - 1, 0, 0)
    at_zero = vtkImageChangeInformation()
    at_zero.SetInputConnection(picture.GetOutputPort())
    at_zero.SetOutputExtentStart(0, 0, 0)
    column.AddInputConnection(at_zero.GetOutputPort())
both = vtkImageAppend()
both.AddInputConnection(left.GetOutputPort())
both.AddInputConnection(column.GetOutputPort())
writer = vtkPNGWriter()
writer.SetCompressionLevel(9)
writer.SetFileName(options.output)
writer.SetInputConnection(both.GetOutputPort())
writer.Write()
print(options.output)
