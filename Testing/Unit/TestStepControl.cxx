// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The step control sees only images; here they come from known convergence laws.
#include "vtkMediumStepControl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace
{
constexpr double Voxel = 0.01;
constexpr double Peak = 2;

vtkMediumScene MakeScene()
{
  vtkMediumScene scene;
  scene.Eye.Origin = { 0, 0, 3 };
  scene.Eye.ClipW = { 0, 0, -1, 3 };
  scene.Lights.resize(1);
  return scene;
}

using Image = vtkMediumStepControl::Image;
using Light = vtkMediumStepControl::Light;
using Law = std::function<Image(double step)>;

// A scene without light caches.
vtkMediumStepControl::Probes Marched(const Law& law)
{
  vtkMediumStepControl::Probes probes;
  probes.InSteps = [law](const Light&, double step) { return law(step); };
  return probes;
}

// Pixels whose error is factor x (step / voxel)^order of the peak.
Law Power(double factor, double order)
{
  return [=](double step) {
    const double error = factor * std::pow(step / Voxel, order);
    const float bright = static_cast<float>(Peak);
    const float wrong = static_cast<float>(0.5 * Peak * (1 + 2 * error));
    return Image{ bright, bright, bright, 1, wrong, 0, 0, 1 };
  };
}

// Caches of which a pixel errs by `lookUp` where it may err by `bound`, and where its light rays are marched up
// to a tolerance by `marched` of it, but not by less than `least`; all of the peak.
struct CacheLaw
{
  double LookUp, Bound, Marched, Least;
};

vtkMediumStepControl::Probes Caches(const CacheLaw& law, int& asked)
{
  vtkMediumStepControl::Probes probes = Marched(Power(1e-3, 2));
  probes.Caches = vtkMediumStepControl::WhereAccurate;
  probes.InLight = [=, &asked](const Light& light, double) {
    ++asked;
    const bool anew = law.Bound * Peak > light.PixelTolerance;
    const double error = light.Method == vtkMediumPlan::March ? 0
      : light.Method == vtkMediumPlan::MarchThenLookUp && anew
      ? std::max(law.Marched * light.Tolerance / Peak, law.Least)
      : law.LookUp;
    return Image{ float(Peak), float(Peak), float(Peak), 1, float(Peak * error), 0, 0, 1 };
  };
  probes.Bounds = [=] { return std::vector<float>{ 0, float(law.Bound * Peak) }; };
  return probes;
}
}

//------------------------------------------------------------------------------
// More than the worst probe's error must meet the maximum, and the step must not be much finer than that.
TEST(StepControl, MeetsTheErrorWithoutWaste)
{
  for (double order : { 1.0, 2.0 })
  {
    for (double factor : { 1e-4, 1e-3, 1e-2 })
    {
      vtkMediumStepControl control;
      const double maximum = 1.0 / 255;
      control.Calibrate(MakeScene(), maximum, Voxel, Marched(Power(factor, order)));
      const double error = factor * std::pow(control.GetStep() / Voxel, order);
      EXPECT_LE(error, maximum) << order << ' ' << factor;
      const bool coarsest = control.GetStep() > 7 * Voxel;
      EXPECT_TRUE(coarsest || error > maximum / 12) << order << ' ' << factor << ' ' << error;
      EXPECT_GE(control.GetEstimatedError() * 1.01, error);
      EXPECT_LE(control.GetEstimatedError(), 6 * error + 1e-9);
    }
  }
}

//------------------------------------------------------------------------------
TEST(StepControl, EndsOnImagesThatDoNotConverge)
{
  vtkMediumStepControl control;
  int calls = 0;
  const auto flicker = [&](double) {
    ++calls;
    return Image{ static_cast<float>(calls % 2), 1, 1, 1 };
  };
  control.Calibrate(MakeScene(), 1e-6, Voxel, Marched(flicker));
  EXPECT_LE(calls, 10);
  EXPECT_GT(control.GetStep(), 0);
  EXPECT_GT(control.GetEstimatedError(), 1e-6) << "it must not claim what it did not reach";
}

