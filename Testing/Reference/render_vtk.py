# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Renders the scenes by VTK's own volumetric scattering (VTK 9.2 or newer, here from PyPI).

vtkGPUVolumeRayCastMapper with VolumetricScatteringBlending 2 and GlobalIlluminationReach 1, into a
float framebuffer. Its light is 4 pi times too bright for a normalised phase function, and it clamps
the light of a sample at 1: the light is dimmed so that nothing is clamped, and undimmed afterwards.
The standard error holds the change from twice the step, since there is no noise.
"""

import argparse
import datetime

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkFloatArray, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction,
    vtkLight,
    vtkRenderer,
    vtkRenderWindow,
    vtkVolume,
    vtkVolumeProperty,
)
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

import scenes

#: Fine enough that the opacity table's half texel does not show.
OPACITY_POINTS = 16000
#: Keeps every sample's light below 1, where VTK clamps it.
DIMMED = 0.02


def opacity_of(scene: scenes.Scene, unit: float) -> vtkPiecewiseFunction:
    """1 - exp(-extinction x unit) as a function of density."""
    density = np.linspace(0, 1, OPACITY_POINTS)
    alpha = -np.expm1(-scene.extinction * density * unit)
    function = vtkPiecewiseFunction()
    function.BuildFunctionFromTable(0, 1, OPACITY_POINTS, alpha.tolist())
    return function


def volume_of(scene: scenes.Scene, step: float, grid: np.ndarray, scattering: bool) -> vtkVolume:
    image = vtkImageData()
    image.SetDimensions(grid.shape[::-1])
    image.SetSpacing(scenes.spacing_of(scene))
    image.SetOrigin(-0.5 * np.array(scene.size))
    image.GetPointData().SetScalars(numpy_to_vtk(grid.ravel(), deep=True))
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.AutoAdjustSampleDistancesOff()
    mapper.UseJitteringOff()
    mapper.SetSampleDistance(step * min(scenes.spacing_of(scene)))
    if scattering:
        mapper.SetVolumetricScatteringBlending(2)
        mapper.SetGlobalIlluminationReach(1)
    colour = vtkColorTransferFunction()
    colour.AddRGBPoint(0, *[scene.albedo] * 3)
    colour.AddRGBPoint(1, *[scene.albedo] * 3)
    prop = vtkVolumeProperty()
    prop.SetInterpolationTypeToLinear()
    prop.SetScalarOpacity(opacity_of(scene, scenes.spacing_of(scene).min()))
    prop.SetScalarOpacityUnitDistance(scenes.spacing_of(scene).min())
    prop.SetColor(colour)
    prop.ShadeOn()
    prop.SetAmbient(0)
    prop.SetDiffuse(1)
    prop.SetSpecular(0)
    if scattering:
        prop.SetScatteringAnisotropy(scene.g)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(prop)
    return volume


def window_of(scene: scenes.Scene, step: float, grid: np.ndarray,
              scattering: bool = True) -> vtkRenderWindow:
    """Off-screen; without scattering it is VTK's composite mapper, shaded, of any VTK."""
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(scene.light)
    light.SetFocalPoint(0, 0, 0)
    light.SetIntensity(DIMMED)
    renderer = vtkRenderer()
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(light)
    renderer.AddVolume(volume_of(scene, step, grid, scattering))
    camera = renderer.GetActiveCamera()
    camera.SetPosition(scene.eye)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewAngle(scene.view_angle)
    camera.SetClippingRange(0.01, 100)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetDesiredUpdateRate(0.001)  # above 1 frame a second VTK leaves scattering out
    window.SetSize(scene.pixels, scene.pixels)
    window.AddRenderer(renderer)
    return window


def use_float_framebuffer(window: vtkRenderWindow, scene: scenes.Scene) -> None:
    """From the next frame on; one in long steps makes the framebuffers."""
    mapper = window.GetRenderers().GetFirstRenderer().GetVolumes().GetLastProp().GetMapper()
    step = mapper.GetSampleDistance()
    mapper.SetSampleDistance(max(scene.size))
    window.Render()
    mapper.SetSampleDistance(step)
    for target in window.GetRenderFramebuffer(), window.GetDisplayFramebuffer():
        target.PopulateFramebuffer(scene.pixels, scene.pixels, True, 1, VTK_FLOAT, True, 24, 0)


def image_of(window: vtkRenderWindow, scene: scenes.Scene) -> np.ndarray:
    """The last frame's radiance, if it was drawn into floats."""
    pixels = vtkFloatArray()
    window.GetRGBAPixelData(0, 0, scene.pixels - 1, scene.pixels - 1, 0, pixels)
    grey = vtk_to_numpy(pixels).reshape(scene.pixels, scene.pixels, 4)[..., 1].astype(float)
    return grey / DIMMED / (4 * np.pi)


def render(scene: scenes.Scene, step: float) -> np.ndarray:
    window = window_of(scene, step, scenes.grid_of(scene))
    use_float_framebuffer(window, scene)
    window.Render()
    return image_of(window, scene)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--step", type=float, default=0.25,
                        help="of the eye ray, voxels (default: %(default)s)")
    parser.add_argument("scene", nargs="*", help="names of scenes (default: all)")
    arguments = parser.parse_args()
    for scene in scenes.VTK:
        if arguments.scene and scene.name not in arguments.scene:
            continue
        coarse, image = render(scene, 2 * arguments.step), render(scene, arguments.step)
        head = {
            "renderer": f"{vtkVersion.GetVTKSourceVersion()}, vtkGPUVolumeRayCastMapper, "
                        "VolumetricScatteringBlending 2, GlobalIlluminationReach 1",
            "command": f"Testing/Reference/run vtk -- --step {arguments.step:g} {scene.name}",
            "scene": scene, "scale": "1 / 4 pi has been applied",
            "standard error": "none: the change from twice the step",
            "date": datetime.date.today().isoformat()}
        scenes.write_result(scenes.RESULTS / f"{scene.name}.csv", head, image,
                            np.abs(image - coarse))
        print(f"{scene.name}: mean {image.mean():.6g}, "
              f"change from twice the step {np.abs(image - coarse).max() / image.max():.2g}")


if __name__ == "__main__":
    main()
