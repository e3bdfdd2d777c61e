# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Renders the scenes by Mitsuba 3: its volpath integrator, ended after the first scattering.

A medium whose extinction has a colour is rendered by volpathmis instead, which weighs the channels'
ways of sampling against each other: volpath samples by one of them and leaves the others to noise.

Rays go through pixel centres, as the mapper's do: the sensor of Mitsuba makes them, its integrator
follows them. The standard error of a pixel comes from independent batches.
"""

import argparse
import datetime

import mitsuba as mi
import numpy as np
from tqdm import tqdm

import scenes

BATCHES = 64
#: Seeds of one scene are apart from those of the next.
SEEDS = 100000


def integrator_of(scene: scenes.Scene) -> str:
    return "volpath" if len(scene.channels()) == 1 else "volpathmis"


def describe(scene: scenes.Scene) -> dict:
    """The scene in Mitsuba's words. A directional emitter's irradiance is normal to its beam."""
    size, spacing = np.array(scene.size), scenes.spacing_of(scene)
    to_world = mi.ScalarTransform4f
    # Mitsuba has grid values at the centres of voxels: half a voxel more on each side puts the
    # outermost values on the faces of the box.
    grid = scenes.grid_of(scene)[..., None]
    if len(scene.channels()) > 1:
        grid = grid * np.array(scene.tint, np.float32)
    lattice = to_world().translate(list(-0.5 * (size + spacing))).scale(list(size + spacing))
    light = list(map(float, scene.light))
    if scene.point_light:
        emitter = {"type": "point", "position": light,
                   "intensity": {"type": "uniform", "value": 1.0}}
    else:
        emitter = {"type": "directional", "direction": [-x for x in light],
                   "irradiance": {"type": "uniform", "value": 1.0}}
    return {
        "type": "scene",
        "integrator": {"type": integrator_of(scene), "max_depth": 2, "rr_depth": 100},
        "sensor": {
            "type": "perspective", "fov": scene.view_angle,
            "to_world": to_world().look_at(origin=list(scene.eye), target=[0, 0, 0], up=[0, 1, 0]),
            "film": {"type": "hdrfilm", "width": scene.pixels, "height": scene.pixels,
                     "rfilter": {"type": "box"}}},
        "emitter": emitter,
        "box": {
            "type": "cube", "to_world": to_world().scale(list(0.5 * size)), "bsdf": {"type": "null"},
            "interior": {
                "type": "heterogeneous", "albedo": scene.albedo, "scale": scene.extinction,
                "sigma_t": {"type": "gridvolume", "filter_type": "trilinear", "wrap_mode": "clamp",
                            "grid": mi.VolumeGrid(grid), "raw": True, "to_world": lattice},
                "phase": {"type": "hg", "g": scene.g}}}}


def pixel_centres(pixels: int, samples: int) -> "mi.Point2f":
    """Each pixel's centre `samples` times, on a film of unit size whose first row is the top."""
    centres = (np.arange(pixels) + 0.5) / pixels
    y, x = np.meshgrid(centres[::-1], centres, indexing="ij")
    return mi.Point2f(np.repeat(x.ravel(), samples), np.repeat(y.ravel(), samples))


def render(scene: scenes.Scene, samples: int, seed: int) -> tuple:
    """Mean and standard error of each channel per pixel, [channel, y, x], bottom row first."""
    loaded = mi.load_dict(describe(scene))
    integrator, sensor = loaded.integrator(), loaded.sensors()[0]
    each = max(samples // BATCHES, 1)
    positions = pixel_centres(scene.pixels, each)
    means = []
    for batch in tqdm(range(BATCHES), desc=scene.name, leave=False):
        sampler = mi.load_dict({"type": "independent", "sample_count": each})
        sampler.seed(seed + batch, scene.pixels ** 2 * each)
        ray, weight = sensor.sample_ray_differential(0, 0.5, positions, mi.Point2f(0.5))
        radiance = integrator.sample(loaded, sampler, ray, None, True)[0] * weight
        means.append(
            np.array(radiance).reshape(3, scene.pixels, scene.pixels, each).mean(axis=3))
    means = np.array(means)
    return means.mean(axis=0), means.std(axis=0, ddof=1) / np.sqrt(BATCHES)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--samples", type=int, default=32768,
                        help="per pixel; a multiple of %d (default: %%(default)s)" % BATCHES)
    parser.add_argument("--variant", default="llvm_ad_rgb",
                        help="of Mitsuba; llvm_* needs LLVM, see DRJIT_LIBLLVM_PATH")
    parser.add_argument("scene", nargs="*", help="names of scenes (default: all)")
    arguments = parser.parse_args()
    mi.set_variant(arguments.variant)
    for index, scene in enumerate(scenes.MITSUBA):
        if arguments.scene and scene.name not in arguments.scene:
            continue
        image, error = render(scene, arguments.samples, SEEDS * (index + 1))
        head = {
            "renderer": f"Mitsuba {mi.__version__}, {arguments.variant}, {integrator_of(scene)}, "
                        "max_depth=2",
            "command": f"Testing/Reference/run mitsuba -- --samples {arguments.samples} {scene.name}",
            "scene": scene, "samples per pixel": arguments.samples,
            "standard error": f"from {BATCHES} independent batches",
            "date": datetime.date.today().isoformat()}
        for channel, ending in scene.channels().items():
            values, sigma = image[channel], error[channel]
            scenes.write_result(
                scenes.RESULTS / f"mitsuba-{scene.name}{ending}.csv", head, values, sigma)
            print(f"{scene.name}{ending}: mean {values.mean():.6g} "
                  f"+- {np.sqrt((sigma**2).sum()) / values.size:.2g}")


if __name__ == "__main__":
    main()