//------------------------------------------------------------------------------
// Random settings found a number of steps beyond int here.
TEST(StepControl, PlansNoStepBelowTheShortest)
{
  vtkMediumScene scene = MakeScene();
  scene.Geometry.VoxelLength = 1e-40;
  for (int integrator : { 1, 2 }) // FixedStep, ErrorControlled
  {
    vtkMediumPlan::Settings settings;
    settings.Integrator = integrator;
    for (double step : { 0.0, 1e-300 })
    {
      settings.ControlledStep = settings.ControlledLightStep = step;
      const vtkMediumPlan plan(scene, settings, vtkMediumPlan::Capabilities());
      EXPECT_TRUE(plan.Refusal.empty()) << plan.Refusal;
      EXPECT_GE(plan.EyeStep, vtkMediumPlan::ShortestStep);
      EXPECT_GE(plan.LightStep, vtkMediumPlan::ShortestStep);
    }
  }
}

//------------------------------------------------------------------------------
TEST(StepControl, DoesNotResolveVoxelsThatAreFlatBeyondMeasure)
{
  vtkMediumStepControl control;
  double shortest = 1;
  int number = 0;
  control.Calibrate(MakeScene(), 1e-3, 1e-40, Marched([&](double step) {
    shortest = std::min(shortest, step);
    const float wrong = ++number % 2 ? 0.5f : 1; // never converges
    return Image{ float(Peak), float(Peak), float(Peak), 1, wrong, 0, 0, 1 };
  }));
  EXPECT_GT(shortest, 0.4 * vtkMediumPlan::ShortestStep);
  EXPECT_LT(number, 20);
}

//------------------------------------------------------------------------------
// Two steps that err by the same, as when all rays meet a kink at the same place of a step.
TEST(StepControl, DoesNotBelieveAChangeThatVanishesAtOnce)
{
  vtkMediumStepControl control;
  const double maximum = 1e-3;
  int number = 0;
  const double errors[] = { 0.5, 0.1, 0.1, 0.02, 0.005, 0.00125, 0.0003, 0.0001, 0.00003, 0.00001 };
  std::vector<double> steps;
  control.Calibrate(MakeScene(), maximum, 0.0625, Marched([&](double step) {
    steps.push_back(step);
    const float wrong = static_cast<float>(0.5 * Peak * (1 + 2 * errors[number++]));
    const float bright = static_cast<float>(Peak);
    return Image{ bright, bright, bright, 1, wrong, 0, 0, 1 };
  }));
  EXPECT_LT(control.GetStep(), steps[2]);
  EXPECT_GT(number, 4);
  const auto taken = std::find_if(
    steps.begin(), steps.end(), [&](double step) { return step <= control.GetStep(); });
  const double before = errors[taken - steps.begin() - 1];
  EXPECT_LE(before, 4 * maximum) << "of the step before the one that was taken";
}

//------------------------------------------------------------------------------
TEST(StepControl, TakesLongStepsThroughAnImageWithoutLight)
{
  vtkMediumStepControl control;
  control.Calibrate(MakeScene(), 1.0 / 255, Voxel, Marched([](double) { return Image(8, 0.0f); }));
  EXPECT_GT(control.GetStep(), 4 * Voxel);
  EXPECT_EQ(control.GetEstimatedError(), 0);
}

