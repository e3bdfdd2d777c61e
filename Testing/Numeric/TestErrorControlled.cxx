// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// ErrorControlled: the error that was asked for, what was skipped on the way, and what was not done twice.
#include "ReferenceScene.h"

#include "vtkLightCollection.h"
#include "vtkPiecewiseFunction.h"

using namespace vtkMediumTest;

namespace
{
constexpr double Step8Bit = 1.0 / 255;

// A grey medium, which light caches can serve.
struct ControlledScene : ReferenceScene
{
  explicit ControlledScene(vtkMediumFixtures::Fields field)
    : ReferenceScene(field)
  {
    this->Medium->SetExtinctionScale(6);
    this->Mapper->SetIntegratorToErrorControlled();
  }
};
}

TEST(ErrorControlled, MeetsTheErrorOnEveryField)
{
  for (vtkMediumFixtures::Fields field :
    { vtkMediumFixtures::Smooth, vtkMediumFixtures::Cloud, vtkMediumFixtures::Binary })
  {
    ControlledScene scene(field);
    scene.FindTruth();
    for (double maximum : { 4 * Step8Bit, Step8Bit, 0.25 * Step8Bit })
    {
      scene.Mapper->SetMaximumError(maximum);
      const ReferenceScene::Errors errors = scene.Measure();
      EXPECT_LE(errors.Largest, maximum) << "field " << field;
      EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest) << "field " << field;
    }
  }
}

TEST(ErrorControlled, SaysWhatAlwaysUsingCachesCosts)
{
  ControlledScene scene(vtkMediumFixtures::Binary);
  scene.Mapper->SetLightCachesToAlways();
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure();
  EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest);
  EXPECT_GT(scene.Mapper->GetEstimatedError(), Step8Bit) << "voxels of 0 and 1 are beyond them";
}

// Dense where the scalar passes a threshold, as bone beside air: extinction is no affine function of the
// scalar, and falls from one voxel to the next.
TEST(ErrorControlled, MarchesToCachesWhereLookUpsErr)
{
  ControlledScene scene(vtkMediumFixtures::Cloud);
  vtkNew<vtkPiecewiseFunction> dense;
  dense->AddPoint(0.1, 0);
  dense->AddPoint(0.25, 0.02);
  dense->AddPoint(0.35, 1);
  scene.Medium->SetExtinctionFunction(dense);
  scene.Medium->SetExtinctionScale(80);
  scene.FindTruth();
  scene.Mapper->GetStatistics()->CountTapsOn();
  for (double maximum : { 4 * Step8Bit, Step8Bit })
  {
    vtkTypeInt64 taps[2];
    for (bool caches : { false, true })
    {
      scene.Mapper->SetMaximumError(maximum);
      caches ? scene.Mapper->SetLightCachesToWhereAccurate()
             : scene.Mapper->SetLightCachesToNever();
      const ReferenceScene::Errors errors = scene.Measure();
      EXPECT_LE(errors.Largest, maximum) << caches;
      EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest) << caches;
      EXPECT_EQ(scene.Mapper->GetStatistics()->GetLightMethod(),
        caches ? vtkMediumStatistics::LightMarchedToItsCache : vtkMediumStatistics::LightMarched);
      taps[caches] = scene.Mapper->GetStatistics()->GetTaps();
    }
    EXPECT_LT(taps[1], taps[0] / 2);
    vtkMediumStatistics* done = scene.Mapper->GetStatistics();
    EXPECT_GT(done->GetRaysRefined(), 0);
  }
}

// Only the pixels whose look-ups may err by more than the error are integrated anew, and all keep it.
TEST(ErrorControlled, RefinesOnlyPixelsWhoseLookUpsMayErr)
{
  for (vtkMediumFixtures::Fields field : { vtkMediumFixtures::Cloud, vtkMediumFixtures::Binary })
  {
    ControlledScene scene(field);
    scene.Medium->SetExtinctionScale(20);
    scene.FindTruth();
    scene.Mapper->GetStatistics()->CountTapsOn();
    vtkTypeInt64 taps = 0;
    for (double maximum : { 8 * Step8Bit, 4 * Step8Bit, 2 * Step8Bit, Step8Bit, 0.5 * Step8Bit })
    {
      scene.Mapper->SetMaximumError(maximum);
      const ReferenceScene::Errors errors = scene.Measure();
      EXPECT_LE(errors.Largest, maximum);
      EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest);
      vtkMediumStatistics* done = scene.Mapper->GetStatistics();
      EXPECT_EQ(done->GetLightMethod(), vtkMediumStatistics::LightMarchedToItsCache);
      EXPECT_GT(done->GetRaysRefined(), 0);
      EXPECT_LT(done->GetRaysRefined(), 0.6 * done->GetRays());
      EXPECT_GT(done->GetTaps(), taps) << "a larger error costs less";
      taps = done->GetTaps();
    }
  }
}

