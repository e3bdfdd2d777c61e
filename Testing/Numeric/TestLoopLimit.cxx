// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Long marches arrive. Mesa's software renderers end every loop of a fragment, in silence, once 65,536
// iterations have been spent in it; the mapper splits its marches over several draws.
#include "ClosedForms.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
/// Four pixels look along the diagonal of a unit box that is lit along another. Its extinction is that of an
/// array, since light rays in a constant one are not marched.
struct DiagonalScene : Scene
{
  const double Diagonal = std::sqrt(3.0);
  const glm::dvec3 ToLight = glm::normalize(glm::dvec3(1, 1, 0.9));

  explicit DiagonalScene(bool fromArray = true)
    : Scene(MakeBox(), 2)
  {
    this->Mapper->SetTransmittanceThreshold(0);
    this->Mapper->SetJitter(0);
    if (fromArray)
    {
      this->Medium->SetExtinctionArrayName("");
    }
    this->LookParallel({ -1, -1, -1 }, 3, 0.002);
    this->AddBeam(-this->ToLight);
  }

  double Depth()
  {
    const std::array<double, 2> t = Box(glm::dvec3(1)).Intersect(EyeRay(this->Camera, 2, 1, 1));
    return t[1] - t[0];
  }

  double Truth()
  {
    return Isotropic *
      BoxRadiance(Box(glm::dvec3(1)), EyeRay(this->Camera, 2, 1, 1), this->ToLight, 1);
  }
};
}

TEST(LoopLimit, ThousandByThousandStepsAreTruthA)
{
  DiagonalScene scene;
  scene.SetSteps(scene.Diagonal / 1000, scene.Diagonal / 1000);
  scene.Mapper->GetStatistics()->CountTapsOn();
  const Picture picture = scene.Render();
  const double truth = scene.Truth();
  EXPECT_NEAR(picture.At(1, 1), truth, 1e-4 * truth + 1e-6);
  EXPECT_GT(scene.Mapper->GetStatistics()->GetPasses(), 1);
  // Half of 1000 x 1000 steps are in the box, for each of 4 pixels.
  EXPECT_GT(scene.Mapper->GetStatistics()->GetTaps(), 4 * 300000);
}

TEST(LoopLimit, PapersThousandByThousandStepsAreTruthA)
{
  DiagonalScene scene(false);
  scene.Mapper->SetIntegratorToPaper();
  scene.SetSteps(scene.Diagonal / 1000, scene.Diagonal / 1000);
  const Picture picture = scene.Render();
  const double truth = scene.Truth();
  // A left Riemann sum of 1000 steps is good to sigma h / 2 x 2 / (1 - T), 0.3 % here.
  EXPECT_NEAR(picture.At(1, 1), truth, 3e-3 * truth);
  EXPECT_NEAR(picture.At(1, 1, 3), -std::expm1(-scene.Depth()), 1e-4);
  EXPECT_GT(scene.Mapper->GetStatistics()->GetPasses(), 1);
}

TEST(LoopLimit, HundredThousandEyeStepsAreTruthA)
{
  DiagonalScene scene;
  scene.SetSteps(scene.Diagonal / 100000, scene.Diagonal);
  const Picture picture = scene.Render();
  const double truth = scene.Truth();
  EXPECT_NEAR(picture.At(1, 1), truth, 1e-4 * truth + 1e-6);
  EXPECT_NEAR(picture.At(1, 1, 3), -std::expm1(-scene.Depth()), 1e-4);
  EXPECT_GT(scene.Mapper->GetStatistics()->GetPasses(), 1);
}

// A light ray through a constant extinction is one segment, but a loop for all that.
TEST(LoopLimit, ManyEyeStepsInAConstantExtinctionAreTruthA)
{
  Scene scene(MakeBox(), 24);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.Medium->SetExtinction(3);
  const glm::dvec3 beam = glm::normalize(glm::dvec3(0.3, -0.8, -0.4));
  scene.AddBeam(beam);
  scene.Look({ 0.4, -0.3, -1 }, 2.4);
  scene.SetSteps(3e-5, 0.3);
  const Picture picture = scene.Render();
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const double truth = Isotropic * BoxRadiance(Box(glm::dvec3(1)), ray, -beam, 3);
    ASSERT_NEAR(picture.At(x, y), truth, 1e-4 * truth + 2e-6) << x << ", " << y;
  });
}

TEST(LoopLimit, HundredThousandLightStepsAreTruthA)
{
  DiagonalScene scene;
  scene.SetSteps(scene.Diagonal / 50, scene.Diagonal / 100000);
  const Picture picture = scene.Render();
  const double truth = scene.Truth();
  // 50 midpoint steps of 0.035: (2 sigma h)^2 / 24 = 2e-4.
  EXPECT_NEAR(picture.At(1, 1), truth, 4e-4 * truth);
}

TEST(LoopLimit, ManyLightsWithLongMarchesAddUp)
{
  DiagonalScene scene;
  scene.SetSteps(scene.Diagonal / 200, scene.Diagonal / 4000);
  const double one = scene.Render().At(1, 1);
  for (int i = 1; i < 20; ++i)
  {
    scene.AddBeam(-scene.ToLight);
  }
  EXPECT_NEAR(scene.Render().At(1, 1) / (20 * one), 1, 1e-4);
  EXPECT_GT(scene.Mapper->GetStatistics()->GetPasses(), 20);
}

TEST(LoopLimit, SplitMarchEqualsTheUnsplit)
{
  // 20 equal lights force a split; their mean is the picture of one light of one pass.
  DiagonalScene scene;
  scene.SetSteps(scene.Diagonal / 100, scene.Diagonal / 100);
  const double unsplit = scene.Render().At(1, 1);
  ASSERT_EQ(scene.Mapper->GetStatistics()->GetPasses(), 1);
  for (int i = 1; i < 40; ++i)
  {
    scene.AddBeam(-scene.ToLight);
  }
  EXPECT_NEAR(scene.Render().At(1, 1) / (40 * unsplit), 1, 2e-6);
  EXPECT_GT(scene.Mapper->GetStatistics()->GetPasses(), 1);
}
