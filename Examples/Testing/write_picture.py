#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a picture that check_picture.py must reject.

usage: write_picture.py black|clipped FILE.png"""

import sys
from pathlib import Path

from vtkmodules.vtkImagingSources import vtkImageGridSource
from vtkmodules.vtkIOImage import vtkPNGWriter


def main() -> None:
    value = {"black": 0, "clipped": 255}[sys.argv[1]]
    path = Path(sys.argv[2])
    path.parent.mkdir(parents=True, exist_ok=True)
    grid = vtkImageGridSource()
    grid.SetDataExtent(0, 63, 0, 63, 0, 0)
    grid.SetGridSpacing(2, 2, 0)
    grid.SetLineValue(value)
    grid.SetFillValue(0)
    grid.SetDataScalarTypeToUnsignedChar()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(grid.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main()
