// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What a frame does not do because its scene does not need it, by the counters.
#include "OpaquePlane.h"
#include "ReferenceScene.h"

#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkLightCollection.h"

using namespace vtkMediumTest;

namespace
{
constexpr int Integrators[] = { vtkSingleScatteringVolumeMapper::FixedStep,
  vtkSingleScatteringVolumeMapper::ErrorControlled, vtkSingleScatteringVolumeMapper::Exact };

/// A grey cloud, of which taps are counted.
struct SkipScene : ReferenceScene
{
  explicit SkipScene(int integrator, vtkMediumFixtures::Fields field = vtkMediumFixtures::Cloud)
    : ReferenceScene(field)
  {
    this->Medium->SetExtinctionScale(6);
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetMaximumError(4.0 / 255);
    this->Mapper->GetStatistics()->CountTapsOn();
    this->SetSteps(ReferenceVoxel, ReferenceVoxel);
    if (integrator == vtkSingleScatteringVolumeMapper::Exact) // which takes its time
    {
      this->Window->SetSize(24, 24);
    }
  }

  vtkMediumStatistics* Draw()
  {
    this->Render();
    EXPECT_TRUE(this->Scene::Errors.empty());
    return this->Mapper->GetStatistics();
  }
};
}

//------------------------------------------------------------------------------
TEST(Skips, WithoutLightOrScatteringNoLightRayIsFollowedAndNoCacheBuilt)
{
  for (int integrator : Integrators)
  {
    SkipScene lit(integrator), dark(integrator), black(integrator), off(integrator);
    dark.Renderer->RemoveAllLights();
    black.Medium->SetAlbedo(0);
    for (int light = 0; light < 3; ++light)
    {
      vtkLight::SafeDownCast(off.Renderer->GetLights()->GetItemAsObject(light))->SetIntensity(0);
    }
    const vtkTypeInt64 taps = lit.Draw()->GetTaps();
    vtkTypeInt64 unlit = 0;
    for (SkipScene* scene : { &dark, &black, &off })
    {
      vtkMediumStatistics* done = scene->Draw();
      EXPECT_EQ(done->GetLightCacheBuilds() + done->GetLightCacheUploads(), 0) << integrator;
      EXPECT_GT(done->GetTaps(), 0) << "it absorbs";
      EXPECT_LT(done->GetTaps(), taps) << integrator;
      EXPECT_TRUE(unlit == 0 || done->GetTaps() == unlit) << integrator;
      unlit = done->GetTaps();
    }
  }
}

//------------------------------------------------------------------------------
// A light that sends nothing into the volume costs neither a march nor a cache.
TEST(Skips, LightsThatMissTheVolumeCostNothing)
{
  for (int integrator : Integrators)
  {
    SkipScene with(integrator), without(integrator);
    vtkSmartPointer<vtkLight> spot = with.AddPointLight({ 2, 2, 2 });
    spot->SetFocalPoint(4, 4, 4);
    spot->SetConeAngle(25);
    const Picture expected = without.Render();
    EXPECT_EQ(with.Render().Values, expected.Values) << integrator;
    vtkMediumStatistics* done = with.Mapper->GetStatistics();
    EXPECT_EQ(done->GetTaps(), without.Mapper->GetStatistics()->GetTaps()) << integrator;
    EXPECT_EQ(done->GetLightCacheBuilds(), without.Mapper->GetStatistics()->GetLightCacheBuilds());
    if (integrator != vtkSingleScatteringVolumeMapper::Exact)
    {
      spot->SetFocalPoint(0, 0, 0);
      EXPECT_NE(with.Render().Values, expected.Values) << integrator;
    }
  }
}

