// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// FixedStep on heterogeneous media against vtkSingleScatteringReference, which shares none of its code.
#include "ReferenceScene.h"

using namespace vtkMediumTest;

namespace
{
constexpr double Voxel = ReferenceVoxel;

/// The slope of log error over log step, by least squares.
double Order(const std::vector<double>& steps, const std::vector<double>& errors)
{
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const double u = std::log(steps[i]), v = std::log(errors[i]);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const double n = static_cast<double>(steps.size());
  return (n * xy - x * y) / (n * xx - x * x);
}
}

TEST(AgainstReference, SmoothFieldConvergesInSecondOrder)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.FindTruth();
  ASSERT_GT(scene.Peak, 0.01);
  std::vector<double> steps, largest, mean;
  // From 2 voxels, beyond which light rays, whose steps come in fours, do not follow the step, to 1/4,
  // below which float's rounding, some 1e-6 of the peak, shows.
  for (double step : { 2 * Voxel, Voxel, 0.5 * Voxel, 0.25 * Voxel })
  {
    const ReferenceScene::Errors errors = scene.Measure(step);
    steps.push_back(step);
    largest.push_back(errors.Largest);
    mean.push_back(errors.RootMeanSquare);
  }
  EXPECT_NEAR(Order(steps, largest), 2, 0.15);
  EXPECT_NEAR(Order(steps, mean), 2, 0.15);
  EXPECT_LT(largest[1], 5e-4); // at the default step, one voxel
}

TEST(AgainstReference, SmoothFieldIsMetClosely)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure(Voxel / 8);
  EXPECT_LT(errors.Largest, 1e-4);
  EXPECT_LT(errors.Alpha, 2e-5);
}

TEST(AgainstReference, ConeThatCutsTheFieldConvergesInFirstOrder)
{
  // Light ends abruptly at the cone: the step that it falls into is lit or not.
  ReferenceScene scene(vtkMediumFixtures::Smooth, false, 12);
  scene.FindTruth();
  std::vector<double> steps, mean;
  for (double step : { 2 * Voxel, Voxel, 0.5 * Voxel, 0.25 * Voxel })
  {
    steps.push_back(step);
    mean.push_back(scene.Measure(step).RootMeanSquare);
  }
  EXPECT_GT(Order(steps, mean), 0.8);
  EXPECT_LT(mean.back(), 2e-3);
}

TEST(AgainstReference, CloudConvergesToTheReference)
{
  // Detail down to the voxel: second order only below it, and less where the cloud's edge clips.
  ReferenceScene scene(vtkMediumFixtures::Cloud);
  scene.FindTruth();
  std::vector<double> steps, mean;
  for (double step : { Voxel, 0.5 * Voxel, 0.25 * Voxel, 0.125 * Voxel })
  {
    steps.push_back(step);
    mean.push_back(scene.Measure(step).RootMeanSquare);
  }
  EXPECT_GT(Order(steps, mean), 1.6);
  EXPECT_LT(mean[0], 5e-3);
  EXPECT_LT(mean.back(), 2e-4);
}

TEST(AgainstReference, BinaryFieldConvergesToTheReference)
{
  // Jumps between neighbouring points are ramps one voxel wide, kinked at both ends.
  for (bool onCells : { false, true })
  {
    SCOPED_TRACE(onCells ? "cells" : "points");
    ReferenceScene scene(vtkMediumFixtures::Binary, onCells);
    scene.FindTruth();
    std::vector<double> steps, mean;
    for (double step : { Voxel, 0.5 * Voxel, 0.25 * Voxel, 0.125 * Voxel })
    {
      steps.push_back(step);
      mean.push_back(scene.Measure(step).RootMeanSquare);
    }
    EXPECT_GT(Order(steps, mean), 1.4);
    EXPECT_LT(mean.back(), 5e-4);
  }
}

// The estimate of a frame is the error that it has: never far below it where it matters, not far above.
TEST(AgainstReference, ErrorEstimateIsTheErrorOfTheFrame)
{
  ReferenceScene scene(vtkMediumFixtures::Cloud);
  scene.FindTruth();
  for (double step : { Voxel, 0.5 * Voxel })
  {
    scene.SetSteps(step, step);
    scene.Mapper->SetOutputToRadiance();
    const Picture radiance = scene.Render();
    scene.Mapper->SetOutputToErrorEstimate();
    const Picture estimate = scene.Render();
    double largest = 0, estimated = 0, sum = 0, estimatedSum = 0;
    for (int y = 0; y < scene.Truth.Size.y; ++y)
    {
      for (int x = 0; x < scene.Truth.Size.x; ++x)
      {
        const int i = scene.Stride * x, j = scene.Stride * y;
        const double error = std::abs(radiance.At(i, j, 0) - scene.Truth.At(x, y, 0));
        largest = std::max(largest, error);
        estimated = std::max(estimated, double(estimate.At(i, j, 0)));
        sum += error;
        estimatedSum += estimate.At(i, j, 0);
      }
    }
    // Single pixels converge by uneven steps on a cloud; the largest and the sum are within a factor 3.
    EXPECT_GT(estimated, largest / 3) << step;
    EXPECT_LT(estimated, largest * 3) << step;
    EXPECT_GT(estimatedSum, sum / 3) << step;
    EXPECT_LT(estimatedSum, sum * 3) << step;
  }
}
