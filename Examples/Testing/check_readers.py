#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Writes one small volume in every format that the examples read, and checks that it comes back.

usage: check_readers.py FOLDER"""

import gzip
import plistlib
import struct
import sys
import tarfile
from io import BytesIO
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkNIFTIImageWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

from participating_media.readers import read_volume

#: Square pixels, since vtkDICOMImageReader takes the distance of rows for that of columns, and more
#: than nine columns, since vtkNrrdReader takes fewer for the components of one voxel.
SIZE, SPACING = (12, 4, 3), (0.5, 0.5, 2.0)
COLUMNS, ROWS, SLICES = SIZE


def counted() -> vtkImageData:
    """CT numbers -1000, -999, ... in the order of the voxels: no two are the same."""
    image = vtkImageData()
    image.SetDimensions(SIZE)
    image.SetSpacing(SPACING)
    image.AllocateScalars(4, 1)  # VTK_SHORT
    scalars = image.GetPointData().GetScalars()
    for i in range(scalars.GetNumberOfTuples()):
        scalars.SetTuple1(i, i - 1000)
    return image


def write_nrrd(path: Path, image: vtkImageData, encoding: str) -> None:
    voxels = voxel_bytes(image)
    header = ("NRRD0004\ntype: short\ndimension: 3\nspace: right-anterior-superior\n"
              "sizes: 12 4 3\nspace directions: (0.5,0,0) (0,0.5,0) (0,0,2)\nendian: little\n"
              f"encoding: {encoding}\n\n")
    path.write_bytes(header.encode() + (gzip.compress(voxels) if encoding == "gzip" else voxels))


def voxel_bytes(image: vtkImageData) -> bytes:
    scalars = image.GetPointData().GetScalars()
    count = scalars.GetNumberOfTuples()
    return struct.pack(f"<{count}h", *(int(scalars.GetTuple1(i)) for i in range(count)))


def rows_from_right_to_left(image: vtkImageData) -> list[tuple[int, ...]]:
    """The rows of the image in order, each as a scanner stores it: its columns run to the left."""
    voxels = struct.unpack(f"<{COLUMNS * ROWS * SLICES}h", voxel_bytes(image))
    return [voxels[i:i + COLUMNS][::-1] for i in range(0, len(voxels), COLUMNS)]


def packed(rows, offset: int = 0) -> bytes:
    return b"".join(struct.pack(f"<{COLUMNS}h", *(voxel + offset for voxel in row)) for row in rows)


def write_inv3(path: Path, image: vtkImageData) -> None:
    project = {"matrix": {"dtype": "int16", "filename": "matrix.dat",
                          "shape": [SLICES, ROWS, COLUMNS]}, "spacing": list(SPACING)}
    contents = {"main.plist": plistlib.dumps(project),
                "matrix.dat": packed(rows_from_right_to_left(image))}
    with tarfile.open(path, "w:gz") as archive:
        for name, content in contents.items():
            member = tarfile.TarInfo(f"project/{name}")
            member.size = len(content)
            archive.addfile(member, BytesIO(content))


def element(group: int, number: int, kind: str, value: bytes) -> bytes:
    """A data element of DICOM, explicit VR little endian (PS3.5, 7.1.2)."""
    value += b"\0" * (len(value) % 2) if kind == "UI" else b" " * (len(value) % 2)
    head = struct.pack("<HH2s", group, number, kind.encode())
    if kind in ("OB", "OW"):
        return head + struct.pack("<HI", 0, len(value)) + value
    return head + struct.pack("<H", len(value)) + value


def write_dicom(folder: Path, image: vtkImageData) -> None:
    """One slice a file, rows from front to back, stored + 1000 with an intercept of -1000."""
    folder.mkdir(exist_ok=True)
    rows = rows_from_right_to_left(image)
    for k in range(SLICES):
        stored = packed(reversed(rows[ROWS * k:ROWS * (k + 1)]), 1000)
        body = b"".join([
            element(0x0008, 0x0060, "CS", b"CT"),
            element(0x0020, 0x000E, "UI", b"1.2.3"),
            element(0x0020, 0x0013, "IS", str(k + 1).encode()),
            element(0x0020, 0x0032, "DS", f"0\\0\\{SPACING[2] * k}".encode()),
            element(0x0020, 0x0037, "DS", b"1\\0\\0\\0\\1\\0"),
            element(0x0028, 0x0002, "US", struct.pack("<H", 1)),
            element(0x0028, 0x0010, "US", struct.pack("<H", ROWS)),
            element(0x0028, 0x0011, "US", struct.pack("<H", COLUMNS)),
            element(0x0028, 0x0030, "DS", f"{SPACING[1]}\\{SPACING[0]}".encode()),
            element(0x0028, 0x0100, "US", struct.pack("<H", 16)),
            element(0x0028, 0x0101, "US", struct.pack("<H", 16)),
            element(0x0028, 0x0102, "US", struct.pack("<H", 15)),
            element(0x0028, 0x0103, "US", struct.pack("<H", 1)),
            element(0x0028, 0x1052, "DS", b"-1000"),
            element(0x0028, 0x1053, "DS", b"1"),
            element(0x7FE0, 0x0010, "OW", stored)])
        syntax = element(0x0002, 0x0010, "UI", b"1.2.840.10008.1.2.1")
        meta = element(0x0002, 0x0000, "UL", struct.pack("<I", len(syntax))) + syntax
        (folder / f"{k}.dcm").write_bytes(b"\0" * 128 + b"DICM" + meta + body)


def write_all(folder: Path, image: vtkImageData) -> list[Path]:
    paths = [folder / f"counted.{kind}" for kind in ("vti", "nii", "nii.gz", "mhd", "mha")]
    for path in paths:
        writer = {"vti": vtkXMLImageDataWriter, "nii": vtkNIFTIImageWriter,
                  "gz": vtkNIFTIImageWriter}.get(path.suffix[1:], vtkMetaImageWriter)()
        writer.SetFileName(str(path))
        if path.suffix == ".mhd":
            writer.SetRAWFileName(str(path.with_suffix(".raw")))
        writer.SetInputData(image)
        writer.Write()
    for encoding in ("raw", "gzip"):
        paths.append(folder / f"counted_{encoding}.nrrd")
        write_nrrd(paths[-1], image, encoding)
    write_inv3(folder / "counted.inv3", image)
    write_dicom(folder / "dicom", image)
    return [*paths, folder / "counted.inv3", folder / "dicom"]


def main() -> int:
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    image = counted()
    expected = voxel_bytes(image)
    wrong = 0
    for path in write_all(folder, image):
        found = read_volume(path)
        same = (found.GetDimensions() == SIZE and voxel_bytes(found) == expected
                and all(abs(a - b) < 1e-6 for a, b in zip(found.GetSpacing(), SPACING)))
        if not same:
            wrong += 1
            print(f"{path}: {found.GetDimensions()} {found.GetSpacing()}, "
                  f"range {found.GetScalarRange()}: not what was written")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
