#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs a command that writes a PNG, and fails if the picture is black, flat or clipped.

usage: check_picture.py PNG PICTURES COMMAND ...; PICTURES are side by side, each is checked."""

import subprocess
import sys
from pathlib import Path

from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkIOImage import vtkPNGReader

#: A subject fills at least this part of each picture; every example's camera is set so.
SUBJECT = 0.08
#: At most this part of a picture may be white in any channel; the labels alone are below it.
CLIPPED = 0.02
#: A picture with fewer levels than this shows a silhouette and no light in it.
LEVELS = 24


def faults(image, left: int, right: int) -> list[str]:
    """What is wrong with the columns left to right - 1 of the picture."""
    part = vtkExtractVOI()
    part.SetInputData(image)
    height = image.GetDimensions()[1]
    part.SetVOI(left, right - 1, 0, height - 1, 0, 0)
    part.Update()
    scalars = part.GetOutput().GetPointData().GetScalars()
    texels = [scalars.GetTuple(i) for i in range(scalars.GetNumberOfTuples())]
    seen = sum(max(texel) > 12 for texel in texels) / len(texels)
    clipped = sum(max(texel) >= 255 for texel in texels) / len(texels)
    levels = len({round(max(texel)) for texel in texels})
    found = []
    if seen < SUBJECT:
        found.append(f"{seen:.1%} of it is not black, expected at least {SUBJECT:.0%}")
    if clipped > CLIPPED:
        found.append(f"{clipped:.1%} of it is clipped, expected at most {CLIPPED:.0%}")
    if levels < LEVELS:
        found.append(f"{levels} levels of grey, expected at least {LEVELS}")
    return found


def main() -> int:
    path, count, command = Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3:]
    path.unlink(missing_ok=True)
    done = subprocess.run(command, check=False)
    if done.returncode:
        print(f"{command[0]} ended with {done.returncode}")
        return 1
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width = image.GetDimensions()[0]
    wrong = 0
    for i in range(count):
        for fault in faults(image, i * width // count, (i + 1) * width // count):
            print(f"{path}, picture {i + 1} of {count}: {fault}")
            wrong += 1
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
