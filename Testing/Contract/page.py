# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The page of what was found, and pictures of it."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

HEAD = """# What VTK's own volume mapper does, and what this one does

Written by `Testing/Contract/run`, not by hand. Each scene is drawn by `vtkGPUVolumeRayCastMapper` of VTK
{version} and by `vtkSingleScatteringVolumeMapper`, with the same property. Both are compared where
they mean the same: *silhouettes*, the pixels that the volume changes (intersection over union), and
*transmittance*, what is left of a white background behind a black medium (mean difference over the
picture, where 1/255 = 0.0039 is one step of the window). {scenes} scenes.
"""


def cell(text):
    return " ".join(text.split()).replace("|", "\\|")


def page(rows):
    """Markdown, a table a group."""
    lines = [HEAD.format(version=vtkVersion.GetVTKVersion(),
                         scenes=sum(len(group) for group in rows.values()))]
    for group, members in rows.items():
        lines += [f"## {group}", "", "| feature | VTK's own | ours | measured |",
                  "| --- | --- | --- | --- |"]
        for row in members:
            ours = row.ours + "".join(f" **FAILED: {problem}**" for problem in row.problems)
            lines.append("| " + " | ".join(cell(text) for text in
                                           (row.feature, row.theirs, ours, row.numbers)) + " |")
        lines.append("")
    return "\n".join(lines)


def write_picture(picture, path):
    height, width, _ = picture.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    pixels = np.round(picture * 255).astype(np.uint8).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(pixels, deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(path).replace(" ", "_"))
    writer.Write()
