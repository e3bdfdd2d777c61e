# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes that every renderer is given, and the files that hold what they answered.

Needs NumPy only, so that each renderer can be run from a Python of its own. Lengths are world units,
the box is centred on the origin, and grid values sit on its corners and faces.
"""

import os
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

RESULTS = Path(__file__).parent / "Results"


@dataclass(frozen=True)
class Scene:
    """One grid, one light, one camera."""

    name: str
    grid: str  #: smooth, cloud, binary or uniform
    extinction: float  #: where the grid is 1, per world unit; times the tint
    g: float  #: mean cosine of Henyey and Greenstein's phase function
    light: tuple  #: direction towards a directional light, or the position of a point light
    point_light: bool = False  #: intensity 1 and the inverse square; else irradiance 1
    size: tuple = (1.0, 1.0, 1.0)  #: edges of the box
    albedo: float = 1.0
    eye: tuple = (1.1, 0.8, 1.9)
    view_angle: float = 35.0  #: full angle, degrees; the image is square
    points: int = 32  #: of the grid, along each axis
    pixels: int = 32
    zero_on_faces: bool = False  #: fade the grid to 0 towards the faces of the box
    tint: tuple = (1.0, 1.0, 1.0)  #: of the extinction, red, green and blue

    def channels(self) -> dict:
        """The channels that are compared, and what their results' names end in."""
        grey = len(set(self.tint)) == 1
        return {1: ""} if grey else {0: "-red", 1: "-green", 2: "-blue"}


MITSUBA = (
    Scene("uniform", "uniform", 3, 0.6, (0.5, 1, 0.8), points=9),
    Scene("smooth", "smooth", 8, 0, (0.5, 1, 0.8), albedo=0.8),
    Scene("cloud", "cloud", 20, 0.6, (-0.6, 0.7, 0.3)),
    Scene("binary", "binary", 8, -0.4, (1, 0.4, 0.5)),
    Scene("cloud-flat-box", "cloud", 20, 0.6, (-0.2, 0.9, -0.6), size=(1, 0.7, 0.4)),
    Scene("cloud-point-light", "cloud", 20, 0.6, (-0.5, 0.9, 0.4), point_light=True),
    Scene("cloud-chromatic", "cloud", 20, 0.3, (-0.4, 0.8, 0.5), albedo=0.9, tint=(0.3, 0.6, 1)),
)

#: vdb_render has directional lights and isotropic scattering only, cubic voxels, and a field that
#: falls to 0 outside of the grid.
OPENVDB = (
    Scene("smooth-faded", "smooth", 8, 0, (0.5, 1, 0.8), zero_on_faces=True),
    Scene("cloud-isotropic", "cloud", 20, 0, (-0.6, 0.7, 0.3)),
    Scene("binary-isotropic", "binary", 8, 0, (1, 0.4, 0.5)),
)

#: What VTK's own volumetric scattering is asked for: a cube, and the box that it gets wrong.
VTK = (
    Scene("vtk-cube", "cloud", 20, 0.6, (-0.6, 0.7, 0.3)),
    Scene("vtk-flat-box-along-x", "cloud", 20, 0.6, (1, 0, 0), size=(1, 0.7, 0.4)),
    Scene("vtk-flat-box-along-y", "cloud", 20, 0.6, (0, 1, 0), size=(1, 0.7, 0.4)),
    Scene("vtk-flat-box-diagonal", "cloud", 20, 0.6, (1, 1, 0), size=(1, 0.7, 0.4)),
)


def grid_of(scene: Scene) -> np.ndarray:
    """The density, float32, indexed [z, y, x]. The fixtures come from the program ExportFixture,
    which PARTICIPATING_MEDIA_EXPORT_FIXTURE names."""
    n = scene.points
    if scene.grid == "uniform":
        return np.ones((n, n, n), np.float32)
    program = os.environ.get("PARTICIPATING_MEDIA_EXPORT_FIXTURE")
    if not program:
        raise RuntimeError("PARTICIPATING_MEDIA_EXPORT_FIXTURE is not set: found no program that "
                           "exports the fixtures; build the target ExportFixture and name it")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "grid.raw"
        subprocess.run([program, scene.grid, str(n), str(file)], check=True)
        grid = np.fromfile(file, np.float32).reshape(n, n, n)
    if scene.zero_on_faces:
        x = np.linspace(0, 1, n)
        fade = 4 * x * (1 - x)
        grid *= (fade[:, None, None] * fade[:, None] * fade).astype(np.float32)
    return grid


def spacing_of(scene: Scene) -> np.ndarray:
    return np.array(scene.size) / (scene.points - 1)


def write_result(path: Path, head: dict, image: np.ndarray, error: np.ndarray) -> None:
    """Two square images, first row at the bottom: radiance and its standard error per pixel."""
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = [f"# {key}: {value}" for key, value in head.items()]
    lines.append("# columns: radiance, standard error; pixels from the bottom left, x fastest")
    rows = zip(image.ravel(), error.ravel())
    path.write_text("\n".join(lines + [f"{value:.7g},{sigma:.3g}" for value, sigma in rows]) + "\n")


def read_result(path: Path) -> tuple:
    """What write_result wrote: the head, the radiance and its standard error."""
    head, rows = {}, []
    for line in path.read_text().splitlines():
        if line.startswith("# "):
            key, _, value = line[2:].partition(": ")
            head[key] = value
        else:
            rows.append([float(number) for number in line.split(",")])
    side = int(round(len(rows) ** 0.5))
    image, error = np.array(rows).T.reshape(2, side, side)
    return head, image, error