//------------------------------------------------------------------------------
TEST(StepControl, IsRepeatedOnlyForMaterialChanges)
{
  vtkMediumStepControl control;
  vtkMediumScene scene = MakeScene();
  const double maximum = 1.0 / 255;
  EXPECT_FALSE(control.IsCalibrated(scene, maximum, vtkMediumStepControl::Never));
  control.Calibrate(scene, maximum, Voxel, Marched(Power(1e-3, 2)));
  EXPECT_TRUE(control.IsCalibrated(scene, maximum, vtkMediumStepControl::Never));

  vtkMediumScene moved = scene;
  moved.Eye.Origin += glm::dvec3(0.1, 0, 0);
  EXPECT_TRUE(control.IsCalibrated(moved, maximum, vtkMediumStepControl::Never)) << "a small move";
  moved.Eye.Origin = { 3, 0, 0 };
  EXPECT_FALSE(control.IsCalibrated(moved, maximum, vtkMediumStepControl::Never)) << "another side";

  moved = scene;
  moved.Eye.Direction = { 0.3, 0, -1 };
  EXPECT_TRUE(control.IsCalibrated(moved, maximum, vtkMediumStepControl::Never)) << "off centre";
  moved.Eye.ClipW = { 0.3, 0, -1, 3 };
  EXPECT_FALSE(control.IsCalibrated(moved, maximum, vtkMediumStepControl::Never)) << "turned";

  EXPECT_FALSE(control.IsCalibrated(scene, maximum / 2, vtkMediumStepControl::Never))
    << "another error";
  vtkMediumScene relit = scene;
  relit.Lights[0].Direction = { 1, 0, 0 };
  EXPECT_FALSE(control.IsCalibrated(relit, maximum, vtkMediumStepControl::Never))
    << "another light";
  vtkMediumScene denser = scene;
  denser.Content.DensityScale = 3;
  EXPECT_FALSE(control.IsCalibrated(denser, maximum, vtkMediumStepControl::Never))
    << "another density";
}

//------------------------------------------------------------------------------
TEST(StepControl, TwoEyesKeepTheirOwnSteps)
{
  vtkMediumStepControl control;
  const auto never = vtkMediumStepControl::Never;
  const double maximum = 1.0 / 255;
  vtkMediumScene left = MakeScene(), right = MakeScene();
  left.Eye.Origin = { -0.1, 0, 0 }; // inside the volume, where a tenth of the distance is little
  right.Eye.Origin = { 0.1, 0, 0 };
  control.Calibrate(left, maximum, Voxel, Marched(Power(1e-3, 2)));
  const double coarse = control.GetStep();
  EXPECT_FALSE(control.IsCalibrated(right, maximum, never));
  control.Calibrate(right, maximum, Voxel, Marched(Power(1e-2, 2)));
  const double fine = control.GetStep();
  EXPECT_LT(fine, coarse);
  for (int frame = 0; frame < 3; ++frame)
  {
    EXPECT_TRUE(control.IsCalibrated(left, maximum, never));
    EXPECT_EQ(control.GetStep(), coarse);
    EXPECT_TRUE(control.IsCalibrated(right, maximum, never));
    EXPECT_EQ(control.GetStep(), fine);
  }
  // A new content or error starts anew.
  control.Calibrate(left, maximum / 2, Voxel, Marched(Power(1e-3, 2)));
  EXPECT_FALSE(control.IsCalibrated(right, maximum / 2, never));
  left.Content.DensityScale = 2;
  control.Calibrate(left, maximum / 2, Voxel, Marched(Power(1e-3, 2)));
  left.Content.DensityScale = 1;
  EXPECT_FALSE(control.IsCalibrated(left, maximum / 2, never));
}

//------------------------------------------------------------------------------
TEST(StepControl, ChoosesTheCheapestLightThatIsAccurateEnough)
{
  const double maximum = 1.0 / 255;
  struct Case
  {
    CacheLaw Law;
    vtkMediumPlan::LightMethods Expected;
  };
  for (const Case& row : { Case{ { 0, 0, 1, 0 }, vtkMediumPlan::LookUp },
         Case{ { 0.1 * maximum, maximum, 1, 0 }, vtkMediumPlan::LookUp },
         Case{ { 0.2 * maximum, 2 * maximum, 1, 0 }, vtkMediumPlan::MarchThenLookUp },
         Case{ { 2 * maximum, 2 * maximum, 0.01, 0 }, vtkMediumPlan::MarchThenLookUp },
         Case{ { 2 * maximum, 2 * maximum, 1, 0 }, vtkMediumPlan::MarchThenLookUp },
         Case{ { 2 * maximum, 2 * maximum, 1, maximum }, vtkMediumPlan::March } })
  {
    vtkMediumStepControl control;
    int asked = 0;
    vtkMediumStepControl::Probes probes = Caches(row.Law, asked);
    control.Calibrate(MakeScene(), maximum, Voxel, probes);
    const Light& light = control.GetLight();
    EXPECT_EQ(light.Method, row.Expected) << row.Law.LookUp << ' ' << row.Law.Marched;
    EXPECT_LE(control.GetEstimatedError(), maximum * 1.001);
    EXPECT_GE(control.GetEstimatedError(), light.Error);
    if (light.Method == vtkMediumPlan::MarchThenLookUp)
    {
      EXPECT_LE(row.Law.Marched * light.Tolerance / Peak, maximum);
      EXPECT_GE(light.Error, 0.005 * maximum * std::min(row.Law.Marched, 1.0)) << "no waste";
    }

    probes.Caches = vtkMediumStepControl::Always;
    control.Calibrate(MakeScene(), maximum, Voxel, probes);
    EXPECT_EQ(control.GetLight().Method, vtkMediumPlan::LookUp);
    EXPECT_GE(control.GetEstimatedError(), row.Law.LookUp)
      << "it says what always using them costs";
  }
}

