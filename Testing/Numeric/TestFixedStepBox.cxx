// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// FixedStep in a homogeneous box under a directional light, whose radiance has a closed form: what TestClosedForms' table does not hold.
#include "ClosedForms.h"

#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <limits>

using namespace vtkMediumTest;

namespace
{
const glm::dvec3 Size(1, 0.8, 0.5);
constexpr double Far = std::numeric_limits<double>::infinity();

/// The stress matrix' Q: 1e-4 of the truth, for float's rounding along the march and the second-order
/// error of the steps that each test chooses, and 2e-6 absolute, for rays that graze an edge.
void ExpectPixel(double value, double truth, int x, int y)
{
  ASSERT_NEAR(value, truth, 1e-4 * truth + 2e-6) << "pixel " << x << ", " << y;
}

/// Radiance and alpha of every pixel against truth A.
void ExpectTruthA(Scene& scene, const glm::dvec3& toLight, double sigma, const Box& box = Box(Size))
{
  const Picture picture = scene.Render();
  ASSERT_TRUE(picture.IsLight());
  int hits = 0;
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const std::array<double, 2> t = box.Intersect(ray);
    const double d = std::max(t[1] - t[0], 0.0);
    hits += d > 0;
    ExpectPixel(picture.At(x, y, 3), -std::expm1(-sigma * d), x, y);
    ExpectPixel(picture.At(x, y), Isotropic * BoxRadiance(box, ray, toLight, sigma), x, y);
  });
  EXPECT_GT(hits, scene.Pixels * scene.Pixels / 20); // the view shows the box
}

/// Steps so short that their second-order error, (sigma (1 + kappa) h)^2 / 24 with kappa <= 1, is below
/// 2e-5 wherever the light path is smooth, and p (sigma h)^2 / 4, of the step with its kink, near 1e-6.
double ShortStep(double sigma)
{
  return std::min(0.01 / sigma, 0.005);
}
}

TEST(FixedStepBox, ThinRadianceIsProportionalToThickness)
{
  Scene scene(MakeBox(Size), 12);
  scene.AddBeam({ 0, -1, 0 });
  scene.Look({ 0.2, 0.1, -1 }, 2);
  for (double sigma : { 1e-8, 1e-6, 1e-5 })
  {
    scene.Medium->SetExtinction(sigma);
    const Picture picture = scene.Render();
    ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
      const std::array<double, 2> t = Box(Size).Intersect(ray);
      const double truth = Isotropic * sigma * std::max(t[1] - t[0], 0.0);
      // Beer's law takes less than 2 sigma of it, and a float ray's length is good to 5e-7.
      ASSERT_NEAR(picture.At(x, y), truth, 1e-4 * truth + 1e-6 * sigma) << "sigma " << sigma;
    });
  }
}

TEST(FixedStepBox, OpaqueMediumIsItsFirstSurface)
{
  Scene scene(MakeBox(Size), 8);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.AddBeam({ 0, 0, -1 });
  scene.LookParallel({ 0, 0, -1 }, 2, 0.2); // inside the silhouette
  for (double sigma : { 1e6, 1e30 })
  {
    SCOPED_TRACE(testing::Message() << "sigma " << sigma);
    scene.Medium->SetExtinction(sigma);
    const Picture picture = scene.Render();
    ASSERT_TRUE(picture.IsLight());
    // Steps are far longer than a free path: the light path of the first sample, half a step, is all
    // that lights it, so nothing arrives; alpha is 1.
    for (int x = 0; x < 8; ++x)
    {
      EXPECT_EQ(picture.At(x, 4, 3), 1);
      EXPECT_LE(picture.At(x, 4), 1e-30);
    }
  }
}

