# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Volume properties that give a medium for common data; the property is VTK's own class."""

from __future__ import annotations

import math

from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolumeProperty

#: CT number (HU), extinction (1/mm), albedo (R, G, B): skin and fat as a thin fog, bone dense.
HOUNSFIELD = (
    (-400, 0.0, (0.80, 0.58, 0.46)),
    (-150, 0.006, (0.85, 0.56, 0.43)),
    (100, 0.009, (0.88, 0.55, 0.42)),
    (250, 0.02, (0.92, 0.74, 0.60)),
    (600, 0.25, (0.95, 0.88, 0.78)),
    (1500, 0.90, (0.99, 0.97, 0.93)),
)


def property_of(nodes) -> vtkVolumeProperty:
    """A property from nodes (scalar, extinction per world unit, (R, G, B) albedo), linear between.

    VTK's opacity is that of one unit of length, alpha = 1 - exp(-extinction); straight lines in
    extinction are curves in opacity, followed here by short pieces.
    """
    opacity, albedo = vtkPiecewiseFunction(), vtkColorTransferFunction()
    pieces = 8
    for (x0, sigma0, _), (x1, sigma1, _) in zip(nodes, nodes[1:]):
        for piece in range(pieces + 1):
            t = piece / pieces
            sigma = sigma0 + t * (sigma1 - sigma0)
            opacity.AddPoint(x0 + t * (x1 - x0), -math.expm1(-sigma))
    for value, _, colour in nodes:
        albedo.AddRGBPoint(value, *colour)
    medium = vtkVolumeProperty()
    medium.SetScalarOpacity(opacity)
    medium.SetColor(albedo)
    medium.SetScalarOpacityUnitDistance(1.0)
    medium.SetInterpolationTypeToLinear()
    return medium


def hounsfield_property() -> vtkVolumeProperty:
    """For CT in HU and mm: see :data:`HOUNSFIELD`."""
    return property_of(HOUNSFIELD)


def ramp_property(minimum: float, maximum: float, extinction: float) -> vtkVolumeProperty:
    """White fog: no extinction up to minimum, then a ramp up to extinction (per world unit)."""
    return property_of(((minimum, 0.0, (1.0, 1.0, 1.0)), (maximum, extinction, (1.0, 1.0, 1.0))))
