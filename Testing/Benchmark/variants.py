# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes other than the one that the benchmark is about: other boxes, phase functions, lights, functions,
cameras and data. All of 64³ voxels and 128 × 128 pixels."""

import numpy as np
from cranium import read_cranium
from points import setting
from vtkmodules.util.numpy_support import vtk_to_numpy

from participating_media.readers import UnreadableVolume

#: Three more lights of four: above, from behind and grazing.
MORE_LIGHTS = ((0, 1, 0.2), (-0.7, 0.4, -1), (1, 0.1, -0.3))
#: Positions of a lamp beside the cube and inside of it, and a spot's half angle, degrees.
BESIDE, INSIDE, CONE = (0.5, 0.9, 0.4), (0.1, 0.2, 0.1), 15
#: A camera in the volume, with a wide view.
WITHIN = {"eye": (0.15, 0.1, 0.3), "view_angle": 70}
#: HU at which the CT's extinction begins and where it is largest.
SOFT_TISSUE, BONE = 100, 1500
FLAT = {"size": (1, 0.7, 0.4), "g": 0.6}
FLAT_WORDS = "1 × 0.7 × 0.4 box, g = 0.6"
#: Directions of light in which VTK's own scattering errs differently in a box that is no cube.
FLAT_LIGHTS = {"along x": (1, 0, 0), "along y": (0, 1, 0), "at 45°": (1, 1, 0)}


def of(field: str, words: str, **changes):
    return setting(field, 64, 128, words=words, **changes)


def swept(field: str) -> list:
    """Drawn at several allowed errors."""
    return [of(field, FLAT_WORDS, **FLAT), of(field, "cube, g = 0.6", g=0.6),
            of(field, "cube, g = −0.4", g=-0.4), of(field, "cube, four lights", more_lights=MORE_LIGHTS)]


def tried(field: str) -> list:
    """Drawn at 1/255."""
    lamp = {"point_light": True, "light": BESIDE}
    return [of(field, "a point light beside the cube", **lamp),
            of(field, "a point light inside", point_light=True, light=INSIDE),
            of(field, "a spot light", cone=CONE, **lamp),
            of(field, "an opacity function with bends", bent=True),
            of(field, "the camera inside", **WITHIN)]


def flat_boxes() -> list:
    """What VTK's own scattering gets wrong."""
    return [of("cloud", f"{FLAT_WORDS}, light {words}", **{**FLAT, "light": light})
            for words, light in FLAT_LIGHTS.items()]


def ct(pixels: int = 128) -> tuple:
    """The head, its extinction a straight line in HU; None and why where it isn't installed."""
    try:
        image = read_cranium()
    except UnreadableVolume as reason:
        return None, str(reason).rpartition("; ")[2]
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(image.GetDimensions()[::-1])
    grid = np.clip((values.astype(np.float32) - SOFT_TISSUE) / (BONE - SOFT_TISSUE), 0, 1)
    edges = (np.array(image.GetDimensions()) - 1) * np.array(image.GetSpacing())
    return setting("CT", max(image.GetDimensions()), pixels, grid=grid, words="CT of a head",
                   size=tuple(edges / edges.max())), ""