TEST(FixedStepBox, StateOfTheMediumDoesNotMatter)
{
  // The same sigma as a constant, as a scaled array, by absorption and scattering, and as opacity.
  const double sigma = 2;
  const glm::dvec3 beam = glm::normalize(glm::dvec3(0.3, -0.8, -0.4));
  for (int state = 0; state < 4; ++state)
  {
    SCOPED_TRACE(testing::Message() << "state " << state);
    Scene scene(MakeBox(Size), 12);
    scene.Mapper->SetTransmittanceThreshold(0);
    scene.AddBeam(beam);
    scene.SetSteps(ShortStep(sigma), 0.3);
    scene.Look({ 0.2, 0.1, -1 }, 2);
    scene.Medium->SetExtinction(sigma);
    vtkNew<vtkPiecewiseFunction> opacity;
    if (state == 1)
    {
      scene.Medium->SetExtinctionArrayName("");
      scene.Medium->SetExtinctionScale(sigma);
    }
    else if (state == 2)
    {
      scene.Medium->SetParametrizationToAbsorptionAndScattering();
      scene.Medium->SetAbsorption(0);
      scene.Medium->SetScattering(sigma);
    }
    else if (state == 3)
    {
      // alpha over the unit distance 0.25 is 1 - exp(-sigma 0.25); white is albedo 1.
      opacity->AddPoint(0, -std::expm1(-sigma * 0.25));
      opacity->AddPoint(2, -std::expm1(-sigma * 0.25));
      vtkNew<vtkPiecewiseFunction> white;
      white->AddPoint(0, 1);
      scene.Property->SetScalarOpacity(opacity);
      scene.Property->SetColor(white);
      scene.Property->SetScalarOpacityUnitDistance(0.25);
      scene.Mapper->SetMedium(nullptr);
    }
    ExpectTruthA(scene, -beam, sigma);
  }
}

TEST(FixedStepBox, FractionalLastStepIsIntegrated)
{
  Scene scene(MakeBox(), 8);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.Medium->SetExtinction(0.5);
  scene.AddBeam({ 0, -1, 0 });
  scene.LookParallel({ 0, 0, -1 }, 2, 0.3);
  scene.SetSteps(1 / 7.3, 1 / 7.3);
  const Picture picture = scene.Render();
  // Light from above: the light path is constant along each ray, so any number of steps is exact.
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    ExpectPixel(picture.At(x, y, 3), -std::expm1(-0.5), x, y);
    ExpectPixel(
      picture.At(x, y), Isotropic * BoxRadiance(Box(glm::dvec3(1)), ray, { 0, 1, 0 }, 0.5), x, y);
  });
}

TEST(FixedStepBox, StepLongerThanTheBoxTakesOneSample)
{
  Scene scene(MakeBox(), 8);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.Medium->SetExtinction(2);
  scene.AddBeam({ 0, 0, -1 });
  scene.LookParallel({ 0, 0, -1 }, 2, 0.3);
  scene.Mapper->GetStatistics()->CountTapsOn();
  for (double step : { 1.5, 1e3, 1e30 })
  {
    scene.SetSteps(step, step);
    const Picture picture = scene.Render();
    // The middle, half a unit below the lit face, seen through the box' mean transmittance.
    const double truth = Isotropic * 2 * std::exp(-2 * 0.5) * MeanTransmittance(2);
    EXPECT_NEAR(picture.At(4, 4), truth, 1e-5 * truth) << "step " << step;
    EXPECT_NEAR(picture.At(4, 4, 3), -std::expm1(-2.0), 1e-6);
  }
  EXPECT_EQ(scene.Errors.size(), 0u);
}

TEST(FixedStepBox, ErrorFallsWithTheSquareOfTheStep)
{
  Scene scene(MakeBox(), 8);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.Medium->SetExtinction(4);
  scene.AddBeam({ 0, 0, -1 });
  scene.LookParallel({ 0, 0, -1 }, 2, 0.3);
  const double truth = Isotropic * 4 * MeanTransmittance(8);
  double before = 0;
  for (double step : { 0.25, 0.125, 0.0625, 0.03125 })
  {
    scene.SetSteps(step, step);
    const double error = std::abs(scene.Render().At(4, 4) - truth);
    if (before > 0)
    {
      // Second order: 4, and less than 10 % of higher orders at sigma h <= 1 / 2.
      EXPECT_NEAR(before / error, 4, 0.4) << "step " << step;
    }
    before = error;
  }
}

