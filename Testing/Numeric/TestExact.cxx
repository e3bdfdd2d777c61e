// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Exact against vtkSingleScatteringReference, which shares none of its code.
#include "ReferenceScene.h"

#include "vtkPiecewiseFunction.h"

using namespace vtkMediumTest;

namespace
{
// What the integrator promises, of the peak; its parts agree with their halves to 4e-6 each.
constexpr double Promised = 1e-4;

void ExpectExact(ReferenceScene& scene)
{
  scene.Mapper->SetIntegratorToExact();
  scene.FindTruth();
  ASSERT_GT(scene.Peak, 0.01);
  const ReferenceScene::Errors errors = scene.Measure();
  EXPECT_LT(errors.Largest, Promised);
  EXPECT_LT(errors.Alpha, 2e-5); // optical depth in closed form: rounding alone
}
}

TEST(Exact, MeetsTheTruthOnASmoothField)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  ExpectExact(scene);
}

TEST(Exact, MeetsTheTruthOnACloud)
{
  ReferenceScene scene(vtkMediumFixtures::Cloud);
  ExpectExact(scene);
}

TEST(Exact, MeetsTheTruthOnBinaryVoxels)
{
  ReferenceScene scene(vtkMediumFixtures::Binary);
  ExpectExact(scene);
}

TEST(Exact, MeetsTheTruthOnCells)
{
  ReferenceScene scene(vtkMediumFixtures::Cloud, true);
  ExpectExact(scene);
}

TEST(Exact, MeetsTheTruthWithNearestVoxels)
{
  ReferenceScene scene(vtkMediumFixtures::Cloud);
  scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
  ExpectExact(scene);
}

// Knots inside of cells, and a step.
TEST(Exact, HonoursTheKnotsOfATransferFunction)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(0, 0);
  extinction->AddPoint(0.2, 0);
  extinction->AddPoint(0.25, 1);
  extinction->AddPoint(0.6, 0.5);
  extinction->AddPoint(1, 1);
  scene.Medium->SetExtinctionFunction(extinction);
  scene.Mapper->SetIntegratorToExact();
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure();
  EXPECT_LT(errors.Largest, Promised);
  // The field is a cubic along a ray, and counts as linear in a sixth of a cell.
  EXPECT_LT(errors.Alpha, 1e-4);
}
