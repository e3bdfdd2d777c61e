# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads a volume by its path with the reader that VTK has for it."""

from __future__ import annotations

import os
import plistlib
import re
import tarfile
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageFlip
from vtkmodules.vtkIOImage import (
    vtkDICOMImageReader,
    vtkImageImport,
    vtkMetaImageReader,
    vtkNIFTIImageReader,
    vtkNrrdReader,
)
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

#: What ``read_volume`` knows: the endings of a file's name, and the class that reads it.
READERS = {
    (".vti",): vtkXMLImageDataReader,
    (".nii", ".nii.gz"): vtkNIFTIImageReader,
    (".mhd", ".mha"): vtkMetaImageReader,
    (".nrrd", ".nhdr"): vtkNrrdReader,
}


class UnreadableVolume(ValueError):
    """No volume could be read; the message is one line: the path, what was found, what to do."""


def read_volume(path: str | os.PathLike[str]) -> vtkImageData:
    """Returns the volume that the file, or the folder of DICOM slices, holds.

    A ``.vti``, ``.nii``, ``.nii.gz``, ``.mhd``, ``.mha``, ``.nrrd`` or ``.nhdr`` file is read by
    VTK's reader for it, a folder by ``vtkDICOMImageReader`` (CT numbers in HU), an InVesalius
    project (``.inv3``) by :func:`read_invesalius`. Lengths are those of the file, commonly mm.
    Raises :class:`UnreadableVolume`.
    """
    path = Path(path)
    if not path.exists():
        raise UnreadableVolume(f"{path}: no such file or folder; check the path")
    name = path.name.lower()
    if path.is_dir():
        reader = vtkDICOMImageReader()
        reader.SetDirectoryName(str(path))
        # VTK gives axial slices as left, front, down; half a turn makes right, front, up of it.
        return _reversed(_reversed(_update(reader, path), 0), 2)
    elif name.endswith(".inv3"):
        return read_invesalius(path)
    else:
        kinds = [kind for endings, kind in READERS.items() if name.endswith(endings)]
        if not kinds:
            known = " ".join(ending for endings in READERS for ending in endings)
            raise UnreadableVolume(
                f"{path}: unknown kind of file; expected a DICOM folder or one of {known} .inv3")
        reader = kinds[0]()
        reader.SetFileName(str(path))
    return _update(reader, path)


def _update(reader, path: Path) -> vtkImageData:
    """Runs the reader and turns whatever it complains about into one exception."""
    previous, verbosity = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff()
    messages = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(messages)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        if path.is_file() and not reader.CanReadFile(str(path)):
            complaint = "its content is not what its name says"
        else:
            reader.Update()
            complaint = _first_error(messages.GetOutput())
    finally:
        vtkOutputWindow.SetInstance(previous)
        vtkLogger.SetStderrVerbosity(verbosity)
    image = reader.GetOutput()
    if not complaint and (image.GetNumberOfPoints() == 0 or not image.GetPointData().GetScalars()):
        complaint = "there are no voxels in it"
    if complaint:
        raise UnreadableVolume(
            f"{path}: {reader.GetClassName()} cannot read it: {complaint}; "
            "give a complete file of that kind")
    return image


def _reversed(image: vtkImageData, axis: int) -> vtkImageData:
    """The image with its voxels in the reverse order along an axis."""
    flip = vtkImageFlip()
    flip.SetInputData(image)
    flip.SetFilteredAxis(axis)
    flip.Update()
    return flip.GetOutput()


def _first_error(text: str) -> str:
    """The words of the first error in what VTK wrote to its output window, or nothing."""
    match = re.search(r"ERROR: In [^\n]*\n[^\n]*?\(0x[0-9a-f]+\): ([^\n]*)", text)
    if match:
        return match.group(1).strip().rstrip(".")
    return "an error without words" if "ERROR" in text else ""


def read_invesalius(path: str | os.PathLike[str]) -> vtkImageData:
    """Returns the volume of an InVesalius project: a gzipped tar of a plist and raw voxels.

    The rows of a project run from the back of the head to its face. DICOM's columns run to the
    patient's left, so that the columns are reversed here to make a right-handed frame, in which x
    is right, y front and z up. The lengths are mm. Raises :class:`UnreadableVolume`.
    """
    try:
        with tarfile.open(path, "r:gz") as archive:
            members = {Path(member.name).name: member for member in archive.getmembers()}
            project = plistlib.load(archive.extractfile(members["main.plist"]))
            matrix = project["matrix"]
            slices, rows, columns = matrix["shape"]
            voxels = archive.extractfile(members[matrix["filename"]]).read()
            spacing = [float(length) for length in project["spacing"]]
    except (OSError, EOFError, KeyError, ValueError, TypeError, tarfile.TarError) as error:
        raise UnreadableVolume(
            f"{path}: not an InVesalius project ({type(error).__name__}: {error}); "
            "give an .inv3 file as InVesalius saves it") from error
    size = 2 * slices * rows * columns
    if matrix["dtype"] != "int16" or len(voxels) != size:
        raise UnreadableVolume(
            f"{path}: {len(voxels)} bytes of {matrix['dtype']}, expected {size} of int16; "
            "save the project again")
    source = vtkImageImport()
    source.SetDataScalarTypeToShort()
    source.SetNumberOfScalarComponents(1)
    source.SetWholeExtent(0, columns - 1, 0, rows - 1, 0, slices - 1)
    source.SetDataExtentToWholeExtent()
    source.SetDataSpacing(spacing)
    source.CopyImportVoidPointer(voxels, size)
    source.Update()
    return _reversed(source.GetOutput(), 0)