//------------------------------------------------------------------------------
// Where nothing scatters, nothing asks for light, though the medium as a whole is lit.
TEST(Skips, PointsThatScatterNothingAskForNoLight)
{
  for (int integrator : Integrators)
  {
    SkipScene dark(integrator), scattering(integrator);
    dark.Renderer->RemoveAllLights();
    scattering.Renderer->RemoveAllLights();
    scattering.AddBeam({ 1, -0.8, -0.2 });
    vtkNew<vtkFloatArray> albedo;
    albedo->SetName("albedo");
    albedo->SetNumberOfTuples(dark.Mapper->GetInput()->GetNumberOfPoints());
    albedo->Fill(0);
    for (SkipScene* scene : { &dark, &scattering })
    {
      scene->Mapper->SetLightCachesToNever();
      scene->Mapper->GetInput()->GetPointData()->AddArray(albedo);
      scene->Medium->SetAlbedoArrayName("albedo");
    }
    // Growing steps are chosen for four segments at once where no light is marched to.
    const bool grows = integrator == vtkSingleScatteringVolumeMapper::ErrorControlled;
    EXPECT_LE(Difference(scattering.Render(), dark.Render()), grows ? 1.0 / 255 : 0) << integrator;
    const vtkTypeInt64 taps = dark.Mapper->GetStatistics()->GetTaps();
    EXPECT_NEAR(scattering.Mapper->GetStatistics()->GetTaps(), taps, grows ? 0.02 * taps : 0)
      << integrator;
    albedo->Fill(1);
    albedo->Modified();
    EXPECT_GT(scattering.Draw()->GetTaps(), taps) << integrator;
  }
}

//------------------------------------------------------------------------------
// Opaque geometry ends rays, and its depth is copied only where there is any.
TEST(Skips, RaysEndAtOpaqueGeometryWhoseDepthIsCopiedOnlyThen)
{
  for (int integrator : Integrators)
  {
    SkipScene open(integrator), half(integrator), hidden(integrator);
    for (SkipScene* scene : { &open, &half, &hidden })
    {
      scene->Look({ 0, 0, -1 }, 2.4);
    }
    Plane{ { 0, 0, 1 }, 0.3 }.AddTo(half.Renderer);
    Plane{ { 0, 0, 1 }, 0.9 }.AddTo(hidden.Renderer); // before the volume
    const vtkTypeInt64 taps = open.Draw()->GetTaps();
    EXPECT_EQ(open.Mapper->GetStatistics()->GetOpaqueDepthCopies(), 0);
    EXPECT_LT(half.Draw()->GetTaps(), 0.75 * taps) << integrator;
    EXPECT_EQ(half.Mapper->GetStatistics()->GetOpaqueDepthCopies(), 1);
    half.Draw();
    EXPECT_EQ(half.Mapper->GetStatistics()->GetOpaqueDepthCopies(), 1) << "the same frame again";
    EXPECT_EQ(hidden.Draw()->GetTaps(), 0) << integrator;
    EXPECT_EQ(hidden.Mapper->GetStatistics()->GetRays(), 0) << integrator;
  }
}

//------------------------------------------------------------------------------
// Of 32^3 voxels one is filled: rays are those of the tiles that its bricks are seen in.
TEST(Skips, OnlyTilesThatMeetTheMediumHaveRays)
{
  SkipScene scene(vtkSingleScatteringVolumeMapper::ErrorControlled);
  vtkDataArray* density = scene.Mapper->GetInput()->GetPointData()->GetScalars();
  density->Fill(0);
  density->SetTuple1(4 + 32 * (4 + 32 * 4), 1);
  density->Modified();
  vtkMediumStatistics* done = scene.Draw();
  EXPECT_GT(done->GetRays(), 0);
  EXPECT_LT(done->GetRays(), 48 * 48 / 4);
  EXPECT_EQ(done->GetBricksVisited(), 1);
  density->Fill(0);
  density->Modified();
  EXPECT_EQ(scene.Draw()->GetPasses(), 0) << "nothing anywhere is not drawn";
  EXPECT_EQ(done->GetTaps() + done->GetRays() + done->GetBricksVisited(), 0);
}

//------------------------------------------------------------------------------
// A march that has lost its light ends.
TEST(Skips, DenseMediaEndTheirRaysEarly)
{
  for (int integrator : Integrators)
  {
    SkipScene scene(integrator, vtkMediumFixtures::Smooth);
    scene.Mapper->SetLightCachesToNever();
    scene.Medium->SetExtinctionScale(60);
    const vtkTypeInt64 whole = scene.Draw()->GetTaps();
    scene.Mapper->SetTransmittanceThreshold(1.0 / 256);
    // Steps that grow leave less to spare.
    const bool grows = integrator == vtkSingleScatteringVolumeMapper::ErrorControlled;
    EXPECT_LT(scene.Draw()->GetTaps(), (grows ? 0.97 : 0.8) * whole) << integrator;
  }
}