// Steps grow behind what hides them; the plain way, FixedStep in the same step, takes more.
TEST(ErrorControlled, GrowsStepsWhereLittleIsSeen)
{
  ControlledScene scene(vtkMediumFixtures::Smooth);
  scene.Medium->SetExtinctionScale(40);
  scene.Mapper->SetLightCachesToNever();
  scene.FindTruth();
  scene.Mapper->GetStatistics()->CountTapsOn();
  const ReferenceScene::Errors grown = scene.Measure();
  EXPECT_LE(grown.Largest, Step8Bit);
  const vtkTypeInt64 taps = scene.Mapper->GetStatistics()->GetTaps();
  const double step = scene.Mapper->GetStatistics()->GetEyeStep();
  scene.Mapper->SetIntegratorToFixedStep();
  const ReferenceScene::Errors plain = scene.Measure(step);
  EXPECT_LE(plain.Largest, Step8Bit);
  EXPECT_LT(taps, 0.75 * scene.Mapper->GetStatistics()->GetTaps());
}

// The plain way, FixedStep in the same step, sees the same picture: bricks and tiles leave nothing out.
TEST(ErrorControlled, LeapsWithoutLeavingAnythingOut)
{
  ControlledScene scene(vtkMediumFixtures::Binary);
  scene.Mapper->SetLightCachesToNever();
  scene.Mapper->SetMaximumError(0.05 * Step8Bit);
  const Picture leapt = scene.Render();
  EXPECT_GT(scene.Mapper->GetStatistics()->GetBricksLeapt(), 0);
  scene.Mapper->SetIntegratorToFixedStep();
  const double step = scene.Mapper->GetStatistics()->GetEyeStep();
  scene.SetSteps(step, step);
  const Picture plain = scene.Render();
  double largest = 0, peak = 0;
  for (std::size_t i = 0; i < plain.Values.size(); ++i)
  {
    largest = std::max(largest, std::abs(double(plain.Values[i]) - leapt.Values[i]));
    peak = std::max(peak, double(plain.Values[i]));
  }
  // Where rays enter the occupied tiles their samples begin anew; a brick that is missed errs by far more.
  EXPECT_LT(largest, 2e-4 * peak);
}

TEST(ErrorControlled, CameraAndColourRebuildNothing)
{
  ControlledScene scene(vtkMediumFixtures::Smooth);
  scene.Render();
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  EXPECT_EQ(done->GetBrickBuilds(), 1);
  EXPECT_EQ(done->GetLightCacheBuilds(), 3); // one a light
  const vtkTypeInt64 compiles = done->GetProgramCompiles(), uploads = done->GetTextureUploads();

  scene.Camera->Azimuth(2);
  scene.Render();
  EXPECT_EQ(done->GetCalibrations(), 1) << "a small move";
  vtkLight* light = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
  light->SetDiffuseColor(0.2, 0.4, 0.9);
  scene.Medium->SetAlbedo(0.5);
  scene.Render();
  EXPECT_EQ(done->GetBrickBuilds(), 1);
  EXPECT_EQ(done->GetLightCacheBuilds(), 3);
  EXPECT_EQ(done->GetTextureUploads(), uploads);
  EXPECT_EQ(done->GetProgramCompiles(), compiles);

  light->SetPosition(2, 2, 2);
  scene.Render();
  EXPECT_EQ(done->GetLightCacheBuilds(), 4) << "one light moved";
  scene.Medium->SetExtinctionScale(3);
  scene.Render();
  EXPECT_EQ(done->GetBrickBuilds(), 2);
  EXPECT_EQ(done->GetLightCacheBuilds(), 7) << "another extinction";
}

TEST(ErrorControlled, DensityScaleKeepsTheCaches)
{
  ControlledScene scene(vtkMediumFixtures::Smooth);
  scene.Render();
  const vtkTypeInt64 builds = scene.Mapper->GetStatistics()->GetLightCacheBuilds();
  scene.Medium->SetDensityScale(0.5);
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure();
  EXPECT_LE(errors.Largest, Step8Bit);
  EXPECT_EQ(scene.Mapper->GetStatistics()->GetLightCacheBuilds(), builds);
}

// 16 bits of data and 16 of a light's shadow; the rest, tables and images, is small beside them.
TEST(ErrorControlled, TakesFourBytesAVoxelForShortsAndOneLight)
{
  const int points = 96;
  Scene scene(MakeImage(
                glm::ivec3(points), glm::dvec3(1),
                [](const glm::dvec3& p) { return std::round(1000 * std::exp(-glm::dot(p, p))); },
                false, VTK_SHORT),
    32);
  scene.Mapper->SetIntegratorToErrorControlled();
  scene.Mapper->SetMaximumError(4 * Step8Bit); // that plain look-ups keep
  scene.Medium->SetExtinctionArrayName("");
  scene.Medium->SetExtinctionScale(0.004);
  scene.AddBeam({ 1, -0.8, -0.2 });
  ASSERT_TRUE(scene.Render().IsLight());
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  EXPECT_EQ(done->GetLightMethod(), vtkMediumStatistics::LightLookedUp);
  const double bytes = static_cast<double>(done->GetGPUBytes()) / std::pow(points, 3);
  EXPECT_GE(bytes, 4);
  EXPECT_LE(bytes, 6);
}
