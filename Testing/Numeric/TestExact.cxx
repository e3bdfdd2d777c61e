// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Exact against vtkSingleScatteringReference, which shares none of its code.
#include "ReferenceScene.h"

#include "vtkPiecewiseFunction.h"

using namespace vtkMediumTest;

namespace
{
// What the integrator promises, of the peak; each of its parts may be off by 4e-6.
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

// A step of the function: extinction jumps inside of cells, on eye rays and on light rays that graze it.
TEST(Exact, MeetsTheTruthOnABallWithASharpSurface)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.Window->SetSize(24, 24);
  scene.Mapper->SetInputData(MakeImage(
    glm::ivec3(24), glm::dvec3(1), [](const glm::dvec3& p) { return 0.4 - glm::length(p); }));
  vtkNew<vtkPiecewiseFunction> extinction;
  extinction->AddPoint(-1, 0);
  extinction->AddPoint(-1e-6, 0);
  extinction->AddPoint(1e-6, 1);
  extinction->AddPoint(1, 1);
  scene.Medium->SetExtinctionFunction(extinction);
  ExpectExact(scene);
}

// Where light rays change the face by which they leave the box, the source has a kink that no cell knows of.
TEST(Exact, MeetsTheTruthInADenseBox)
{
  for (double sigma : { 3.0, 40.0, 80.0 })
  {
    Scene scene(MakeBox(), 24);
    scene.Mapper->SetIntegratorToExact();
    scene.Mapper->SetTransmittanceThreshold(0);
    scene.Medium->SetExtinctionArrayName(""); // of data, since a constant is not marched
    scene.Medium->SetExtinctionScale(sigma);
    const glm::dvec3 beam = glm::normalize(glm::dvec3(0.3, -0.8, -0.4));
    scene.AddBeam(beam);
    scene.Look({ 0.4, -0.3, -1 }, 2.4);
    const Picture picture = scene.Render();
    double peak = 0, largest = 0;
    ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
      const double truth = Isotropic * BoxRadiance(Box(glm::dvec3(1)), ray, -beam, sigma);
      peak = std::max(peak, truth);
      largest = std::max(largest, std::abs(picture.At(x, y) - truth));
    });
    EXPECT_LT(largest, Promised * peak) << "extinction " << sigma;
  }
}
