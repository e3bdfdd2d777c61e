// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Masks and ghosts in the reference. With nearest interpolation a voxel that is left out is one of
// extinction 0, exactly; else the laws are those of a sharp border.
#include "ReferenceSetting.h"
#include "vtkMediumFixtures.h"

#include "vtkDataSetAttributes.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUniformGrid.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

using namespace ReferenceTests;

namespace
{
constexpr int Size = 6;

double Field(const glm::dvec3& box)
{
  return 0.4 + box.x * (1 - box.y) + 0.3 * box.z;
}

bool IsLeftOut(vtkIdType voxel)
{
  return vtkMediumFixtures::Random(static_cast<std::uint32_t>(voxel), 9) < 0.4;
}

vtkSmartPointer<vtkUnsignedCharArray> MakeBytes(vtkIdType count, bool leftOutIsZero)
{
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  for (vtkIdType i = 0; i < count; ++i)
  {
    bytes->InsertNextValue(IsLeftOut(i) == leftOutIsZero ? 0 : 255);
  }
  return bytes;
}

vtkSmartPointer<vtkImageData> MakeMask(bool onCells, bool complement = false)
{
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->SetDimensions(Size, Size, Size);
  const vtkIdType count = onCells ? mask->GetNumberOfCells() : mask->GetNumberOfPoints();
  onCells ? mask->GetCellData()->SetScalars(MakeBytes(count, !complement))
          : mask->GetPointData()->SetScalars(MakeBytes(count, !complement));
  return mask;
}

vtkSmartPointer<vtkImageData> MakeData(bool onCells, bool withZeros = false)
{
  vtkSmartPointer<vtkImageData> image = MakeGrid(glm::ivec3(Size), glm::dvec3(1), Field, onCells);
  vtkDataArray* values =
    onCells ? image->GetCellData()->GetScalars() : image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples() && withZeros; ++i)
  {
    values->SetTuple1(i, IsLeftOut(i) ? 0 : values->GetTuple1(i));
  }
  return image;
}

void Light(Setting& setting)
{
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(1, -0.4, 0.3)));
  setting.AddPointLight({ 0.5, 0.6, 1.7 });
}

const glm::dvec3 Eye(-1, 0.31, 0.43), Direction(1, 0.11, 0.07);
}

TEST(ReferenceMask, MaskAndGhostsAreVoxelsOfZeroUnderNearestInterpolation)
{
  for (bool onCells : { false, true })
  {
    Setting masked(MakeData(onCells), 5), ghosted(MakeData(onCells), 5),
      zeroed(MakeData(onCells, true), 5);
    masked.Reference->SetMaskInput(MakeMask(onCells));
    vtkImageData* image = ghosted.Reference->GetInputData();
    vtkSmartPointer<vtkUnsignedCharArray> ghosts =
      MakeBytes(onCells ? image->GetNumberOfCells() : image->GetNumberOfPoints(), false);
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    onCells ? image->GetCellData()->AddArray(ghosts) : image->GetPointData()->AddArray(ghosts);
    for (Setting* setting : { &masked, &ghosted, &zeroed })
    {
      setting->Property->SetInterpolationTypeToNearest();
      Light(*setting);
    }
    const glm::dvec4 expected = zeroed.Radiance(Eye, Direction);
    ASSERT_GT(expected.x, 1e-3);
    EXPECT_NEAR(masked.Radiance(Eye, Direction).x / expected.x, 1, 1e-9);
    EXPECT_NEAR(ghosted.Radiance(Eye, Direction).x / expected.x, 1, 1e-9);
    EXPECT_NEAR(masked.Radiance(Eye, Direction).w, expected.w, 1e-12);
    masked.Reference->SetMaskInput(nullptr);
    EXPECT_GT(std::abs(masked.Radiance(Eye, Direction).x / expected.x - 1), 1e-2);
  }
}

// Of smooth data, and of a transfer function that makes nothing of no value.
TEST(ReferenceMask, OpticalDepthsOfAMaskAndItsComplementAddUp)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0, 3);
  function->AddPoint(0.7, 1);
  function->AddPoint(1.7, 2);
  for (bool onCells : { false, true })
  {
    for (bool maskOnCells : { false, true })
    {
      for (bool mapped : { false, true })
      {
        Setting setting(MakeData(onCells), 2);
        setting.Medium->SetExtinctionFunction(mapped ? function.Get() : nullptr);
        for (int ray = 0; ray < 5; ++ray)
        {
          const glm::dvec3 way = vtkMediumFixtures::RandomDirection(ray, 21);
          const glm::dvec3 a = glm::dvec3(0.5) - way, b = glm::dvec3(0.5) + way;
          setting.Reference->SetMaskInput(nullptr);
          const double whole = setting.OpticalDepth(a, b);
          setting.Reference->SetMaskInput(MakeMask(maskOnCells));
          const double part = setting.OpticalDepth(a, b);
          setting.Reference->SetMaskInput(MakeMask(maskOnCells, true));
          EXPECT_NEAR((part + setting.OpticalDepth(a, b)) / whole, 1, mapped ? 1e-6 : 1e-12);
          EXPECT_LT(part, whole);
        }
      }
    }
  }
}

TEST(ReferenceMask, BlankedPointsAndCellsOfAUniformGridAreLeftOut)
{
  vtkNew<vtkUniformGrid> grid;
  grid->ShallowCopy(MakeData(false));
  Setting setting(grid, 2);
  const glm::dvec3 point(0.4, 0.6, 0.2), along(0.05, 0.02, 0.03); // at a point of the lattice
  EXPECT_GT(setting.OpticalDepth(point - along, point + along), 0);
  grid->BlankPoint(2, 3, 1);
  grid->Modified();
  EXPECT_EQ(setting.OpticalDepth(point - along, point + along), 0);
  grid->UnBlankPoint(2, 3, 1);
  grid->BlankCell(1, 2, 0);
  grid->Modified();
  const glm::dvec3 cell(0.3, 0.5, 0.1);
  EXPECT_EQ(setting.OpticalDepth(cell - along, cell + along), 0);
  EXPECT_GT(setting.OpticalDepth(cell + glm::dvec3(0.2, 0, 0), cell + glm::dvec3(0.2, 0, 0.1)), 0);
}

// Scattering and emission that do not come from the extinction.
TEST(ReferenceMask, WhatIsLeftOutNeitherScattersNorShines)
{
  vtkSmartPointer<vtkImageData> mask = MakeMask(false);
  mask->GetPointData()->GetScalars()->Fill(0);
  Setting setting(MakeData(false), 2);
  Light(setting);
  setting.Medium->SetEmission(3);
  EXPECT_GT(setting.Radiance(Eye, Direction).x, 1);
  setting.Reference->SetMaskInput(mask);
  EXPECT_EQ(setting.Radiance(Eye, Direction), glm::dvec4(0));
}