//------------------------------------------------------------------------------
// Pixels whose look-ups err by more of what they may err by than is usual are integrated anew sooner.
TEST(StepControl, IntegratesMorePixelsAnewWhereLookUpsErrMore)
{
  const double maximum = 1.0 / 255;
  double before = 0;
  for (double part : { 3.0, 1.0, 0.6, 0.01 })
  {
    vtkMediumStepControl control;
    int asked = 0;
    control.Calibrate(
      MakeScene(), maximum, Voxel, Caches({ 3 * maximum, 3 * maximum / part, 0.1, 0 }, asked));
    const Light& light = control.GetLight();
    EXPECT_EQ(light.Method, vtkMediumPlan::MarchThenLookUp);
    EXPECT_LT(part * light.PixelTolerance, maximum * Peak);
    EXPECT_GT(light.PixelTolerance, 0.5 * maximum * Peak / std::max(part, 1.0)) << "no waste";
    EXPECT_LE(light.PixelTolerance, 1.501 * maximum * Peak) << "not all of the probes' luck";
    EXPECT_GE(light.PixelTolerance, before);
    EXPECT_LE(control.GetEstimatedError(), maximum * 1.001);
    before = light.PixelTolerance;
  }
}

//------------------------------------------------------------------------------
TEST(StepControl, AsksForTheErrorOfLookUpsOnce)
{
  vtkMediumStepControl control;
  int asked = 0;
  const vtkMediumStepControl::Probes probes = Caches({ 0, 0, 1, 0 }, asked);
  control.Calibrate(MakeScene(), 1.0 / 255, Voxel, probes);
  EXPECT_EQ(asked, 4) << "marched in three steps, and looked up";
  control.Calibrate(MakeScene(), 0.5 / 255, Voxel, probes);
  EXPECT_EQ(asked, 4) << "kept while content, lights and eye are the same";
  vtkMediumScene turned = MakeScene();
  turned.Eye.LocalToClip[0][1] = 0.1;
  control.Calibrate(turned, 1.0 / 255, Voxel, probes);
  EXPECT_EQ(asked, 8) << "another eye sees another image";
}

//------------------------------------------------------------------------------
// A dim medium hides what is behind it: the error of alpha counts, but not by the peak of its radiance.
TEST(StepControl, MeasuresAlphaByItself)
{
  const Image dim = { 0.01f, 0.01f, 0.01f, 0.5f }, denser = { 0.01f, 0.01f, 0.01f, 0.501f };
  EXPECT_NEAR(vtkMediumStepSearch::RelativeDifference(denser, dim), 0.001, 1e-6);
  const Image brighter = { 0.0101f, 0.01f, 0.01f, 0.5f };
  EXPECT_NEAR(vtkMediumStepSearch::RelativeDifference(brighter, dim), 0.01, 1e-6);
  const Image dark = { 0, 0, 0, 0.5f }, black = { 0, 0, 0, 0.6f };
  EXPECT_NEAR(vtkMediumStepSearch::RelativeDifference(black, dark), 0.1, 1e-6);
}
