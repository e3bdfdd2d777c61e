# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""One small point of the benchmark: its record is whole, and the allowed error is kept."""

import json
import unittest

import paths  # noqa: F401 (before the modules it makes known)
from points import FIELDS, errors, measure, setting, truth_of


class Point(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.what = setting("cloud", 32, 32)
        cls.truth = truth_of(cls.what, 1, 1e-5)
        cls.point = measure(cls.what, "ErrorControlled", 1, cls.truth, "a device", frames=2)

    def test_record_has_the_fields(self):
        self.assertEqual(tuple(self.point), FIELDS)
        self.assertEqual(json.loads(json.dumps(self.point)), self.point)
        for name in ("knob", "max_error", "relative_rmse", "p99_9", "taps", "bytes",
                     "estimated_error"):
            self.assertGreater(self.point[name], 0, name)
        for name in ("cold", "camera_moved"):
            self.assertGreater(self.point[name]["median"], 0, name)
            low, high = self.point[name]["quartiles"]
            self.assertLessEqual(low, high)
        self.assertEqual((self.point["volume"], self.point["image"]), ([32] * 3, [32] * 2))

    def test_error_controlled_keeps_what_is_allowed(self):
        self.assertLessEqual(self.point["max_error"], 1)

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


if __name__ == "__main__":
    unittest.main()
