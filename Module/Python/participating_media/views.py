# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Cameras beside a camera, for stereo pictures and quilts, and viewports in a grid."""

from __future__ import annotations

import math

from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer, vtkRenderWindow


def beside(camera: vtkCamera, offset: float, aspect: float) -> vtkCamera:
    """A copy of a perspective camera, moved to its right by ``offset`` world units.

    It looks along the same direction through a window that is off its centre by as much, so that what
    lies in the plane of the focal point stays where it is in the picture, and what lies before or
    behind it moves: an off-axis projection, without the keystone of eyes that turn inwards.
    ``aspect`` is the width of the picture divided by its height.
    """
    moved = vtkCamera()
    moved.DeepCopy(camera)
    forward, up = camera.GetDirectionOfProjection(), camera.GetViewUp()
    right = (forward[1] * up[2] - forward[2] * up[1], forward[2] * up[0] - forward[0] * up[2],
             forward[0] * up[1] - forward[1] * up[0])
    scale = offset / math.hypot(*right)
    shift = [scale * x for x in right]
    moved.SetPosition([p + s for p, s in zip(camera.GetPosition(), shift)])
    moved.SetFocalPoint([p + s for p, s in zip(camera.GetFocalPoint(), shift)])
    half = camera.GetDistance() * math.tan(math.radians(camera.GetViewAngle() / 2))
    half_width = half if camera.GetUseHorizontalViewAngle() else half * aspect
    x, y = camera.GetWindowCenter()
    moved.SetWindowCenter(x - offset / half_width, y)
    return moved


def quilt_offsets(camera: vtkCamera, views: int, cone: float) -> list[float]:
    """How far to the right each of ``views`` eyes stands, from the leftmost to the rightmost, equally
    far apart on a line that the focal point sees under ``cone`` degrees."""
    reach = camera.GetDistance() * math.tan(math.radians(cone / 2))
    return [reach * (2 * view / max(views - 1, 1) - 1) for view in range(views)]


def add_grid(window: vtkRenderWindow, cameras: list[vtkCamera], columns: int) -> list[vtkRenderer]:
    """A renderer for each camera, in a grid from the bottom left rightwards and then upwards, as
    holographic displays have it. Without lights of their own, so add some."""
    rows = -(-len(cameras) // columns)
    renderers = []
    for number, camera in enumerate(cameras):
        column, row = number % columns, number // columns
        renderer = vtkRenderer()
        renderer.SetViewport(column / columns, row / rows, (column + 1) / columns, (row + 1) / rows)
        renderer.AutomaticLightCreationOff()
        renderer.SetActiveCamera(camera)
        window.AddRenderer(renderer)
        renderers.append(renderer)
    return renderers
