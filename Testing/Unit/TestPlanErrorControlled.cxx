// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What ErrorControlled decides beyond the step: where steps grow, where light is marched.
#include "PlanSetting.h"

using namespace vtkMediumTest;

//------------------------------------------------------------------------------
TEST(Plan, StepsGrowWhereTheOutputIsSeenThroughWhatIsBeforeThem)
{
  for (int output : { Mapper::Radiance, Mapper::Transmittance, Mapper::SampleCount,
         Mapper::ErrorEstimate, Mapper::FirstHit, Mapper::Depth })
  {
    Settings settings = With(Mapper::ErrorControlled);
    settings.Output = output;
    EXPECT_EQ(
      vtkMediumPlan(MakeScene(), settings, Device()).EyeStretch, vtkMediumPlan::ErrorStretch)
      << output;
    settings.Integrator = Mapper::FixedStep;
    EXPECT_EQ(vtkMediumPlan(MakeScene(), settings, Device()).EyeStretch, 0) << output;
  }
  for (int output : { Mapper::OpticalDepth, Mapper::Distance })
  {
    Settings settings = With(Mapper::ErrorControlled);
    settings.Output = output;
    EXPECT_EQ(vtkMediumPlan(MakeScene(), settings, Device()).EyeStretch, 0) << output;
  }
}

//------------------------------------------------------------------------------
TEST(Plan, MarchesToCachesThatSayHowRoughTheyAre)
{
  vtkMediumScene scene = MakeScene();
  Settings settings = With(Mapper::ErrorControlled);
  const vtkMediumPlan plain(scene, settings, Device());
  EXPECT_FALSE(Has(plain, "LIGHT_CACHE_ROUGHNESS"));
  EXPECT_TRUE(Reads(plain, "LightCache"));
  EXPECT_FALSE(Reads(plain, "LightMarchToCache") || Reads(plain, "LightSteps"));

  settings.LightMethod = vtkMediumPlan::MarchThenLookUp;
  settings.LightTolerance = 0.25;
  settings.PixelTolerance = 0.125;
  const vtkMediumPlan rough(scene, settings, Device());
  EXPECT_TRUE(Has(rough, "LIGHT_CACHE_ROUGHNESS"));
  EXPECT_FALSE(Reads(rough, "LightMarchToCache")) << "at first, all pixels look up";
  EXPECT_EQ(rough.GetLightsPerTexture(), 2);
  EXPECT_TRUE(rough.NeedsState()) << "the second draw reads what the first found";
  EXPECT_FALSE(plain.Rough);
  ASSERT_TRUE(rough.Rough);
  EXPECT_FALSE(rough.Rough->Rough);
  EXPECT_TRUE(Has(*rough.Rough, "LIGHT_CACHE_ROUGHNESS"));
  EXPECT_TRUE(Has(*rough.Rough, "ONLY_ROUGH") && !Has(rough, "ONLY_ROUGH"));
  EXPECT_TRUE(Reads(*rough.Rough, "LightMarchToCache"));
  EXPECT_EQ(rough.Rough->LightTolerance, 0.25);
  EXPECT_EQ(rough.Rough->PixelTolerance, 0.125);
  EXPECT_EQ(rough.Rough->EyeStep, rough.EyeStep);
  EXPECT_EQ(rough.Coarser().Rough->EyeStep, 2 * rough.EyeStep);
  EXPECT_GE(rough.Rough->Passes.size(), rough.Passes.size()) << "light rays may reach their ends";
  for (double voxels : { 4.0, 0.5, 0.1 })
  {
    settings.ControlledStep = voxels * scene.Geometry.VoxelLength / scene.Geometry.Length;
    const vtkMediumPlan steps = *vtkMediumPlan(scene, settings, Device()).Rough;
    const double spacing = voxels * vtkMediumPlan::LightTapsPerIteration * steps.LightLookUpEvery;
    EXPECT_GE(spacing, 0.75 * vtkMediumPlan::LookUpSpacing)
      << "look-ups do not crowd in short steps";
  }
  settings.ControlledStep = 0;

  scene.Lights.resize(vtkMediumPlan::MostCachedLights / 2 + 1, scene.Lights[0]);
  EXPECT_EQ(vtkMediumPlan(scene, settings, Device()).CachedLights, 0) << "no texture is left";
  settings.LightMethod = vtkMediumPlan::LookUp;
  EXPECT_GT(vtkMediumPlan(scene, settings, Device()).CachedLights, 0);
}
