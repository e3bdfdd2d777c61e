// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Frames that keep to the time of an interactive window, the frames at rest after them, and pixels that
// share a ray.
#include "ReferenceScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkLightCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

using namespace vtkMediumTest;

namespace
{
constexpr double Step8Bit = 1.0 / 255;
constexpr double Interacting = 15, AtRest = 0.0001; // VTK's own desired frames a second

struct InteractiveScene : ReferenceScene
{
  InteractiveScene()
    : ReferenceScene(vtkMediumFixtures::Smooth)
  {
    this->Medium->SetExtinctionScale(6);
    this->Mapper->SetIntegratorToErrorControlled();
    this->FindTruth();
  }
};
}

//------------------------------------------------------------------------------
TEST(Interaction, HurriedFramesAreLitAndFindNoStep)
{
  InteractiveScene scene;
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  const vtkTypeInt64 calibrations = done->GetCalibrations();
  vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0))
    ->SetPosition(-1, 0.9, 0.2);
  scene.Window->SetDesiredUpdateRate(Interacting);
  const Picture hurried = scene.Render();
  EXPECT_EQ(done->GetCalibrations(), calibrations);
  EXPECT_EQ(done->GetLightMethod(), vtkMediumStatistics::LightLookedUp) << "scattering stays on";
  EXPECT_EQ(scene.Mapper->GetEstimatedError(), -1);
  double peak = 0;
  for (std::size_t i = 0; i < hurried.Values.size(); ++i)
  {
    peak = i % 4 < 3 ? std::max(peak, double(hurried.Values[i])) : peak;
  }
  EXPECT_NEAR(peak, scene.Peak, 0.2 * scene.Peak);
}

//------------------------------------------------------------------------------
TEST(Interaction, FramesAtRestAreAsAccurateAsEver)
{
  InteractiveScene scene;
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  scene.Window->SetDesiredUpdateRate(Interacting);
  for (int frame = 0; frame < 3; ++frame)
  {
    scene.Render();
  }
  const vtkTypeInt64 builds = done->GetLightCacheBuilds();
  scene.Window->SetDesiredUpdateRate(AtRest);
  const ReferenceScene::Errors errors = scene.Measure();
  EXPECT_LE(errors.Largest, Step8Bit);
  EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest);
  EXPECT_EQ(done->GetPixelEdge(), 1);
  scene.Render();
  EXPECT_LE(done->GetLightCacheBuilds(), builds + 3) << "quick caches are built anew, once";
}

//------------------------------------------------------------------------------
TEST(Interaction, CanBeSwitchedOff)
{
  InteractiveScene scene;
  scene.Mapper->AutoAdjustSampleDistancesOff();
  scene.Window->SetDesiredUpdateRate(1000);
  EXPECT_LE(scene.Measure().Largest, Step8Bit);
  EXPECT_EQ(scene.Mapper->GetStatistics()->GetPixelEdge(), 1);
}

//------------------------------------------------------------------------------
// The middle of three by three pixels is one of them: the same ray, and the same opaque geometry.
TEST(Interaction, RaysAFewPixelsApartAreThoseOfTheirMiddles)
{
  Scene scene(
    vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(16), glm::dvec3(1, 0.7, 1.3)),
    48);
  scene.Medium->SetExtinctionArrayName("");
  scene.Medium->SetExtinctionScale(6);
  scene.AddBeam({ 1, -0.8, -0.2 });
  scene.Look({ 0.4, -0.3, -1 }, 2.4);
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(-0.6, -0.4, 0.3);
  corners->InsertNextPoint(0.5, -0.2, 0);
  corners->InsertNextPoint(0.1, 0.6, -0.3);
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> triangle;
  triangle->SetPoints(corners);
  triangle->SetPolys(triangles);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputData(triangle);
  vtkNew<vtkActor> actor;
  actor->SetMapper(surface);
  scene.Renderer->AddActor(actor);
  for (int integrator : { vtkSingleScatteringVolumeMapper::FixedStep,
         vtkSingleScatteringVolumeMapper::ErrorControlled })
  {
    scene.Mapper->SetIntegrator(integrator);
    scene.Mapper->SetImageSampleDistance(1);
    const Picture every = scene.Render();
    scene.Mapper->SetImageSampleDistance(3);
    const Picture third = scene.Render();
    ASSERT_EQ(third.Size, every.Size / 3);
    EXPECT_EQ(scene.Mapper->GetStatistics()->GetPixelEdge(), 3);
    for (int y = 0; y < third.Size.y; ++y)
    {
      for (int x = 0; x < third.Size.x; ++x)
      {
        for (int c = 0; c < 4; ++c)
        {
          ASSERT_NEAR(third.At(x, y, c), every.At(3 * x + 1, 3 * y + 1, c), 1e-4);
        }
      }
    }
  }
}
