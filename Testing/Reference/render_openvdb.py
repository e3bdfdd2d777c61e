# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Renders the scenes by OpenVDB's vdb_render.

It marches with coefficients per voxel, has no phase function (isotropic scattering of 1, not of
1 / 4 pi, per steradian), and weakens shadows by its "gain", which is 0 here. The standard error holds
the change from twice the step, since there is no noise.
"""

import argparse
import datetime
import os
import subprocess
import tempfile

os.environ.setdefault("OPENCV_IO_ENABLE_OPENEXR", "1")

import numpy as np
import OpenEXR
import pyopenvdb
from tqdm import tqdm

import scenes


def write_vdb(scene: scenes.Scene, path: str) -> None:
    """The grid with its voxel centres where the mapper has its points. Cubic voxels only."""
    spacing = scenes.spacing_of(scene)
    grid = pyopenvdb.FloatGrid()
    grid.copyFromArray(np.ascontiguousarray(scenes.grid_of(scene).transpose(2, 1, 0)))
    grid.name = "density"
    grid.transform = pyopenvdb.createLinearTransform(voxelSize=float(spacing[0]))
    grid.transform.translate(tuple(-0.5 * np.array(scene.size)))
    pyopenvdb.write(path, grids=[grid])


def command_of(scene: scenes.Scene, volume: str, picture: str, step: float) -> list:
    def words(values):
        return ",".join(f"{value:.9g}" for value in values)

    light = np.array(scene.light) / np.linalg.norm(scene.light)
    per_voxel = scene.extinction * scenes.spacing_of(scene)[0]
    return ["vdb_render", volume, picture, "-compression", "none",
            "-res", f"{scene.pixels}x{scene.pixels}", "-fov", f"{scene.view_angle:.9g}",
            "-translate", words(scene.eye), "-lookat", "0,0,0", "-up", "0,1,0",
            "-light", words([*light, 1, 1, 1]), "-gain", "0", "-cutoff", "1e-9",
            "-scatter", words([per_voxel * scene.albedo] * 3),
            "-absorb", words([per_voxel * (1 - scene.albedo)] * 3),
            "-step", f"{step:g}", "-shadowstep", f"{step:g}"]


def render(scene: scenes.Scene, step: float, folder: str) -> np.ndarray:
    volume, picture = os.path.join(folder, "grid.vdb"), os.path.join(folder, "picture.exr")
    write_vdb(scene, volume)
    subprocess.run(command_of(scene, volume, picture, step), check=True, stdout=subprocess.DEVNULL)
    channels = OpenEXR.File(picture, separate_channels=True).channels()
    top_first = np.array(channels["G"].pixels, dtype=float)
    return top_first[::-1] / (4 * np.pi)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--step", type=float, default=0.0625,
                        help="of both rays, voxels (default: %(default)s)")
    parser.add_argument("scene", nargs="*", help="names of scenes (default: all)")
    arguments = parser.parse_args()
    version = subprocess.run(["vdb_render", "-version"], stdout=subprocess.PIPE, text=True,
                             check=False).stdout.splitlines()[0]
    chosen = [s for s in scenes.OPENVDB if not arguments.scene or s.name in arguments.scene]
    for scene in tqdm(chosen):
        with tempfile.TemporaryDirectory() as folder:
            coarse = render(scene, 2 * arguments.step, folder)
            image = render(scene, arguments.step, folder)
        head = {
            "renderer": f"vdb_render, {version}",
            "command": " ".join(command_of(scene, "grid.vdb", "picture.exr", arguments.step)),
            "scene": scene, "scale": "1 / 4 pi has been applied",
            "standard error": "none: the change from twice the step",
            "date": datetime.date.today().isoformat()}
        scenes.write_result(scenes.RESULTS / f"openvdb-{scene.name}.csv", head, image,
                            np.abs(image - coarse))
        tqdm.write(f"{scene.name}: mean {image.mean():.6g}, "
                   f"change from twice the step {np.abs(image - coarse).max() / image.max():.2g}")


if __name__ == "__main__":
    main()
