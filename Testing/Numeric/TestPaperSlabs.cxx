// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The Paper integrator on slabs: every filled interval, or only the first, as the paper assumes.
#include "PaperFields.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
constexpr double Sigma = 3;
const glm::dvec3 ToLight(0.6, 0, 0.8);

/// Radiance of slab number k (0: nearer to +z) at a ray whose |cosine| with z is mu. The light comes
/// from +z as well, with cosine 0.8, through what is above.
double SlabRadiance(int k, double mu, double thickness, bool throughTheFirst)
{
  const double before = throughTheFirst ? k * thickness : 0;
  const double d = thickness / mu;
  return Isotropic * Sigma * std::exp(-Sigma * before * (1 / mu + 1 / ToLight.z)) * d *
    MeanTransmittance(Sigma * d * (1 + mu / ToLight.z));
}

/// The view from +z, of slabs that are wider than what is seen or lit.
void LookAtSlabs(Scene& scene)
{
  scene.Look({ 0.3, 0.2, -1 }, 2);
  scene.Camera->SetViewAngle(20);
  scene.AddBeam(-ToLight);
  scene.Medium->SetExtinction(Sigma);
  scene.SetSteps(0.0025, 0.01);
}
}

TEST(PaperSlabs, RadianceIsTheSumOverEveryInterval)
{
  PaperScene scene(MakeTwoSlabs(), 12);
  LookAtSlabs(scene);
  const Picture picture = scene.Render();
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const double mu = std::abs(ray.Direction.z);
    const double truth = SlabRadiance(0, mu, 0.3, true) + SlabRadiance(1, mu, 0.3, true);
    // Left Riemann: sigma (1 / mu + 1 / 0.8) mu h / 2 = 0.85 % at most.
    ASSERT_NEAR(picture.At(x, y), truth, 0.01 * truth) << x << ", " << y;
    ASSERT_GT(picture.At(x, y), truth) << "a left Riemann sum of a falling source";
    ASSERT_NEAR(picture.At(x, y, 3), -std::expm1(-Sigma * 0.6 / mu), 1e-4) << x << ", " << y;
  });
}

TEST(PaperSlabs, AssumeConvexEndsAtTheFirstExit)
{
  PaperScene scene(MakeTwoSlabs(), 12);
  LookAtSlabs(scene);
  scene.Mapper->AssumeConvexOn();
  const Picture picture = scene.Render();
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const double mu = std::abs(ray.Direction.z);
    const double truth = SlabRadiance(0, mu, 0.3, true);
    ASSERT_NEAR(picture.At(x, y), truth, 0.01 * truth) << x << ", " << y;
    ASSERT_NEAR(picture.At(x, y, 3), -std::expm1(-Sigma * 0.3 / mu), 1e-4) << x << ", " << y;
  });
}

TEST(PaperSlabs, AssumeConvexEndsLightRaysAtTheirFirstExit)
{
  // Seen from below, the lower slab comes first, and is lit as if nothing were above it.
  PaperScene scene(MakeTwoSlabs(), 8);
  LookAtSlabs(scene);
  scene.LookParallel({ 0, 0, 1 }, 2, 0.2);
  const double d = 0.3, kappa = -1 / ToLight.z; // the light path shortens on the way up
  auto truth = [&](double above) {
    return Isotropic * Sigma * std::exp(-Sigma * (d + above) / ToLight.z) * d *
      MeanTransmittance(Sigma * d * (1 + kappa));
  };
  const double upper = std::exp(-Sigma * d) * truth(0);
  const Picture all = scene.Render();
  EXPECT_NEAR(all.At(4, 4) / (truth(d) + upper), 1, 0.01);
  scene.Mapper->AssumeConvexOn();
  EXPECT_NEAR(scene.Render().At(4, 4) / truth(0), 1, 0.01);
}

TEST(PaperSlabs, DistanceIsFromFirstToLastPoint)
{
  PaperScene scene(MakeTwoSlabs(), 12);
  LookAtSlabs(scene);
  scene.SetSteps(0.05, 0.05);
  scene.Mapper->SetOutputToDistance();
  const Picture all = scene.Render();
  scene.Mapper->AssumeConvexOn();
  const Picture first = scene.Render();
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const double mu = std::abs(ray.Direction.z);
    ASSERT_NEAR(all.At(x, y), 0.8 / mu, 1e-4); // 0.05 / 2^11 at each end
    ASSERT_NEAR(first.At(x, y), 0.3 / mu, 1e-4);
  });
}

TEST(PaperSlabs, ThresholdMovesTheFaces)
{
  PaperScene scene(MakeSlab(), 8);
  scene.Mapper->SetOutputToDistance();
  scene.LookParallel({ 0, 0, -1 }, 2, 0.2);
  scene.SetSteps(0.05, 0.05);
  for (double threshold : { -0.15, 0.0, 0.1, 0.25 })
  {
    scene.Mapper->SetPaperThreshold(threshold);
    EXPECT_NEAR(scene.Render().At(4, 4), 2 * (0.3 - threshold), 1e-4) << threshold;
  }
  scene.Mapper->SetPaperThreshold(-10); // below all values: the whole box is filled
  EXPECT_NEAR(scene.Render().At(4, 4), 1, 1e-5);
}

TEST(PaperSlabs, RadianceConvergesInFirstOrder)
{
  PaperScene scene(MakeSlab(), 8);
  scene.Medium->SetExtinction(Sigma);
  scene.AddBeam(-ToLight);
  scene.LookParallel({ 0.3, 0.2, -1 }, 2, 0.2);
  const double mu = 1 / glm::length(glm::dvec3(0.3, 0.2, 1));
  const double truth = SlabRadiance(0, mu, 0.6, false);
  double before = 0;
  for (double step : { 0.08, 0.04, 0.02, 0.01 })
  {
    scene.SetSteps(step, 0.005);
    const double error = std::abs(scene.Render().Mean() - truth);
    if (before > 0)
    {
      EXPECT_GT(before / error, 1.6) << "step " << step;
      EXPECT_LT(before / error, 2.6) << "step " << step;
    }
    before = error;
  }
}

TEST(PaperSlabs, CameraInsideTheMediumStartsThere)
{
  PaperScene scene(MakeSlab(), 8);
  scene.SetSteps(0.01, 0.01);
  scene.Look({ 0, 0, -1 }, 0.1);
  scene.Camera->SetClippingRange(1e-3, 10);
  scene.Mapper->SetOutputToDistance();
  const Picture distance = scene.Render();
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const double truth = 0.4 / std::abs(ray.Direction.z) - ray.Near;
    ASSERT_NEAR(distance.At(x, y), truth, 1e-4) << x << ", " << y;
  });
}

TEST(PaperSlabs, StepLongerThanTheBoxIsOneSample)
{
  PaperScene scene(MakeBox(), 8);
  scene.Medium->SetExtinction(2);
  scene.AddBeam({ 0, 0, -1 });
  scene.LookParallel({ 0, 0, -1 }, 2, 0.3);
  scene.SetSteps(1e3, 1e3);
  const Picture picture = scene.Render();
  // The whole box from its first point, which nothing weakens.
  EXPECT_NEAR(picture.At(4, 4), Isotropic * 2, 1e-5);
  EXPECT_NEAR(picture.At(4, 4, 3), -std::expm1(-2.0), 1e-5);
}
