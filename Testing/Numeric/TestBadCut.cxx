// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes, cropping and masks that cannot be honoured are refused; see TestBadInput.cxx.
#include "BadInput.h"

#include "vtkPlane.h"
#include "vtkTransform.h"

using namespace vtkMediumTest;

namespace
{
class BadCut : public BadInput
{
};
}

TEST_F(BadCut, CroppingPlanesThatAreNoneAreRefused)
{
  const Change mend = [](Scene& scene) { scene.Mapper->CroppingOff(); };
  for (double bad : { NaN, Infinity, -0.2 })
  {
    ExpectRefusal(
      { "Cropping along y", "-0.1", "lower plane first", "SetCroppingRegionPlanes" },
      [bad](Scene& scene) {
        scene.Mapper->CroppingOn();
        scene.Mapper->SetCroppingRegionPlanes(-0.3, 0.3, -0.1, bad, -0.3, 0.3);
      },
      mend);
  }
}

TEST_F(BadCut, ClippingPlanesThatAreNoneAreRefused)
{
  const Change mend = [](Scene& scene) { scene.Mapper->RemoveAllClippingPlanes(); };
  for (double bad : { NaN, Infinity, 0.0 })
  {
    ExpectRefusal(
      { "Clipping plane 0", "normal", "finite" },
      [bad](Scene& scene) {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0, bad, 0);
        scene.Mapper->AddClippingPlane(plane);
      },
      mend);
  }
  ExpectRefusal(
    { "Clipping plane 1", "origin", "finite" },
    [](Scene& scene) {
      vtkNew<vtkPlane> good, plane;
      plane->SetOrigin(0, NaN, 0);
      scene.Mapper->AddClippingPlane(good);
      scene.Mapper->AddClippingPlane(plane);
    },
    mend);
  ExpectRefusal(
    { "vtkTransform", "SetTransform(nullptr)" },
    [](Scene& scene) {
      vtkNew<vtkPlane> plane;
      plane->SetTransform(vtkNew<vtkTransform>());
      scene.Mapper->AddClippingPlane(plane);
    },
    mend);
}

TEST_F(BadCut, MoreClippingPlanesThanCanBeHonouredAreRefused)
{
  ExpectRefusal(
    { "17 clipping planes", "16", "RemoveClippingPlane" },
    [](Scene& scene) {
      for (int i = 0; i < 20; ++i) // three of them touch nothing
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0, 0, 1);
        plane->SetOrigin(0, 0, -0.65 + 0.06 * i);
        scene.Mapper->AddClippingPlane(plane);
      }
    },
    [](Scene& scene) { scene.Mapper->RemoveAllClippingPlanes(); });
}

TEST_F(BadCut, MasksThatDoNotFitAreRefused)
{
  const Change mend = [](Scene& scene) { scene.Mapper->SetMaskInput(nullptr); };
  const auto spoil = [](const glm::ivec3& points, int type, int components) {
    return [=](Scene& scene) {
      vtkNew<vtkImageData> mask;
      mask->SetDimensions(points.x, points.y, points.z);
      if (components > 0)
      {
        mask->AllocateScalars(type, components);
      }
      scene.Mapper->SetMaskInput(mask);
    };
  };
  ExpectRefusal({ "mask", "3 x 4 x 6", "3 x 4 x 5", "SetMaskInput" },
    spoil({ 3, 4, 6 }, VTK_UNSIGNED_CHAR, 1), mend);
  ExpectRefusal({ "mask", "float", "unsigned char" }, spoil({ 3, 4, 5 }, VTK_FLOAT, 1), mend);
  ExpectRefusal(
    { "mask", "2 components", "unsigned char" }, spoil({ 3, 4, 5 }, VTK_UNSIGNED_CHAR, 2), mend);
  ExpectRefusal({ "mask", "no scalars", "unsigned char" }, spoil({ 3, 4, 5 }, 0, 0), mend);
  ExpectRefusal(
    { "vtkGhostType", "7 tuples", "60 points" },
    [](Scene& scene) {
      vtkSmartPointer<vtkImageData> image = MakeBox();
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName("vtkGhostType");
      ghosts->SetNumberOfTuples(7);
      image->GetPointData()->AddArray(ghosts);
      scene.Mapper->SetInputData(image);
    },
    [](Scene& scene) { scene.Mapper->SetInputData(MakeBox()); });
}
