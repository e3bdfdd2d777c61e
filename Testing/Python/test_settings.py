# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Every setting is printed and copied: what has a Set and a Get is found by its name."""

import sys
import unittest

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the window)
from participating_media import (vtkParticipatingMedium, vtkSingleScatteringReference,
                                 vtkSingleScatteringVolumeMapper)
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import (vtkImageData, vtkPiecewiseFunction, vtkPlane,
                                           vtkPlaneCollection)
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction


def settings(kind):
    """The names of a class's own settings."""
    return sorted(name[3:] for name in vars(kind)
                  if name.startswith("Get") and "Set" + name[3:] in vars(kind))


def other_value(kind, name, value):
    """A valid value that is not `value`."""
    if name.endswith("ColorFunction"):
        return vtkColorTransferFunction()
    if name.endswith("Function") and not isinstance(value, int):
        return vtkPiecewiseFunction()
    if name == "PhaseTable":
        return vtkDoubleArray()
    if name == "MaskInput":
        return vtkImageData()
    if name == "Medium":
        return vtkParticipatingMedium()
    if name.endswith("ArrayName"):
        return "another"
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return value + 1 if value < 2 else value - 1
    if isinstance(value, float):
        return value + 0.25
    return tuple(x + 0.25 for x in value)


class Settings(unittest.TestCase):
    def test_are_printed(self):
        for kind in (vtkSingleScatteringVolumeMapper, vtkParticipatingMedium,
                     vtkSingleScatteringReference):
            text = str(kind())
            names = settings(kind)
            self.assertGreater(len(names), 5)
            for name in names:
                self.assertIn(f"{name}:", text, kind.__name__)

    def check_copies(self, kind):
        source, copy = kind(), kind()
        for name in settings(kind):
            before = getattr(source, "Get" + name)()
            after = other_value(kind, name, before)
            with self.subTest(kind=kind.__name__, setting=name):
                arguments = after if isinstance(after, tuple) else (after,)
                getattr(source, "Set" + name)(*arguments)
                self.assertNotEqual(getattr(source, "Get" + name)(), before)
        copy.ShallowCopy(source)
        for name in settings(kind):
            with self.subTest(kind=kind.__name__, setting=name):
                self.assertEqual(getattr(copy, "Get" + name)(), getattr(source, "Get" + name)())
        return source, copy

    def test_of_a_medium_are_copied(self):
        self.check_copies(vtkParticipatingMedium)

    def test_of_a_mapper_are_copied(self):
        self.check_copies(vtkSingleScatteringVolumeMapper)

    def test_of_every_volume_mapper_are_copied(self):
        source, copy = vtkSingleScatteringVolumeMapper(), vtkSingleScatteringVolumeMapper()
        image, planes = vtkImageData(), vtkPlaneCollection()
        planes.AddItem(vtkPlane())
        source.SetInputData(image)
        source.SetClippingPlanes(planes)
        source.CroppingOn()
        source.SetCroppingRegionPlanes(1, 2, 3, 4, 5, 6)
        source.SetCroppingRegionFlags(0x123)
        source.SetBlendModeToAdditive()
        source.SetScalarModeToUseCellFieldData()
        source.SelectScalarArray("density")
        copy.ShallowCopy(source)
        self.assertIs(copy.GetInputDataObject(0, 0), image)
        self.assertIs(copy.GetClippingPlanes(), planes)
        for name in ("Cropping", "CroppingRegionPlanes", "CroppingRegionFlags", "BlendMode",
                     "ScalarMode", "ArrayName", "ArrayAccessMode"):
            self.assertEqual(getattr(copy, "Get" + name)(), getattr(source, "Get" + name)(), name)


if __name__ == "__main__":
    sys.exit(unittest.main())
