// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What has not changed is not done again, and what has is.
#include "ReferenceScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

using namespace vtkMediumTest;

namespace
{
// A cloud beside an opaque triangle that hides a part of it.
struct ReuseScene : Scene
{
  vtkNew<vtkActor> Actor;
  vtkNew<vtkPoints> Corners;
  vtkNew<vtkPolyData> Triangle;

  explicit ReuseScene(int integrator)
    : Scene(vtkMediumFixtures::MakeImage(
              vtkMediumFixtures::Cloud, glm::ivec3(16), glm::dvec3(1, 0.7, 1.3)),
        48)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetPaperThreshold(0.1);
    if (integrator != vtkSingleScatteringVolumeMapper::Paper) // which is for homogeneous media
    {
      this->Medium->SetExtinctionArrayName("");
    }
    this->Medium->SetExtinctionScale(6);
    this->AddBeam({ 1, -0.8, -0.2 });
    this->Look({ 0.4, -0.3, -1 }, 2.4);
    this->Corners->InsertNextPoint(-0.6, -0.4, 0.3);
    this->Corners->InsertNextPoint(0.5, -0.2, 0);
    this->Corners->InsertNextPoint(0.1, 0.6, -0.3);
    vtkNew<vtkCellArray> triangles;
    triangles->InsertNextCell({ 0, 1, 2 });
    this->Triangle->SetPoints(this->Corners);
    this->Triangle->SetPolys(triangles);
    vtkNew<vtkPolyDataMapper> surface;
    surface->SetInputData(this->Triangle);
    this->Actor->SetMapper(surface);
    this->Renderer->AddActor(this->Actor);
  }

  vtkTypeInt64 Reused() { return this->Mapper->GetStatistics()->GetFramesReused(); }
  vtkLight* GetLight()
  {
    return vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
  }
};

struct Change
{
  const char* Name;
  std::function<void(ReuseScene&)> Apply;
};

const Change Changes[] = {
  { "camera", [](ReuseScene& s) { s.Camera->Azimuth(3); } },
  { "projection", [](ReuseScene& s) { s.Camera->SetViewAngle(25); } },
  { "window", [](ReuseScene& s) { s.Window->SetSize(40, 48); } },
  { "light's colour", [](ReuseScene& s) { s.GetLight()->SetDiffuseColor(1, 0.5, 0.2); } },
  { "light's place", [](ReuseScene& s) { s.GetLight()->SetPosition(1, 2, 0.3); } },
  { "another light",
    [](ReuseScene& s) {
      s.AddPointLight({ 0.3, 1, 1 });
    } },
  { "light switched off", [](ReuseScene& s) { s.GetLight()->SwitchOff(); } },
  { "extinction", [](ReuseScene& s) { s.Medium->SetExtinctionScale(3); } },
  { "albedo", [](ReuseScene& s) { s.Medium->SetAlbedo(0.5); } },
  { "density", [](ReuseScene& s) { s.Medium->SetDensityScale(0.5); } },
  { "volume's place", [](ReuseScene& s) { s.Volume->SetPosition(0.1, 0, 0); } },
  { "data",
    [](ReuseScene& s) {
      vtkDataArray* values = s.Mapper->GetInput()->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        values->SetTuple1(i, 1 - values->GetTuple1(i));
      }
      values->Modified();
    } },
  { "opaque actor moved", [](ReuseScene& s) { s.Actor->SetPosition(0.2, 0.1, 0); } },
  { "opaque points moved",
    [](ReuseScene& s) {
      s.Corners->SetPoint(0, 0.6, 0.4, 0.3);
      s.Corners->Modified();
    } },
  { "opaque actor hidden", [](ReuseScene& s) { s.Actor->VisibilityOff(); } },
  { "output", [](ReuseScene& s) { s.Mapper->SetOutputToDistance(); } },
  { "pixels", [](ReuseScene& s) { s.Mapper->SetImageSampleDistance(2); } },
};

bool Same(const Picture& a, const Picture& b)
{
  return a.Size == b.Size && a.Values == b.Values;
}
}

