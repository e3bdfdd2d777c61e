# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be drawn is refused by one error, seen from Python, and the next frame is drawn."""

import math
import unittest

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the window)
from participating_media import vtkSingleScatteringVolumeMapper
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkCommand
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import (vtkLight, vtkRenderer, vtkRenderWindow, vtkVolume,
                                         vtkVolumeProperty)


class Refusals(unittest.TestCase):
    def setUp(self):
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        image.AllocateScalars(VTK_FLOAT, 1)
        image.GetPointData().GetScalars().Fill(1)
        self.mapper = vtkSingleScatteringVolumeMapper()
        self.mapper.SetInputData(image)
        self.errors = []

        def record(mapper, event, words):
            self.errors.append(words)

        record.CallDataType = "string0"
        self.mapper.AddObserver(vtkCommand.ErrorEvent, record)

        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.volume.SetProperty(vtkVolumeProperty())
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddLight(vtkLight())
        self.renderer.AddVolume(self.volume)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(16, 16)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCamera()

    def picture(self):
        """The float image of a new frame, as bytes."""
        self.window.Render()
        image = vtkImageData()
        self.mapper.GetColorImage(image)
        return bytes(memoryview(image.GetPointData().GetScalars()))

    def assert_refused(self, spoil, mend, *words):
        valid = self.picture()
        self.assertTrue(any(valid))
        spoil()
        self.window.Render()
        self.window.Render()
        self.assertEqual(len(self.errors), 1, self.errors)
        for word in words:
            self.assertIn(word, self.errors[0])
        mend()
        self.assertEqual(self.picture(), valid)
        self.assertEqual(len(self.errors), 1, self.errors)

    def test_step_that_is_no_number_is_refused(self):
        self.assert_refused(lambda: self.mapper.SetSampleDistance(math.nan),
                            lambda: self.mapper.SetSampleDistance(0), "nan", "SetSampleDistance")

    def test_inverted_cropping_planes_are_refused(self):
        def invert():
            self.mapper.SetCroppingRegionPlanes(3, 1, 0, 2, 0, 2)
            self.mapper.CroppingOn()

        self.assert_refused(invert, self.mapper.CroppingOff, "lower plane first")


if __name__ == "__main__":
    unittest.main()
