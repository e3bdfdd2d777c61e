"""Participating media for VTK: single scattering in vtkImageData.

The package holds three classes, to be used in any VTK pipeline:

- ``vtkSingleScatteringVolumeMapper``: a ``vtkVolumeMapper`` that renders by single scattering;
- ``vtkParticipatingMedium``: what fills the volume, in physical units;
- ``vtkSingleScatteringReference``: the same image on the CPU, in double precision.
"""

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers VTK's OpenGL factories
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401

from .vtkParticipatingMedium import vtkParticipatingMedium
from .vtkParticipatingMediaRendering import vtkMediumStatistics, vtkSingleScatteringVolumeMapper

__all__ = ["vtkMediumStatistics", "vtkParticipatingMedium", "vtkSingleScatteringVolumeMapper"]
