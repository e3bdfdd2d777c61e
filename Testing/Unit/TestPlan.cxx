// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A plan decides what a scene needs and what it does not; each decision is a row here.
#include "PlanSetting.h"

#include <cmath>
#include <limits>

using namespace vtkMediumTest;

//------------------------------------------------------------------------------
TEST(Plan, FollowsNoLightRayWhereNothingScattersOrShines)
{
  vtkMediumScene dark = MakeScene(), black = MakeScene();
  dark.Lights.clear();
  black.Content.Scattering.Scale = glm::dvec3(0);
  for (const vtkMediumScene& scene : { dark, black })
  {
    for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
    {
      const vtkMediumPlan plan(scene, With(integrator), Device());
      EXPECT_TRUE(plan.Refusal.empty()) << plan.Refusal;
      EXPECT_FALSE(plan.Lit);
      EXPECT_EQ(plan.CachedLights, 0);
      EXPECT_FALSE(Has(plan, "LIT"));
      EXPECT_FALSE(Reads(plan, "LightRay") || Reads(plan, "LightCache"));
    }
  }
  EXPECT_TRUE(vtkMediumPlan(MakeScene(), With(Mapper::FixedStep), Device()).Lit);
}

//------------------------------------------------------------------------------
TEST(Plan, FollowsNoLightRayForDistancesAndOpticalDepths)
{
  for (int output : { Mapper::FirstHit, Mapper::Distance, Mapper::Transmittance,
         Mapper::OpticalDepth, Mapper::Depth })
  {
    Settings settings = With(Mapper::FixedStep);
    settings.Output = output;
    EXPECT_FALSE(vtkMediumPlan(MakeScene(), settings, Device()).Lit) << output;
  }
  Settings mean = With(Mapper::FixedStep);
  mean.Output = Mapper::Depth;
  mean.DepthDefinition = Mapper::MeanScatteringDepth;
  EXPECT_TRUE(vtkMediumPlan(MakeScene(), mean, Device()).Lit);
}

//------------------------------------------------------------------------------
TEST(Plan, CachesLightsOnlyWhereOneGreyTrilinearLookUpIsRight)
{
  const Settings settings = With(Mapper::ErrorControlled);
  vtkMediumScene scene = MakeScene();
  EXPECT_EQ(vtkMediumPlan(scene, settings, Device()).CachedLights, 1);

  vtkMediumScene chromatic = scene, nearest = scene, many = scene, plain = scene;
  chromatic.Content.ChromaticExtinction = true;
  nearest.Content.Fields[0].Linear = false;
  many.Lights.resize(vtkMediumPlan::MostCachedLights + 1, scene.Lights[0]);
  for (const vtkMediumScene& other : { chromatic, nearest, many })
  {
    const vtkMediumPlan plan(other, settings, Device());
    EXPECT_EQ(plan.CachedLights, 0);
    EXPECT_TRUE(Reads(plan, "LightRay"));
  }
  EXPECT_EQ(vtkMediumPlan(plain, With(Mapper::FixedStep), Device()).CachedLights, 0);
}

//------------------------------------------------------------------------------
TEST(Plan, KeepsLightCachesWithinTheirMemory)
{
  const vtkMediumScene scene = MakeScene();
  Settings settings = With(Mapper::ErrorControlled);
  settings.LightCacheBytes = 2 * 100 * 100 * 100;
  EXPECT_EQ(vtkMediumPlan(scene, settings, Device()).CachedLights, 1);
  --settings.LightCacheBytes;
  EXPECT_EQ(vtkMediumPlan(scene, settings, Device()).CachedLights, 0);
}

