# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""A scene of scenes.json on a stage: window, camera, light, a volume and either mapper.

A scene changes a default stage by calls, ``[target, method, argument...]``. Targets are the names of
``Stage.parts``; a method may be a path, ``GetProperty.SetOpacity``. An argument is a number, a text, or

- ``{"the": target}``: a part of the stage;
- ``{"new": class, "calls": [[method, argument...]...]}``: an object of a VTK class;
- ``{"actor": source, "calls": ...}``: an actor that shows what a source makes.
"""

import ctypes
import ctypes.util
import importlib
import re

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the window)
from participating_media import vtkSingleScatteringVolumeMapper
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import (VTK_UNSIGNED_CHAR, vtkLogger, vtkOutputWindow,
                                      vtkStringOutputWindow, vtkUnsignedCharArray)
from vtkmodules.vtkCommonDataModel import (vtkDataSetAttributes, vtkImageData, vtkPiecewiseFunction,
                                           vtkRectilinearGrid, vtkUniformGrid)
from vtkmodules.vtkRenderingCore import (vtkActor, vtkCamera, vtkColorTransferFunction, vtkLight,
                                         vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkVolume,
                                         vtkVolumeProperty)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

SIDE = 80  # pixels
MODULES = ("CommonCore", "CommonDataModel", "CommonMath", "CommonTransforms", "FiltersSources",
           "ImagingCore", "RenderingCore", "RenderingLOD", "RenderingOpenGL2", "RenderingVolume")
# One large ball and three small ones, each along an axis, so that a mirrored axis shows.
BALLS = ((0, 0, 0, 8.5), (8, 0, 0, 3.5), (0, 8.5, 0, 3), (0, 0, 9, 2.5))


class MissingSetting(Exception):
    """The mapper, or this VTK, has no such method or class."""


def density(points, spacing):
    """0 to 1 on a lattice centred on the origin, as [z, y, x]."""
    axes = [(np.arange(n) - (n - 1) / 2) * h for n, h in zip(points, spacing)]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    return np.max([np.maximum(1 - np.sqrt((x - a)**2 + (y - b)**2 + (z - c)**2) / r, 0)
                   for a, b, c, r in BALLS], axis=0)


def make_data(points=(24, 24, 24), spacing=(1, 1, 1), type="float32", scale=1.0, cells=False,
              components=1, kind="vtkImageData", first=(0, 0, 0), blank=0, decoy=False):
    """The balls as a VTK data set of that many points, from the value 0 to the value `scale`.

    Components after the first are constant, so that dependent ones make sense too. The first `blank`
    columns of points are hidden. A `decoy` of zeros is active in place of the balls' array.
    """
    values = (density([n - cells for n in points], spacing) * scale).astype(type).ravel()
    columns = [values] + [np.full_like(values, 0.8 * scale)] * (components - 1)
    columns = columns[1:] + columns[:1] if components > 2 else columns  # colours, then opacity
    array = named(np.stack(columns, axis=1) if components > 1 else values, "density")
    if kind == "vtkRectilinearGrid":
        data = vtkRectilinearGrid()
        data.SetDimensions(*points)
        for axis, n, h in zip("XYZ", points, spacing):
            line = (np.arange(n) - (n - 1) / 2) * h
            getattr(data, f"Set{axis}Coordinates")(numpy_to_vtk(line, deep=True))
    else:
        data = vtkUniformGrid() if kind == "vtkUniformGrid" else vtkImageData()
        data.SetExtent(*(x for f, n in zip(first, points) for x in (f, f + n - 1)))
        data.SetSpacing(spacing)
        data.SetOrigin(*(-h * ((n - 1) / 2 + f) for h, n, f in zip(spacing, points, first)))
    attributes = data.GetCellData() if cells else data.GetPointData()
    attributes.SetScalars(array)
    if decoy:
        attributes.SetScalars(named(np.zeros_like(values), "nothing"))
        attributes.AddArray(array)
    if blank:
        hidden = np.zeros(points[::-1], np.uint8)
        hidden[:, :, :blank] = vtkDataSetAttributes.HIDDENPOINT
        attributes.AddArray(named(hidden.ravel(), vtkDataSetAttributes.GhostArrayName()))
    return data


def named(values, name):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    return array


def make_labels(split=12):
    """A mask of the default lattice: 255 where x is below the split, else 0."""
    labels = np.zeros((24, 24, 24), np.uint8)
    labels[:, :, :split] = 255
    image = make_data()
    image.GetPointData().SetScalars(numpy_to_vtk(labels.ravel(), deep=True,
                                                 array_type=VTK_UNSIGNED_CHAR))
    return image


def find_class(name):
    for module in MODULES:
        found = getattr(importlib.import_module("vtkmodules.vtk" + module), name, None)
        if found:
            return found
    raise MissingSetting(name)


def invoke(target, path, arguments):
    *getters, method = path.split(".")
    for name in getters:
        target = getattr(target, name)()
    if not hasattr(target, method):
        raise MissingSetting(f"{target.GetClassName()}::{method}")
    return getattr(target, method)(*arguments)


def count_gl_errors():
    """Takes what OpenGL has noted in the current context; where there is no libGL, that is nothing."""
    library = ctypes.util.find_library("GL")
    errors = 0
    if library:
        gl = ctypes.CDLL(library)
        while gl.glGetError() and errors < 10:
            errors += 1
    return errors


class Stage:
    """`black` media only take light away from a white background: the picture is transmittance."""

    def __init__(self, scene, ours, black):
        self.scene = scene
        self.ours = ours
        self.messages = vtkStringOutputWindow()
        self.gl_errors = 0
        mapper = vtkSingleScatteringVolumeMapper() if ours else vtkOpenGLGPUVolumeRayCastMapper()
        mapper.SetAutoAdjustSampleDistances(False)
        if not ours:
            mapper.SetSampleDistance(0.25)
            mapper.UseJitteringOff()
        data = make_data(**scene.get("data", {}))
        mapper.SetInputDataObject(data)
        opacity, color = vtkPiecewiseFunction(), vtkColorTransferFunction()
        scale = scene.get("data", {}).get("scale", 1.0)
        opacity.AddPoint(0, 0)
        opacity.AddPoint(scale, 0.25)
        color.AddRGBPoint(0, *((0, 0, 0) if black else (1, 0.8, 0.6)))
        prop = vtkVolumeProperty()
        prop.SetScalarOpacity(opacity)
        prop.SetColor(color)
        prop.SetInterpolationTypeToLinear()
        volume = vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(prop)
        camera = vtkCamera()
        camera.SetPosition(24, 18, 60)
        camera.SetClippingRange(1, 300)
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(30, 40, 60)
        light.SetIntensity(12)
        renderer = vtkRenderer()
        renderer.AutomaticLightCreationOff()
        renderer.SetBackground(*((1, 1, 1) if black else (0.1, 0.1, 0.2)))
        renderer.SetActiveCamera(camera)
        renderer.AddLight(light)
        renderer.AddVolume(volume)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(SIDE, SIDE)
        window.AddRenderer(renderer)
        self.parts = dict(mapper=mapper, data=data, opacity=opacity, color=color, property=prop,
                          volume=volume, camera=camera, light=light, renderer=renderer,
                          window=window)

    def __enter__(self):
        self.before = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff()
        vtkOutputWindow.SetInstance(self.messages)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        return self

    def __exit__(self, *_):
        window, renderer = self.parts["window"], self.parts["renderer"]
        renderer.SetPass(None)
        window.Finalize()
        vtkOutputWindow.SetInstance(self.before[0])
        vtkLogger.SetStderrVerbosity(self.before[1])

    def value_of(self, argument):
        if isinstance(argument, list):
            return [self.value_of(one) for one in argument]
        if not isinstance(argument, dict):
            return argument
        if "the" in argument:
            return self.parts[argument["the"]]
        if "data" in argument:
            return make_data(**argument["data"])
        if "labels" in argument:
            return make_labels(argument["labels"])
        if "actor" in argument:
            made = vtkActor()
            source = self.value_of(argument["actor"])
            made.SetMapper(vtkPolyDataMapper())
            made.GetMapper().SetInputConnection(source.GetOutputPort())
        else:
            made = find_class(argument["new"])()
        for method, *arguments in argument.get("calls", []):
            invoke(made, method, self.value_of(arguments))
        return made

    def call(self, calls):
        for target, method, *arguments in calls:
            invoke(self.parts[target], method, self.value_of(arguments))

    def set_up(self):
        self.call(self.scene.get("calls", []))
        self.call(self.scene.get("ours_calls" if self.ours else "vtk_calls", []))

    def render(self):
        """A new frame as floats 0 to 1, [row from the bottom, column, RGB]."""
        window = self.parts["window"]
        window.Render()
        bytes_ = vtkUnsignedCharArray()
        width, height = window.GetSize()
        window.GetPixelData(0, 0, width - 1, height - 1, 0, bytes_, 0)
        window.MakeCurrent()
        self.gl_errors += count_gl_errors()
        return vtk_to_numpy(bytes_).reshape(height, width, 3) / 255

    def play(self):
        """The frame that the scene ends with: after its calls, and after each of its changes."""
        picture = self.render()
        for change in self.scene.get("then", []):
            self.call(change)
            picture = self.render()
        return picture

    def hide_volume(self):
        for prop in self.parts["renderer"].GetViewProps():
            if prop.IsA("vtkVolume") or prop.IsA("vtkLODProp3D"):
                prop.VisibilityOff()

    def pick(self):
        """Where the scene's picker finds the volume, or None."""
        ask = self.scene["pick"]
        picker = find_class(ask["picker"])()
        for method, *arguments in ask.get("calls", []):
            invoke(picker, method, arguments)
        if not picker.Pick(*ask["at"], 0, self.parts["renderer"]):
            return None
        return np.array(picker.GetPickPosition())

    def errors(self):
        """The texts of the errors since the stage was made, without place and address."""
        texts = self.messages.GetOutput().split("ERROR: In ")[1:]
        return [re.sub(r"\s*\(0x[0-9a-f]+\)", "", text.split("): ", 1)[-1].split("\n\n")[0]).strip()
                for text in texts]
