# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the mapper and the reference to pictures of the same scenes by Mitsuba and OpenVDB.

The pictures are those in Results; README.md says how they were made. Neither renderer is needed.
"""

import unittest

import numpy as np

import scenes
from mapper import Stage

#: Mitsuba's sums were seen 4e-4 to 6e-4 above closed forms after 32768 samples a pixel, so its
#: standard error is not the whole of its error.
BIAS = 1e-3
STANDARD_ERRORS = 3
#: How often a right picture fails the chi-square test.
SIGNIFICANCE = 1e-3
#: Steps of FixedStep in voxels, fine enough for its own error to stay below BIAS on these grids.
STEP = 0.125
#: vdb_render is first order in its step, of a sixteenth of a voxel here.
LARGEST_RELATIVE_RMSE = 0.02
#: The same, with the wrong sign of g or a wrong light, must not pass.
WRONG = ("g of the other sign", "light from the other side", "extinction 3 % up")


def largest_chi_square(degrees: int) -> float:
    """Of this many degrees of freedom, at SIGNIFICANCE (Wilson and Hilferty 1931)."""
    quantile = 3.0902  # of the normal distribution, at 1 - SIGNIFICANCE
    spread = 2 / (9 * degrees)
    return degrees * (1 - spread + quantile * spread ** 0.5) ** 3


def blocks_of(image: np.ndarray, side: int = 4) -> np.ndarray:
    """Means over side x side pixels."""
    n = image.shape[0] // side
    return image.reshape(n, side, n, side).mean(axis=(1, 3))


def faults_against_samples(image, samples, error) -> list:
    """In which ways an image differs from a Monte Carlo one; empty when it does not."""
    faults = []
    mean, mean_error = samples.mean(), np.sqrt((error ** 2).sum()) / error.size
    if not abs(image.mean() - mean) <= STANDARD_ERRORS * mean_error + BIAS * mean:
        faults.append(f"mean {image.mean():.6g} instead of {mean:.6g} +- {mean_error:.2g}")
    for name, of in (("pixels", np.asarray), ("blocks", blocks_of)):
        variance = of(error ** 2) / (error.size / of(error).size) + (BIAS * of(samples)) ** 2
        difference = of(image) - of(samples)
        # Where hardly a path has found light the variance is not to be trusted: both must be dark.
        dark = of(samples) <= BIAS * samples.max()
        chi_square = (difference[~dark] ** 2 / variance[~dark]).sum()
        limit = largest_chi_square(int((~dark).sum()))
        if not chi_square <= limit:
            faults.append(f"chi-square of the {name} {chi_square:.5g}, at most {limit:.5g}")
        if not np.abs(difference[dark]).max(initial=0) <= BIAS * samples.max():
            faults.append(f"light on {name} that Mitsuba has dark")
    return faults


def relative_rmse(image, other) -> float:
    return float(np.sqrt(((image - other) ** 2).mean() / (other ** 2).mean()))


def scaled_to(image, other) -> np.ndarray:
    """The image times the one number that brings it nearest to the other, by least squares."""
    return image * (image * other).sum() / (image ** 2).sum()


def images_of(stage: Stage) -> dict:
    return {"reference": stage.reference(), "FixedStep": stage.fixed_step(STEP),
            "Exact": stage.exact()}


def make_wrong(stage: Stage, mistake: str) -> None:
    if mistake.startswith("g"):
        stage.medium.SetAnisotropy(-stage.scene.g)
    elif mistake.startswith("light"):
        stage.light.SetPosition([-x for x in stage.light.GetPosition()])
    else:
        stage.medium.SetExtinctionScale(1.03 * stage.scene.extinction)


class Mitsuba(unittest.TestCase):
    def test_agrees_within_its_standard_error(self):
        for scene in scenes.MITSUBA:
            stage = Stage(scene)
            for stage.channel, ending in scene.channels().items():
                _, samples, error = scenes.read_result(
                    scenes.RESULTS / f"mitsuba-{scene.name}{ending}.csv")
                for name, image in images_of(stage).items():
                    with self.subTest(scene=scene.name + ending, by=name):
                        self.assertEqual(faults_against_samples(image, samples, error), [])

    def test_refuses_the_colour_of_another_channel(self):
        scene = next(s for s in scenes.MITSUBA if s.name == "cloud-chromatic")
        stage = Stage(scene)
        image = stage.fixed_step(STEP)  # green
        for ending in ("-red", "-blue"):
            _, samples, error = scenes.read_result(
                scenes.RESULTS / f"mitsuba-{scene.name}{ending}.csv")
            self.assertNotEqual(faults_against_samples(image, samples, error), [])

    def test_refuses_wrong_pictures(self):
        scene = next(s for s in scenes.MITSUBA if s.name == "cloud-flat-box")
        _, samples, error = scenes.read_result(scenes.RESULTS / f"mitsuba-{scene.name}.csv")
        for mistake in WRONG:
            stage = Stage(scene)
            make_wrong(stage, mistake)
            with self.subTest(mistake=mistake):
                self.assertNotEqual(
                    faults_against_samples(stage.fixed_step(STEP), samples, error), [])


class OpenVDB(unittest.TestCase):
    def test_agrees_after_one_scale(self):
        for scene in scenes.OPENVDB:
            _, theirs, _ = scenes.read_result(scenes.RESULTS / f"openvdb-{scene.name}.csv")
            for name, image in images_of(Stage(scene)).items():
                with self.subTest(scene=scene.name, by=name):
                    self.assertLess(relative_rmse(scaled_to(theirs, image), image),
                                    LARGEST_RELATIVE_RMSE)

    def test_agrees_without_a_scale(self):
        """Stricter: 1 / 4 pi is the whole of the difference in convention."""
        for scene in scenes.OPENVDB:
            _, theirs, _ = scenes.read_result(scenes.RESULTS / f"openvdb-{scene.name}.csv")
            with self.subTest(scene=scene.name):
                self.assertLess(relative_rmse(theirs, Stage(scene).reference()),
                                LARGEST_RELATIVE_RMSE)

    def test_refuses_wrong_pictures(self):
        scene = next(s for s in scenes.OPENVDB if s.name == "cloud-isotropic")
        _, theirs, _ = scenes.read_result(scenes.RESULTS / f"openvdb-{scene.name}.csv")
        for mistake in ("light from the other side", "g of 0.6"):
            stage = Stage(scene)
            if mistake.startswith("light"):
                make_wrong(stage, mistake)
            else:
                stage.medium.SetAnisotropy(0.6)
            image = stage.fixed_step(STEP)
            with self.subTest(mistake=mistake):
                self.assertGreater(relative_rmse(scaled_to(theirs, image), image),
                                   LARGEST_RELATIVE_RMSE)


if __name__ == "__main__":
    unittest.main()
