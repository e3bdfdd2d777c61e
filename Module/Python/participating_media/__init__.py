# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Participating media for VTK: single scattering in vtkImageData.

Its classes are used in any VTK pipeline:

- ``vtkSingleScatteringVolumeMapper``: a ``vtkVolumeMapper`` that renders by single scattering;
- ``vtkParticipatingMedium``: what fills the volume, in physical units;
- ``vtkSingleScatteringReference``: the same image on the CPU, in double precision;
- ``vtkBackToFrontVolumeCuller``: has a renderer draw several volumes in the right order;
- ``vtkMediumStatistics``: what the mapper did, as ``mapper.GetStatistics()`` returns it.

``participating_media.readers`` reads volumes by path, ``participating_media.presets`` has volume
properties for common data, ``participating_media.picture`` writes pictures, and the command line
``participating-media`` (or ``python3 -m participating_media``) joins them.
"""

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers VTK's OpenGL factories
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .vtkParticipatingMediaRendering import (
    vtkBackToFrontVolumeCuller,
    vtkMediumStatistics,
    vtkSingleScatteringVolumeMapper,
)
from .vtkParticipatingMedium import vtkParticipatingMedium, vtkSingleScatteringReference

__all__ = [
    "vtkBackToFrontVolumeCuller",
    "vtkMediumStatistics",
    "vtkParticipatingMedium",
    "vtkSingleScatteringReference",
    "vtkSingleScatteringVolumeMapper",
]
