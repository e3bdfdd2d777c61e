#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the skull CT of Debian's package invesalius-examples as a .vti file.

256 x 256 x 108 voxels of 0.957 x 0.957 x 1.5 mm, in HU; x is right, y front, z up. The head rest is
taken out. The licence of the scan is that of the package (GPL-2); it is no part of this project.
"""

import argparse
import sys
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageMask
from vtkmodules.vtkImagingMorphological import vtkImageConnectivityFilter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

from participating_media.readers import UnreadableVolume, read_volume

CRANIUM = Path("/usr/share/doc/invesalius-examples/examples/Cranium.inv3")
AIR = -1024  # HU, what the scanner gives outside the body
SKIN = -300  # HU, between air and fat


def read_cranium(path: Path = CRANIUM) -> vtkImageData:
    """The scan without the head rest: all that does not hang together with the head is air."""
    if path == CRANIUM and not path.exists():
        raise UnreadableVolume(f"{path}: no such file; apt-get install invesalius-examples")
    scan = read_volume(path)
    head = vtkImageConnectivityFilter()
    head.SetInputData(scan)
    head.SetScalarRange(SKIN, scan.GetScalarRange()[1])
    head.SetExtractionModeToLargestRegion()
    head.SetLabelScalarTypeToUnsignedChar()
    alone = vtkImageMask()
    alone.SetInputData(0, scan)
    alone.SetInputConnection(1, head.GetOutputPort())
    alone.SetMaskedOutputValue(AIR)
    alone.Update()
    return alone.GetOutput()


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("input", nargs="?", type=Path, default=CRANIUM,
                        help="the InVesalius project (default: where the package puts it)")
    parser.add_argument("--output", type=Path, default=Path("cranium.vti"))
    arguments = parser.parse_args()
    try:
        image = read_cranium(arguments.input)
    except UnreadableVolume as error:
        print(f"cranium.py: {error}", file=sys.stderr)
        return 2
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(arguments.output))
    writer.SetInputData(image)
    if not writer.Write():
        print(f"cranium.py: cannot write {arguments.output}", file=sys.stderr)
        return 2
    print(arguments.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
