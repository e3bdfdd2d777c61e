# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""One small point of the benchmark: its record is whole, and the allowed error is kept. And one small page:
it has each row of the targets."""

import argparse
import json
import tempfile
import unittest
from pathlib import Path

import paths  # noqa: F401 isort: skip (before the modules it makes known)
import benchmark
import builds
import emptiness
import large
import numpy as np
import peers
import performance_page
import repaired
import targets
from points import FIELDS, errors, measure, setting, truth_of


class Point(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.what = setting("cloud", 32, 32)
        cls.truth = truth_of(cls.what, 1, 1e-5)
        cls.point = measure(cls.what, "ErrorControlled", 1, cls.truth, "a device", frames=2,
                            dense=cls.truth)

    def test_record_has_the_fields(self):
        self.assertEqual(tuple(self.point), FIELDS)
        self.assertEqual(json.loads(json.dumps(self.point)), self.point)
        for name in ("knob", "max_error", "relative_rmse", "p99_9", "taps", "bytes",
                     "estimated_error", "eye_step"):
            self.assertGreater(self.point[name], 0, name)
        for name in ("cold", "camera_moved"):
            self.assertGreater(self.point[name]["median"], 0, name)
            low, high = self.point[name]["quartiles"]
            self.assertLessEqual(low, high)
        self.assertEqual((self.point["volume"], self.point["image"]), ([32] * 3, [32] * 2))

        self.assertEqual(self.point["max_error_all"], self.point["max_error"])

    def test_error_controlled_keeps_what_is_allowed(self):
        self.assertLessEqual(self.point["max_error"], 1)

    def test_it_does_under_other_lights_and_functions(self):
        for changes in ({"bent": True}, {"point_light": True, "light": (0.5, 0.9, 0.4)}):
            what = setting("smooth", 32, 32, **changes)
            truth = truth_of(what, 1, 1e-5)
            self.assertGreater(np.abs(truth - self.truth).max(), 0.1 * truth.max())
            found = measure(what, "ErrorControlled", 1, truth, "a device", frames=0)
            self.assertLessEqual(found["max_error"], 1, changes)

    def test_long_steps_miss_it(self):
        """So the error is measured, and is not small by itself."""
        coarse = measure(self.what, "FixedStep", 2, self.truth, "a device", frames=0)
        self.assertGreater(coarse["max_error"], 1)
        self.assertIsNone(coarse["estimated_error"])

    def test_errors_are_those_of_the_truths_pixels(self):
        image, fourth = self.truth.copy(), self.truth[::4, ::4]
        image[4, 8] += fourth.max() / 51
        self.assertAlmostEqual(errors(image, fourth)["max_error"], 5)
        self.assertEqual(errors(image, self.truth[::8, ::8])["max_error"], 0)

    def test_the_finest_fixed_step_is_the_truth_of_all_pixels(self):
        found, dense, left = repaired.fixed_steps(self.what, "a device", frames=1)
        self.assertLess(errors(dense, self.truth)["max_error"], 2 * left)
        longest = repaired.longest_step(found)
        self.assertLessEqual(longest["max_error"], 1)
        self.assertGreater(found[0]["max_error"], 1)
        self.assertLess(longest["knob"], found[0]["knob"])

    def test_brightness_is_fitted(self):
        dimmed = peers.fitted(0.3 * self.truth, self.truth[::4, ::4])
        self.assertLess(np.abs(dimmed - self.truth).max(), 1e-12)

    def test_other_renderers_are_left_out_with_a_reason(self):
        found, why = peers.vtk_scattering(self.what, (1,), self.truth)
        self.assertEqual(found, [])
        self.assertIn(peers.VARIABLE, why)

    def test_medians_of_builds_are_read(self):
        runs = [{"run_name": f"bricks/cloud/{n}/real_time", "aggregate_name": name, "real_time": n / 8}
                for n in (128, 64) for name in ("mean", "median")]
        self.assertEqual(builds.read(json.dumps({"benchmarks": runs})),
                         [{"what": "bricks", "field": "cloud", "sizes": [64, 128],
                           "milliseconds": [8, 16]}])


class Page(unittest.TestCase):
    """Of one field, at sizes that say nothing about times."""

    #: A word of each bar of the targets, in the order of the page.
    BARS = ("composite mapper", "bare loop", "dragging", "final", "first frame", "memory",
            "largest error", "its estimate", "steps of a voxel", "at equal error", "0.4 box", "Mitsuba",
            "literal", "repaired", "cost in N", "empty data")

    @classmethod
    def setUpClass(cls):
        cls.options = argparse.Namespace(stride=4, frames=2, device="a device")
        records, facts = large.measure_field("binary", "a device", 24, 24, frames=2, stride=4)
        methods = (*benchmark.SWEEPS, benchmark.PAPER)
        cls.result = {
            "date": "today", "device": "a device", "cores": 2, "vtk": "some", "quick": True,
            "reference_stride": 4, "seconds": 0, "large": records, "facts": {"binary": facts},
            "small": benchmark.sweep(setting("binary", 24, 24), methods, cls.options),
            "emptiness": emptiness.measure(48, 24)}

    def test_has_each_row_of_the_targets(self):
        rows = targets.rows_of(self.result)
        self.assertEqual(len(rows), len(self.BARS))
        for row, word in zip(rows, self.BARS):
            against, bar, aim, measured, met, why = row
            self.assertIn(word, against)
            self.assertTrue(bar and aim and measured)
            self.assertTrue(met or why, f"{against}: neither met nor a reason")

    def test_empty_data_takes_fewer_taps(self):
        found = self.result["emptiness"]
        self.assertAlmostEqual(found["empty"], emptiness.EMPTY, delta=0.01)
        for taps in found["taps"].values():
            self.assertGreater(taps["plain"], taps["skipping"])

    def test_is_written(self):
        with tempfile.TemporaryDirectory() as folder:
            self.options.output = Path(folder) / "page.md"
            self.options.images = Path(folder) / "images"
            performance_page.write(self.options, self.result)
            self.assertIn("## Targets", self.options.output.read_text(encoding="utf-8"))
            self.assertTrue(list(self.options.images.glob("*.png")))


if __name__ == "__main__":
    unittest.main()
