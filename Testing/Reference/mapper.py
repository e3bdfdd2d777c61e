# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of scenes.py in VTK's words, by the mapper and by the reference."""

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the window)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow, vtkVolume

import scenes
from participating_media import (
    vtkParticipatingMedium,
    vtkSingleScatteringReference,
    vtkSingleScatteringVolumeMapper,
)


def image_of(grid: np.ndarray, size) -> vtkImageData:
    """Point scalars indexed [z, y, x]; the box is centred on the origin."""
    image = vtkImageData()
    image.SetDimensions(grid.shape[::-1])
    image.SetSpacing(np.array(size, float) / (np.array(grid.shape[::-1]) - 1))
    image.SetOrigin(-0.5 * np.array(size, float))
    values = numpy_to_vtk(np.ascontiguousarray(grid).ravel(), deep=True)
    values.SetName("density")
    image.GetPointData().SetScalars(values)
    return image


def light_of(scene: scenes.Scene) -> vtkLight:
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(scene.light)
    light.SetFocalPoint(0, 0, 0)
    if scene.point_light:
        light.PositionalOn()
        light.SetConeAngle(180)  # wider than 90: no cone
        light.SetAttenuationValues(0, 0, 1)
    return light


def pixels_of(image: vtkImageData, channel: int = 1) -> np.ndarray:
    """One channel, in double, first row at the bottom."""
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[..., channel].astype(float)


class Stage:
    """A window with one volume, which can be rendered by the mapper or computed by the reference."""

    def __init__(self, scene: scenes.Scene, grid=None):
        self.scene = scene
        self.channel = 1  # of all images
        self.medium = vtkParticipatingMedium()
        self.medium.SetAlbedo(scene.albedo)
        self.medium.SetAnisotropy(scene.g)
        self.medium.SetExtinctionArrayName("")
        self.medium.SetExtinctionScale(*(scene.extinction * np.array(scene.tint)))
        self.mapper = vtkSingleScatteringVolumeMapper()
        self.mapper.SetInputData(image_of(scenes.grid_of(scene) if grid is None else grid, scene.size))
        self.mapper.SetMedium(self.medium)
        self.mapper.SetTransmittanceThreshold(0)
        self.mapper.RenderToImageOn()
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        self.volume.GetProperty().SetInterpolationTypeToLinear()
        self.light = light_of(scene)
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddLight(self.light)
        self.renderer.AddVolume(self.volume)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(scene.eye)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 1, 0)
        camera.SetViewAngle(scene.view_angle)
        camera.SetClippingRange(0.01, 100)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(scene.pixels, scene.pixels)
        self.window.AddRenderer(self.renderer)
        self.failed = False
        self.mapper.AddObserver("ErrorEvent", self.note_failure)

    def note_failure(self, _mapper, _event) -> None:
        self.failed = True

    def look_parallel(self, direction, up, half_height: float) -> None:
        """Parallel projection along a direction; the camera is 4 units before the box's centre."""
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(half_height)
        camera.SetPosition(-4 * np.array(direction) / np.linalg.norm(direction))
        camera.SetViewUp(up)

    def set_steps(self, voxels: float) -> None:
        """Both steps this many voxels long, of the voxel's shortest edge; 0: the mapper's default."""
        step = voxels * min(self.mapper.GetInput().GetSpacing())
        self.mapper.SetSampleDistance(step)
        self.mapper.SetLightSampleDistance(step)

    def fixed_step(self, voxels: float) -> np.ndarray:
        self.mapper.SetIntegratorToFixedStep()
        self.set_steps(voxels)
        return self.render()

    def paper(self, voxels: float, threshold: float) -> np.ndarray:
        """The medium must be homogeneous; it fills the voxels at or above the threshold."""
        self.mapper.SetIntegratorToPaper()
        self.mapper.SetJitter(0)
        self.mapper.SetBinarySearchIterations(10)
        self.mapper.SetPaperThreshold(threshold)
        self.set_steps(voxels)
        return self.render()

    def error_controlled(self, allowed: float = 1 / 255) -> np.ndarray:
        """By the mapper's default; the allowed error is a fraction of the image's peak."""
        self.mapper.SetIntegratorToErrorControlled()
        self.mapper.SetMaximumError(allowed)
        self.set_steps(0)
        return self.render()

    def exact(self) -> np.ndarray:
        self.mapper.SetIntegratorToExact()
        return self.render()

    def render(self) -> np.ndarray:
        self.failed = False
        self.window.Render()
        if self.failed:
            raise RuntimeError("the mapper refused to draw; its error is above")
        image = vtkImageData()
        self.mapper.GetColorImage(image)
        return pixels_of(image, self.channel)

    def truth(self, tolerance: float = 1e-7) -> vtkSingleScatteringReference:
        """The reference, set up for this stage."""
        reference = vtkSingleScatteringReference()
        reference.SetVolume(self.volume)
        reference.SetMedium(self.medium)
        reference.SetRenderer(self.renderer)
        reference.SetImageSize(self.scene.pixels, self.scene.pixels)
        reference.SetTolerance(tolerance)
        return reference

    def reference(self, tolerance: float = 1e-7, channel=None) -> np.ndarray:
        image = vtkImageData()
        if not self.truth(tolerance).GetColorImage(image):
            raise RuntimeError("the reference gave no image")
        return pixels_of(image, self.channel if channel is None else channel)