//------------------------------------------------------------------------------
TEST(Reuse, TheSameFrameTwiceCompilesUploadsAndIntegratesNothing)
{
  for (int integrator = vtkSingleScatteringVolumeMapper::Paper;
       integrator <= vtkSingleScatteringVolumeMapper::Exact; ++integrator)
  {
    ReuseScene scene(integrator);
    scene.Mapper->GetStatistics()->CountTapsOn();
    const Picture first = scene.Render();
    vtkMediumStatistics* done = scene.Mapper->GetStatistics();
    EXPECT_GT(done->GetTaps(), 0);
    EXPECT_GT(done->GetPasses(), 0);
    const vtkTypeInt64 compiles = done->GetProgramCompiles(), uploads = done->GetTextureUploads();
    const Picture second = scene.Render();
    EXPECT_TRUE(Same(first, second)) << integrator;
    EXPECT_EQ(scene.Reused(), 1) << integrator;
    EXPECT_EQ(done->GetTaps(), 0);
    EXPECT_EQ(done->GetPasses(), 0);
    EXPECT_EQ(done->GetProgramCompiles(), compiles);
    EXPECT_EQ(done->GetTextureUploads(), uploads);
  }
}

//------------------------------------------------------------------------------
TEST(Reuse, TheWindowShowsTheSamePicture)
{
  ReuseScene scene(vtkSingleScatteringVolumeMapper::FixedStep);
  const std::vector<unsigned char> first = scene.RenderWindow();
  EXPECT_EQ(scene.RenderWindow(), first);
  EXPECT_EQ(scene.Reused(), 1);
}

//------------------------------------------------------------------------------
TEST(Reuse, EveryChangeIsSeen)
{
  for (const Change& change : Changes)
  {
    ReuseScene scene(vtkSingleScatteringVolumeMapper::FixedStep);
    const Picture before = scene.Render();
    change.Apply(scene);
    const Picture after = scene.Render();
    EXPECT_EQ(scene.Reused(), 0) << change.Name;
    EXPECT_FALSE(Same(before, after)) << change.Name << " changes this picture";
    ReuseScene fresh(vtkSingleScatteringVolumeMapper::FixedStep);
    change.Apply(fresh);
    EXPECT_TRUE(Same(after, fresh.Render())) << change.Name;
  }
}

//------------------------------------------------------------------------------
TEST(Reuse, NothingInViewDrawsNothing)
{
  for (int integrator = vtkSingleScatteringVolumeMapper::Paper;
       integrator <= vtkSingleScatteringVolumeMapper::Exact; ++integrator)
  {
    ReuseScene scene(integrator);
    scene.Look({ 0, 0, -1 }, 3, { 9, 0, 0 });
    EXPECT_FALSE(scene.Render().IsLight()) << integrator;
    EXPECT_EQ(scene.Mapper->GetStatistics()->GetPasses(), 0) << integrator;
    scene.Look({ 0, 0, -1 }, 3);
    EXPECT_TRUE(scene.Render().IsLight()) << integrator;
  }
}

//------------------------------------------------------------------------------
// Optical depths are lengths: no texture is looked up, and light rays cost the same at any step.
TEST(Reuse, HomogeneousMediaLookNothingUp)
{
  for (int integrator : { vtkSingleScatteringVolumeMapper::FixedStep,
         vtkSingleScatteringVolumeMapper::ErrorControlled })
  {
    Scene scene(MakeBox(), 32);
    scene.Medium->SetExtinction(2);
    scene.AddBeam({ 1, -0.8, -0.2 });
    scene.Mapper->SetIntegrator(integrator);
    scene.Mapper->GetStatistics()->CountTapsOn();
    scene.SetSteps(0.01, 0.5);
    const Picture coarse = scene.Render();
    ASSERT_TRUE(coarse.IsLight());
    EXPECT_EQ(scene.Mapper->GetStatistics()->GetTaps(), 0);
    EXPECT_GT(scene.Mapper->GetStatistics()->GetRays(), 0);
    EXPECT_EQ(scene.Mapper->GetStatistics()->GetLightCacheBuilds(), 0);
    scene.SetSteps(0.01, 1e-4);
    EXPECT_EQ(scene.Render().Values, coarse.Values) << integrator;
    EXPECT_EQ(scene.Mapper->GetStatistics()->GetPasses(),
      scene.Mapper->GetStatistics()->GetFramesReused() > 0 ? 0 : 1);
  }
}