//------------------------------------------------------------------------------
TEST(Plan, PutsNoNumberIntoTheProgram)
{
  const vtkMediumScene scene = MakeScene();
  vtkMediumScene other = scene;
  other.Content.Extinction.Scale *= 3.0;
  other.Content.DensityScale = 7;
  other.Content.Scattering.Scale = glm::dvec3(0.5, 0.25, 0.125);
  other.Lights[0].Irradiance = glm::dvec3(9, 8, 7);
  other.Lights[0].Direction = glm::dvec3(1, 0, 0);
  other.Geometry.Length = 12;
  for (int integrator :
    { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    Settings changed = With(integrator);
    changed.TransmittanceThreshold = 0.25;
    changed.Jitter = 0.125;
    const vtkMediumPlan plan(scene, With(integrator), Device());
    const vtkMediumPlan next(other, changed, Device());
    EXPECT_EQ(plan.ShaderDefines, next.ShaderDefines);
    EXPECT_EQ(plan.ShaderFiles, next.ShaderFiles);
  }
}

//------------------------------------------------------------------------------
TEST(Plan, LeavesOutWhatTheSceneLacks)
{
  vtkMediumScene scene = MakeScene();
  const Settings settings = With(Mapper::FixedStep);
  const vtkMediumPlan plain(scene, settings, Device());
  EXPECT_FALSE(Has(plain, "POSITIONAL_LIGHTS") || Has(plain, "SPOT_LIGHTS"));
  EXPECT_FALSE(Has(plain, "EMISSION(box)"));
  EXPECT_FALSE(Has(plain, "CHROMATIC_EXTINCTION"));
  EXPECT_FALSE(Has(plain, "COUNT_TAPS"));
  EXPECT_TRUE(Has(plain, "PHASE(angle, g) PHASE_0(")); // g is 0

  scene.Lights[0].Type = vtkMediumScene::Light::Spot;
  scene.Content.Emission.Scale = glm::dvec3(1);
  scene.Content.Anisotropy.Scale = glm::dvec3(0.5);
  scene.Content.ChromaticExtinction = true;
  const vtkMediumPlan rich(scene, settings, Device());
  EXPECT_TRUE(Has(rich, "POSITIONAL_LIGHTS") && Has(rich, "SPOT_LIGHTS"));
  EXPECT_TRUE(Has(rich, "EMISSION(box)"));
  EXPECT_TRUE(Has(rich, "CHROMATIC_EXTINCTION"));
  EXPECT_TRUE(Has(rich, "PHASE(angle, g) PHASE_2("));
}

//------------------------------------------------------------------------------
// Mesa's software renderers end a fragment's loops, in silence, after 65,536 iterations in one draw.
TEST(Plan, KeepsEveryDrawWithinTheLoopLimit)
{
  vtkMediumScene scene = MakeScene();
  const Device device;
  for (double step : { 1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-9 })
  {
    for (int lights : { 0, 1, 3, 40 })
    {
      scene.Lights.resize(lights, MakeScene().Lights[0]);
      Settings settings = With(Mapper::FixedStep);
      settings.SampleDistance = step;
      const vtkMediumPlan plan(scene, settings, device);
      const double eyeSteps = std::ceil(1 / plan.EyeStep);
      const double lightIterations =
        std::ceil(1 / (plan.LightStep * vtkMediumPlan::LightTapsPerIteration));
      int light = 0, next = 0;
      for (const vtkMediumPlan::Pass& pass : plan.Passes)
      {
        const double iterations = (pass.LastStep - pass.FirstStep) *
          (1 + (pass.LastLight - pass.FirstLight) * (1 + lightIterations));
        EXPECT_LE(iterations, device.LoopIterations) << step << ' ' << lights;
        // Draws follow each other without a gap: all steps for some lights, then for the next ones.
        EXPECT_EQ(pass.FirstLight, light);
        EXPECT_EQ(pass.FirstStep, next);
        next = pass.LastStep;
        if (next >= eyeSteps + 2)
        {
          light = pass.LastLight;
          next = 0;
        }
      }
      EXPECT_EQ(light, lights);
      EXPECT_EQ(next, 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(Plan, TakesOneVoxelForAStepThatIsNotSet)
{
  const vtkMediumScene scene = MakeScene();
  Settings settings = With(Mapper::FixedStep);
  EXPECT_DOUBLE_EQ(vtkMediumPlan(scene, settings, Device()).EyeStep, 0.01);
  settings.SampleDistance = 0.5;
  EXPECT_DOUBLE_EQ(vtkMediumPlan(scene, settings, Device()).LightStep, 0.05);
  settings.LightSampleDistance = 0.25;
  EXPECT_DOUBLE_EQ(vtkMediumPlan(scene, settings, Device()).LightStep, 0.025);
}

//------------------------------------------------------------------------------
TEST(Plan, RefusesNumbersWithoutMeaningAndNamesThem)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  struct Row
  {
    double Settings::*Member;
    double Value;
    const char* Named;
  };
  for (const Row& row :
    { Row{ &Settings::SampleDistance, -0.5, "-0.5" }, Row{ &Settings::SampleDistance, nan, "nan" },
      Row{ &Settings::LightSampleDistance, -2, "-2" }, Row{ &Settings::Jitter, 1, "1" },
      Row{ &Settings::Jitter, nan, "nan" }, Row{ &Settings::TransmittanceThreshold, 1.5, "1.5" },
      Row{ &Settings::MaximumError, 0, "0" }, Row{ &Settings::DepthTransmittance, 1, "1" },
      Row{ &Settings::PaperThreshold, 7, "7" }, Row{ &Settings::PaperThreshold, nan, "nan" } })
  {
    Settings settings = With(Mapper::Paper);
    settings.*row.Member = row.Value;
    const vtkMediumPlan plan(MakeScene(), settings, Device());
    EXPECT_NE(plan.Refusal.find(row.Named), std::string::npos) << plan.Refusal;
    EXPECT_NE(plan.Refusal.find("Set"), std::string::npos) << "names the setter that mends it";
  }
}

//------------------------------------------------------------------------------
TEST(Plan, NamesBothNumbersBeyondTheTextureLimit)
{
  Device device;
  device.TextureSize3D = 64;
  const vtkMediumPlan plan(MakeScene(), With(Mapper::FixedStep), device);
  EXPECT_NE(plan.Refusal.find("100"), std::string::npos) << plan.Refusal;
  EXPECT_NE(plan.Refusal.find("64"), std::string::npos) << plan.Refusal;
}

//------------------------------------------------------------------------------
TEST(Plan, FoldsWhatIsLongerThanATexture)
{
  Device device;
  device.TextureSize3D = 64;
  vtkMediumScene scene = MakeScene();
  scene.Scalars.Dimensions = scene.Content.Fields[0].Dimensions = { 100, 30, 30 };
  for (int integrator :
    { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    Settings settings = With(integrator);
    settings.PaperThreshold = 0.5;
    if (integrator == Mapper::Paper)
    {
      scene.Content.Extinction = Coefficient();
    }
    const vtkMediumPlan plan(scene, settings, device);
    EXPECT_EQ(plan.Refusal, "") << integrator;
    EXPECT_TRUE(plan.Folded && Has(plan, "FOLDED")) << integrator;
    const vtkMediumPlan whole(scene, settings, Device());
    EXPECT_FALSE(whole.Folded || Has(whole, "FOLDED")) << integrator;
    scene.Content = MakeScene().Content;
    scene.Content.Fields[0].Dimensions = { 100, 30, 30 };
  }
}

//------------------------------------------------------------------------------
TEST(Plan, CutsByWhatTheSceneHasAndNothingElse)
{
  using Plane = vtkMediumCut::Plane;
  const vtkMediumScene whole = MakeScene();
  vtkMediumScene clipped = whole, cropped = whole;
  clipped.Cut.Planes.assign(3, Plane());
  clipped.Lights[0].Direction = { 0, 0, 1 }; // from behind planes that keep what is above
  cropped.Cut.Regions = 0x5;
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    const vtkMediumPlan plain(whole, With(integrator), Device());
    EXPECT_TRUE(Reads(plain, "KeptInterval"));
    EXPECT_FALSE(Reads(plain, "KeptRegions") || Reads(plain, "ClippingPlanes"));
    EXPECT_FALSE(Has(plain, "CLIPPING_PLANES"));
    const vtkMediumPlan byPlanes(clipped, With(integrator), Device());
    EXPECT_TRUE(Reads(byPlanes, "KeptInterval") && Reads(byPlanes, "ClippingPlanes"));
    EXPECT_TRUE(Has(byPlanes, "CLIPPING_PLANES 3"));
    const vtkMediumPlan byRegions(cropped, With(integrator), Device());
    EXPECT_TRUE(Reads(byRegions, "KeptRegions"));
    EXPECT_FALSE(Reads(byRegions, "KeptInterval") || Reads(byRegions, "ClippingPlanes"));
  }
  clipped.Cut.Planes.assign(vtkMediumPlan::MostClippingPlanes + 1, Plane());
  EXPECT_NE(
    vtkMediumPlan(clipped, With(Mapper::Exact), Device()).Refusal.find("17"), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(Plan, KeepsCachesOfTheWholeVolumeWhereNoLightRayIsCut)
{
  vtkMediumScene scene = MakeScene();
  scene.Cut.Planes.resize(1); // keeps z >= 0
  vtkMediumScene::Light& light = scene.Lights[0];
  const auto whole = [&scene] {
    const vtkMediumPlan plan(scene, With(Mapper::ErrorControlled), Device());
    EXPECT_EQ(plan.CachedLights, 1);
    return !plan.CutCaches;
  };
  light.Direction = { 0.6, 0, -0.8 };
  EXPECT_TRUE(whole());
  light.Direction = { 0.6, 0, 0.8 };
  EXPECT_FALSE(whole());
  light.Type = vtkMediumScene::Light::Point;
  light.Position = { 3, 2, 0.1 };
  EXPECT_TRUE(whole());
  light.Position = { 3, 2, -0.1 };
  EXPECT_FALSE(whole());
  light.Position = { 3, 2, 0.1 };
  scene.Cut.Regions = 0x5;
  EXPECT_FALSE(whole());
}

//------------------------------------------------------------------------------
// Each part of a ray ends with a step of its own, and the passes have room for them.
TEST(Plan, HasStepsForEveryPartThatCroppingLeaves)
{
  vtkMediumScene cropped = MakeScene();
  const vtkMediumPlan plain(cropped, With(Mapper::FixedStep), Device());
  cropped.Cut.Regions = 0x5;
  const vtkMediumPlan plan(cropped, With(Mapper::FixedStep), Device());
  EXPECT_GE(
    plan.Passes.back().LastStep, plain.Passes.back().LastStep + vtkMediumPlan::MostKeptParts);
}

//------------------------------------------------------------------------------
TEST(Plan, LeavesVoxelsOutOnlyWhereThereIsAMask)
{
  const vtkMediumScene whole = MakeScene();
  vtkMediumScene masked = whole;
  vtkMediumField mask = whole.Content.Fields[0];
  mask.Linear = false;
  masked.Content.Masks.push_back(1);
  masked.Content.Fields.push_back(mask);
  for (int integrator :
    { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    Settings settings = With(integrator);
    settings.Output = integrator == Mapper::Paper ? Mapper::Distance : Mapper::Radiance;
    vtkMediumScene constant = masked;
    constant.Content.Extinction = Coefficient();
    constant.Content.Extinction.Scale = glm::dvec3(1);
    const bool paper = integrator == Mapper::Paper;
    const vtkMediumPlan plan(paper ? constant : masked, settings, Device());
    ASSERT_TRUE(plan.Refusal.empty()) << plan.Refusal;
    EXPECT_TRUE(Has(plan, "MASK(box) (fieldNearest(1, box))"));
    EXPECT_EQ(plan.Fields.size(), 2u);
    EXPECT_EQ(plan.CachedLights, 0);
    if (integrator == Mapper::Exact)
    {
      EXPECT_EQ(plan.Lattices.size(), 2u) << "voxels have other borders than linear cells";
    }
    if (!paper)
    {
      EXPECT_FALSE(Has(vtkMediumPlan(whole, settings, Device()), "MASK"));
    }
  }
}