TEST(FixedStepBox, CameraInsideSeesWhatIsBeforeIt)
{
  Scene scene(MakeBox(Size), 12);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.Medium->SetExtinction(3);
  scene.SetSteps(ShortStep(3), 0.1);
  const glm::dvec3 beam = glm::normalize(glm::dvec3(0.3, -0.8, 0.4));
  scene.AddBeam(beam);
  scene.Look({ 0.3, 0.2, -1 }, 0.1, { 0.1, 0, 0 });
  for (double nearest :
    { 1e-4, 1e-2, 0.15 }) // a near plane before, at and beyond the first surface
  {
    SCOPED_TRACE(testing::Message() << "near plane " << nearest);
    scene.Camera->SetClippingRange(nearest, 10);
    ExpectTruthA(scene, -beam, 3);
  }
}

TEST(FixedStepBox, NearPlaneInsideCutsTheMedium)
{
  Scene scene(MakeBox(Size), 12);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.Medium->SetExtinction(3);
  scene.SetSteps(ShortStep(3), 0.1);
  scene.AddBeam({ 0, 0, -1 });
  scene.Look({ 0, 0, -1 }, 1);
  scene.Camera->SetClippingRange(0.9, 10); // the box reaches from 0.75 to 1.25
  ExpectTruthA(scene, { 0, 0, 1 }, 3);
  scene.LookParallel({ 0, 0, -1 }, 1, 0.6);
  scene.Camera->SetClippingRange(0.9, 10);
  ExpectTruthA(scene, { 0, 0, 1 }, 3);
}

TEST(FixedStepBox, CrossingAFaceIsContinuous)
{
  Scene scene(MakeBox(), 8);
  scene.AddBeam({ 0.2, -1, 0.1 });
  Picture before;
  for (double distance : { 0.5 + 1e-6, 0.5, 0.5 - 1e-6 })
  {
    scene.Look({ 0, 0, -1 }, distance);
    scene.Camera->SetClippingRange(1e-7, 10);
    const Picture picture = scene.Render();
    ASSERT_TRUE(picture.IsLight());
    if (!before.Values.empty())
    {
      EXPECT_LT(Difference(before, picture), 1e-4);
    }
    before = picture;
  }
}

TEST(FixedStepBox, WithoutLightOnlyAbsorptionIsLeft)
{
  Scene scene(MakeBox(Size), 12);
  scene.Medium->SetExtinction(1.5);
  scene.Mapper->SetTransmittanceThreshold(0);
  const Picture dark = scene.Render();
  vtkSmartPointer<vtkLight> light = scene.AddBeam({ 0, 0, -1 });
  light->SetIntensity(0);
  const Picture zero = scene.Render();
  EXPECT_EQ(dark.Values, zero.Values);
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const std::array<double, 2> t = Box(Size).Intersect(ray);
    EXPECT_EQ(dark.At(x, y), 0);
    ExpectPixel(dark.At(x, y, 3), -std::expm1(-1.5 * std::max(t[1] - t[0], 0.0)), x, y);
  });
  EXPECT_EQ(scene.Errors.size(), 0u);
}

TEST(FixedStepBox, PureAbsorptionIsBlackAndNoMediumIsTransparent)
{
  Scene scene(MakeBox(Size), 12);
  scene.AddBeam({ 0, 0, -1 });
  scene.Medium->SetAlbedo(0);
  const Picture absorbing = scene.Render();
  EXPECT_EQ(absorbing.Mean(0), 0);
  EXPECT_NEAR(absorbing.At(6, 6, 3), -std::expm1(-0.5), 0.02); // half a unit deep
  scene.Medium->SetExtinction(0);
  for (float value : scene.Render().Values)
  {
    ASSERT_EQ(value, 0);
  }
}
