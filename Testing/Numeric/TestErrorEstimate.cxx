// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What ErrorControlled says of its own error: one number, and a picture.
#include "ReferenceScene.h"

#include "vtkHardwareSelector.h"

using namespace vtkMediumTest;

namespace
{
constexpr double Step8Bit = 1.0 / 255;

/// A grey medium, which light caches can serve.
struct EstimateScene : ReferenceScene
{
  /// With a truth of the pixels of a stride; 0: without.
  explicit EstimateScene(vtkMediumFixtures::Fields field, int stride = 2)
    : ReferenceScene(field)
  {
    this->Medium->SetExtinctionScale(6);
    this->Mapper->SetIntegratorToErrorControlled();
    this->Stride = stride;
    if (stride > 0)
    {
      this->FindTruth();
    }
  }
};

/// Of the pixels that are compared, red: fractions of the peak.
struct Compared
{
  double Largest = 0, Sum = 0, EstimatedLargest = 0, EstimatedSum = 0;
};

Compared Compare(EstimateScene& scene)
{
  scene.Mapper->SetOutputToRadiance();
  const Picture radiance = scene.Render();
  scene.Mapper->SetOutputToErrorEstimate();
  const Picture estimate = scene.Render();
  EXPECT_TRUE(estimate.IsLight());
  Compared compared;
  for (int y = 0; y < scene.Truth.Size.y; ++y)
  {
    for (int x = 0; x < scene.Truth.Size.x; ++x)
    {
      const int i = scene.Stride * x, j = scene.Stride * y;
      const double error = std::abs(radiance.At(i, j) - scene.Truth.At(x, y)) / scene.Peak;
      const double estimated = estimate.At(i, j) / scene.Peak;
      compared.Largest = std::max(compared.Largest, error);
      compared.EstimatedLargest = std::max(compared.EstimatedLargest, estimated);
      compared.Sum += error;
      compared.EstimatedSum += estimated;
    }
  }
  return compared;
}
}

// The safety that is held against what probes miss is in it. Where caches are accurate enough as they are, it
// is six times what the worst of a few probes says, and more than three times the error.
TEST(ErrorEstimate, NumberIsWithinAFactorOfThreeOfTheError)
{
  for (vtkMediumFixtures::Fields field :
    { vtkMediumFixtures::Smooth, vtkMediumFixtures::Cloud, vtkMediumFixtures::Binary })
  {
    EstimateScene scene(field, 1);
    field == vtkMediumFixtures::Smooth ? scene.Mapper->SetLightCachesToNever()
                                       : scene.Mapper->SetLightCachesToWhereAccurate();
    for (double maximum : { Step8Bit, 0.25 * Step8Bit })
    {
      SCOPED_TRACE(testing::Message() << "field " << field << ", " << 255 * maximum << " / 255");
      scene.Mapper->SetMaximumError(maximum);
      const ReferenceScene::Errors errors = scene.Measure();
      EXPECT_LE(errors.Largest, maximum);
      EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest);
      EXPECT_LE(scene.Mapper->GetEstimatedError(), 3 * errors.Largest);
    }
  }
}

// Single pixels converge by uneven steps; the largest and the sum are within a factor 3.
TEST(ErrorEstimate, ImageIsTheErrorOfTheFrame)
{
  for (vtkMediumFixtures::Fields field :
    { vtkMediumFixtures::Smooth, vtkMediumFixtures::Cloud, vtkMediumFixtures::Binary })
  {
    EstimateScene scene(field);
    for (bool caches : { false, true })
    {
      caches ? scene.Mapper->SetLightCachesToWhereAccurate()
             : scene.Mapper->SetLightCachesToNever();
      for (double maximum : { 4 * Step8Bit, Step8Bit })
      {
        SCOPED_TRACE(testing::Message()
          << "field " << field << ", caches " << caches << ", " << 255 * maximum << " / 255");
        scene.Mapper->SetMaximumError(maximum);
        const Compared compared = Compare(scene);
        EXPECT_GT(compared.EstimatedLargest, compared.Largest / 3);
        EXPECT_LT(compared.EstimatedLargest, compared.Largest * 3);
        EXPECT_GT(compared.EstimatedSum, compared.Sum / 3);
        EXPECT_LT(compared.EstimatedSum, compared.Sum * 3);
      }
    }
  }
}

// Both of the frames that it compares look light up in the same caches.
TEST(ErrorEstimate, ImageLeavesOutTheErrorOfCaches)
{
  for (vtkMediumFixtures::Fields field : { vtkMediumFixtures::Cloud, vtkMediumFixtures::Binary })
  {
    EstimateScene scene(field);
    scene.Mapper->SetLightCachesToAlways();
    const Compared compared = Compare(scene);
    EXPECT_LT(compared.EstimatedLargest, compared.Largest / 3) << "field " << field;
    EXPECT_GT(compared.EstimatedLargest, 0) << "field " << field;
    EXPECT_GE(scene.Mapper->GetEstimatedError(), compared.Largest) << "the number has it";
  }
}

// Where the eye has moved a selection finds a step of its own; what the last frame left stays.
TEST(ErrorEstimate, ImageSurvivesASelection)
{
  EstimateScene scene(vtkMediumFixtures::Smooth, 0);
  scene.Mapper->SetOutputToErrorEstimate();
  const Picture before = scene.Render();
  EXPECT_GT(before.Mean(), 0);
  scene.Camera->Azimuth(60);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, scene.Pixels - 1, scene.Pixels - 1);
  selector->CaptureBuffers();
  vtkNew<vtkImageData> image;
  scene.Mapper->GetColorImage(image);
  EXPECT_EQ(before.Values, Picture(image).Values);
}
