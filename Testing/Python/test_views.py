# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Off-axis views keep the focal plane, and many views of a mapper build what they need once."""

import math
import sys
import unittest

from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkLight, vtkRenderWindow, vtkVolume

from participating_media import vtkSingleScatteringVolumeMapper
from participating_media.presets import ramp_property
from participating_media.views import add_grid, beside, quilt_offsets

ASPECT = 1.5


def camera_of(**options):
    camera = vtkCamera()
    camera.SetPosition(3, 2, 7)
    camera.SetFocalPoint(0.5, 0.2, 0.1)
    camera.SetViewUp(0.1, 1, 0)
    camera.SetClippingRange(1, 20)
    camera.OrthogonalizeViewUp()
    for name, value in options.items():
        getattr(camera, f"Set{name}")(*value)
    return camera


def project(camera, point):
    """The point's place in the picture, -1 to 1 in x and y."""
    matrix = camera.GetCompositeProjectionTransformMatrix(ASPECT, -1, 1)
    x, y, _, w = matrix.MultiplyPoint((*point, 1))
    return x / w, y / w


def axes(camera):
    view = camera.GetViewTransformMatrix()
    return [[view.GetElement(row, column) for column in range(3)] for row in range(3)]


class OffAxisViews(unittest.TestCase):
    def test_keep_the_focal_plane_and_move_the_rest(self):
        for options in ({}, {"WindowCenter": (0.3, -0.2)}, {"UseHorizontalViewAngle": (True,)}):
            camera = camera_of(**options)
            right, up, back = axes(camera)
            for offset in (-0.8, 0.3):
                moved = beside(camera, offset, ASPECT)
                for u, v in ((0, 0), (1.1, -0.4), (-0.7, 0.9)):
                    focal = [f + u * r + v * t
                             for f, r, t in zip(camera.GetFocalPoint(), right, up)]
                    for a, b in zip(project(camera, focal), project(moved, focal)):
                        self.assertAlmostEqual(a, b, places=12)
                    nearer = [f + b for f, b in zip(focal, back)]
                    before, after = project(camera, nearer), project(moved, nearer)
                    # An eye to the right sees what is near further to the left.
                    self.assertGreater(math.copysign(1, offset) * (before[0] - after[0]), 0.005)
                    self.assertAlmostEqual(before[1], after[1], places=12)

    def test_spread_over_the_cone(self):
        camera = camera_of()
        offsets = quilt_offsets(camera, 45, 40)
        self.assertEqual(len(offsets), 45)
        self.assertEqual(offsets[22], 0)
        steps = [b - a for a, b in zip(offsets, offsets[1:])]
        self.assertAlmostEqual(min(steps), max(steps))
        angle = math.degrees(math.atan(offsets[-1] / camera.GetDistance()))
        self.assertAlmostEqual(angle, 20)

    def test_build_what_they_need_once(self):
        source = vtkRTAnalyticSource()
        mapper = vtkSingleScatteringVolumeMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        mapper.SetIntegratorToErrorControlled()
        mapper.SetLightCachesToAlways()
        mapper.SetMaximumError(0.02)
        volume = vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(ramp_property(150, 260, extinction=2.0))
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(10, 30, 20)
        camera = vtkCamera()
        camera.SetPosition(0, 10, 50)
        camera.SetClippingRange(1, 200)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(4 * 16, 3 * 16)
        eyes = [beside(camera, x, 1) for x in quilt_offsets(camera, 12, 30)]
        for renderer in add_grid(window, eyes, columns=4):
            renderer.AddLight(light)
            renderer.AddVolume(volume)
        window.Render()
        done = mapper.GetStatistics()
        self.assertEqual(done.GetFrames(), 12)
        self.assertEqual(done.GetBrickBuilds(), 1)
        self.assertEqual(done.GetLightCacheBuilds(), 1)
        self.assertLess(done.GetCalibrations(), 7)
        counts = done.GetTextureUploads(), done.GetProgramCompiles(), done.GetCalibrations()
        window.Render()
        self.assertEqual(done.GetFrames(), 24)
        self.assertEqual(
            (done.GetTextureUploads(), done.GetProgramCompiles(), done.GetCalibrations()), counts)


if __name__ == "__main__":
    sys.exit(unittest.main())
