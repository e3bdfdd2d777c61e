// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What casts shadows into the medium, what they change and what not, and when their maps are drawn.
#include "OpaquePlane.h"
#include "ReferenceScene.h"

#include "vtkAssembly.h"
#include "vtkLightCollection.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;
using Mapper = vtkSingleScatteringVolumeMapper;

namespace
{
constexpr int Integrators[] = { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled,
  Mapper::Exact };

// Above the box, all of it or the half with x > 0, out of the view.
const Quad Roof = { { -5, 2, -5 }, { 10, 0, 0 }, { 0, 0, 10 } };
const Quad HalfRoof = { { 0, 2, -5 }, { 10, 0, 0 }, { 0, 0, 10 } };
const Quad Floor = { { -5, -2, -5 }, { 10, 0, 0 }, { 0, 0, 10 } };

/// Of the radiance, as a fraction of its mean.
double MeanDifference(const Picture& a, const Picture& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.Values.size(); i += 4)
  {
    sum += std::abs(double(a.Values[i]) - b.Values[i]);
  }
  return sum / (double(a.Size.x) * a.Size.y * a.Mean());
}

struct Lit : Scene
{
  vtkSmartPointer<vtkLight> Sun;
  vtkSmartPointer<vtkActor> Blocker;

  explicit Lit(const Quad& blocker, int integrator = Mapper::FixedStep)
    : Scene(MakeBox(), 16)
    , Sun(this->AddBeam({ 0.1, -1, 0.05 }))
    , Blocker(blocker.AddTo(this->Renderer))
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->OpaqueShadowsOn();
    this->SetSteps(0.05, 0.05);
  }

  /// By what a frame that can have shadows, of which there are none, may differ from one that cannot:
  /// ErrorControlled and Exact do not march the latter, which has a closed form; `marched` by others.
  double AllowedWithoutShadows(double marched)
  {
    const int integrator = this->Mapper->GetIntegrator();
    return integrator == Mapper::ErrorControlled ? this->Mapper->GetMaximumError()
      : integrator == Mapper::Exact              ? 1e-5
                                                 : marched;
  }

  vtkTypeInt64 Builds() { return this->Mapper->GetStatistics()->GetShadowMapBuilds(); }
  /// That the next frame draws.
  vtkTypeInt64 BuildsOf(const std::function<void()>& change)
  {
    const vtkTypeInt64 before = this->Builds();
    change();
    this->Render();
    return this->Builds() - before;
  }
};
}

//------------------------------------------------------------------------------
// A blocked light adds nothing, and the others are as if it were not there.
TEST(OpaqueShadowWork, BlockedLightLeavesTheOthersAndEmission)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(integrator);
    Lit scene(Roof, integrator);
    if (integrator != Mapper::Paper) // which knows no emission
    {
      scene.Medium->SetEmission(0.2, 0.1, 0.3);
    }
    scene.AddBeam({ 1, 0.2, -0.3 })->SetDiffuseColor(0.5, 0.7, 0.2);
    const Picture blocked = scene.Render();
    ASSERT_TRUE(blocked.IsLight());
    scene.Mapper->OpaqueShadowsOff();
    EXPECT_GT(Difference(blocked, scene.Render()), 0.05);
    scene.Sun->SwitchOff();
    EXPECT_LT(Difference(blocked, scene.Render()), scene.AllowedWithoutShadows(1e-5));
  }
}

//------------------------------------------------------------------------------
TEST(OpaqueShadowWork, NothingIsLeftOfABlockedLightAlone)
{
  for (int integrator : Integrators)
  {
    Lit scene(Roof, integrator);
    const Picture picture = scene.Render();
    for (int y = 0; y < picture.Size.y; ++y)
    {
      for (int x = 0; x < picture.Size.x; ++x)
      {
        ASSERT_EQ(picture.At(x, y), 0) << integrator;
      }
    }
    EXPECT_GT(picture.Mean(3), 0.1); // the medium is there
  }
}

//------------------------------------------------------------------------------
TEST(OpaqueShadowWork, GeometryBeyondTheMediumCastsNone)
{
  for (int integrator : Integrators)
  {
    Lit scene(Floor, integrator);
    const Picture lit = scene.Render();
    EXPECT_EQ(scene.Builds(), 1);
    scene.Mapper->OpaqueShadowsOff();
    EXPECT_LT(Difference(scene.Render(), lit), scene.AllowedWithoutShadows(1e-7)) << integrator;
  }
}

//------------------------------------------------------------------------------
TEST(OpaqueShadowWork, HiddenAndTranslucentActorsAndVolumesCastNone)
{
  Lit scene(HalfRoof);
  scene.Mapper->OpaqueShadowsOff();
  const Picture open = scene.Render();
  scene.Mapper->OpaqueShadowsOn();
  EXPECT_GT(Difference(open, scene.Render()), 0.05);
  scene.Blocker->VisibilityOff();
  EXPECT_EQ(scene.Render().Values, open.Values);
  scene.Blocker->VisibilityOn();
  scene.Blocker->GetProperty()->SetOpacity(0.5);
  EXPECT_EQ(scene.Render().Values, open.Values);
  scene.Blocker->GetProperty()->SetOpacity(1);
  EXPECT_GT(Difference(open, scene.Render()), 0.05);
  scene.Renderer->RemoveActor(scene.Blocker);
  const vtkTypeInt64 builds = scene.Builds();
  vtkNew<vtkVolume> other;
  vtkNew<Mapper> mapper;
  mapper->SetInputData(MakeBox({ 3, 3, 0.1 }));
  other->SetMapper(mapper);
  other->SetPosition(0, 3, 0);
  scene.Renderer->AddVolume(other);
  EXPECT_EQ(scene.Render().Values, open.Values);
  EXPECT_EQ(scene.Builds(), builds);
}

//------------------------------------------------------------------------------
TEST(OpaqueShadowWork, AssembliesCastTheShadowsOfTheirParts)
{
  Lit scene(HalfRoof);
  const Picture shadowed = scene.Render();
  scene.Renderer->RemoveActor(scene.Blocker);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(scene.Blocker);
  scene.Renderer->AddActor(assembly);
  EXPECT_EQ(scene.Render().Values, shadowed.Values);
}

//------------------------------------------------------------------------------
TEST(OpaqueShadowWork, MapsAreDrawnWhenLightsPropsOrTheVolumeMove)
{
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled })
  {
    SCOPED_TRACE(integrator);
    Lit scene(HalfRoof, integrator);
    scene.Mapper->SetOpaqueShadowResolution(128);
    auto lamp = scene.AddPointLight({ 0.1, 0, 0.2 });
    EXPECT_EQ(scene.BuildsOf([] {}), 1 + 6);
    EXPECT_EQ(scene.BuildsOf([] {}), 0);
    EXPECT_EQ(scene.BuildsOf([&] { scene.Look({ 0.4, -0.1, -1 }, 2.5); }), 0);
    EXPECT_EQ(scene.BuildsOf([&] { scene.LookParallel({ 0.4, -0.1, -1 }, 2.5, 1); }), 0);
    EXPECT_EQ(scene.BuildsOf([&] { scene.Sun->SetDiffuseColor(1, 0.3, 0.1); }), 0);
    EXPECT_EQ(scene.BuildsOf([&] { scene.Medium->SetExtinction(0.7); }), 0);
    EXPECT_EQ(scene.BuildsOf([&] { scene.Sun->SetPosition(0.2, 1, 0); }), 1);
    EXPECT_EQ(scene.BuildsOf([&] { lamp->SetPosition(0, 3, 0); }), 2); // the texture is another
    EXPECT_EQ(scene.BuildsOf([&] { lamp->SetPosition(0.1, 3, 0); }), 1);
    EXPECT_EQ(scene.BuildsOf([&] { scene.Blocker->SetPosition(0.1, 0, 0); }), 2);
    EXPECT_EQ(scene.BuildsOf([&] { scene.Volume->SetPosition(0.1, 0, 0); }), 2);
    EXPECT_EQ(scene.BuildsOf([&] { scene.Mapper->SetOpaqueShadowResolution(500); }), 2);
    EXPECT_EQ(scene.BuildsOf([&] { scene.Mapper->OpaqueShadowsOff(); }), 0);
    // Switched off, they left the device.
    EXPECT_EQ(scene.BuildsOf([&] { scene.Mapper->OpaqueShadowsOn(); }), 2);
  }
}

//------------------------------------------------------------------------------
TEST(OpaqueShadowWork, WithoutLightOrGeometryNoMapIsDrawn)
{
  Lit scene(HalfRoof);
  scene.Renderer->RemoveActor(scene.Blocker);
  scene.Render();
  scene.Renderer->AddActor(scene.Blocker);
  scene.Sun->SwitchOff();
  scene.Render();
  scene.Sun->SwitchOn();
  scene.Mapper->SetOutputToTransmittance();
  scene.Render();
  EXPECT_EQ(scene.Builds(), 0);
  const vtkTypeInt64 bytes = scene.Mapper->GetStatistics()->GetGPUBytes();
  scene.Mapper->SetOutputToRadiance();
  scene.Render();
  EXPECT_EQ(scene.Builds(), 1);
  EXPECT_GE(scene.Mapper->GetStatistics()->GetGPUBytes(), bytes + 4 * 1024 * 1024);
}

//------------------------------------------------------------------------------
// The blocker is out of the view, and none of the frame before is shown again.
TEST(OpaqueShadowWork, MovedShadowIsSeen)
{
  for (int integrator : Integrators)
  {
    Lit scene(HalfRoof, integrator), fresh(HalfRoof, integrator);
    const Picture before = scene.Render();
    scene.Blocker->SetPosition(-0.3, 0, 0);
    fresh.Blocker->SetPosition(-0.3, 0, 0);
    const Picture after = scene.Render();
    EXPECT_GT(Difference(before, after), 0.05) << integrator;
    EXPECT_LT(Difference(after, fresh.Render()), 1e-6) << integrator;
  }
}

//------------------------------------------------------------------------------
// What casts shadows is drawn as if it cast none.
TEST(OpaqueShadowWork, WindowShowsTheSameGeometry)
{
  const Quad sign = { { -2, 0.7, -0.2 }, { 4, 0, 0 }, { 0, 0.3, 0.4 } };
  Lit scene(sign);
  scene.Blocker->GetProperty()->LightingOff();
  scene.Look({ 0, -0.5, -1 }, 3);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  scene.Mapper->OpaqueShadowsOff();
  const std::vector<unsigned char> without = scene.RenderWindow();
  scene.Mapper->OpaqueShadowsOn();
  const std::vector<unsigned char> with = scene.RenderWindow();
  const Picture medium = scene.Render();
  EXPECT_EQ(scene.Renderer->GetActiveCamera(), camera);
  int shown = 0;
  for (int i = 0; i < scene.Pixels * scene.Pixels; ++i)
  {
    if (medium.Values[4 * i + 3] == 0)
    {
      ASSERT_EQ(with[3 * i], without[3 * i]);
      shown += with[3 * i] > 0;
    }
  }
  EXPECT_GT(shown, 3);
}

//------------------------------------------------------------------------------
TEST(OpaqueShadowWork, CoarserMapHasAWiderEdge)
{
  Lit scene(HalfRoof);
  scene.SetSteps(0.01, 0.01);
  const Picture fine = scene.Render();
  scene.Mapper->SetOpaqueShadowResolution(256);
  const double coarse = MeanDifference(fine, scene.Render());
  scene.Mapper->SetOpaqueShadowResolution(16);
  const double coarsest = MeanDifference(fine, scene.Render());
  EXPECT_LT(coarse, 0.01);
  EXPECT_GT(coarsest, 4 * coarse);
}

//------------------------------------------------------------------------------
TEST(OpaqueShadowWork, MapsThatDoNotFitAreRefused)
{
  Lit scene(HalfRoof);
  for (int i = 0; i < 8; ++i)
  {
    scene.AddPointLight({ 0.01 * i, 0, 0 });
  }
  scene.Mapper->SetOpaqueShadowResolution(8192);
  scene.Window->Render();
  ASSERT_EQ(scene.Errors.size(), 1);
  EXPECT_NE(scene.Errors[0].find("49 views of 8192 x 8192"), std::string::npos) << scene.Errors[0];
  scene.Mapper->SetOpaqueShadowResolution(64);
  EXPECT_TRUE(scene.Render().IsLight());
  EXPECT_EQ(scene.Errors.size(), 1);
}

//------------------------------------------------------------------------------
// Half of a cloud is in a shadow: as if that half scattered nothing, which the reference knows. The shadow's
// edge is off by up to a texel and a half, 2e-3 long, where rays pass through some 0.3 of the cloud.
TEST(OpaqueShadowWork, ShadowInACloudIsThatOfADarkHalf)
{
  const glm::dvec3 size(1, 0.7, 1.3);
  const int points = 17;
  auto image = vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(points), size);
  vtkNew<vtkFloatArray> albedo;
  albedo->SetName("albedo");
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    const vtkIdType layer = cell / ((points - 1) * (points - 1));
    albedo->InsertNextValue(layer < points / 2 ? 0 : 1); // dark below the middle
  }
  image->GetCellData()->AddArray(albedo);
  Scene scene(image, 24);
  scene.Medium->SetExtinctionArrayName("");
  scene.Medium->SetExtinctionScale(5);
  scene.AddBeam({ -1, 0, 0 });
  scene.Look({ -0.3, -0.2, -1 }, 2.6);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.SetSteps(0.004, 0.01);

  vtkNew<vtkParticipatingMedium> dark;
  dark->SetExtinctionArrayName("");
  dark->SetExtinctionScale(5);
  dark->SetAlbedoArrayName("albedo");
  vtkNew<vtkSingleScatteringReference> reference;
  reference->SetVolume(scene.Volume);
  reference->SetMedium(dark);
  reference->SetRenderer(scene.Renderer);
  reference->SetPixelStride(4);
  reference->SetTolerance(1e-6);
  scene.Window->Render(); // so that the renderer has its size
  vtkNew<vtkImageData> truth;
  ASSERT_TRUE(reference->GetColorImage(truth));
  const double* values = static_cast<const double*>(truth->GetScalarPointer());

  Quad{ { 1, -2, -4 }, { 0, 4, 0 }, { 0, 0, 4 } }.AddTo(scene.Renderer);
  scene.Mapper->OpaqueShadowsOn();
  struct Way
  {
    int Integrator, Caches, Method;
    double Tolerance;
  };
  for (const Way& way :
    { Way{ Mapper::FixedStep, 0, vtkMediumStatistics::LightMarched, 1e-2 },
      Way{
        Mapper::ErrorControlled, Mapper::CachesAlways, vtkMediumStatistics::LightLookedUp, 4e-2 },
      Way{ Mapper::ErrorControlled, Mapper::CachesNever, vtkMediumStatistics::LightMarched, 1e-2 },
      Way{ Mapper::Exact, 0, vtkMediumStatistics::LightMarched, 1e-2 } })
  {
    SCOPED_TRACE(testing::Message() << way.Integrator << ", caches " << way.Caches);
    scene.Mapper->SetIntegrator(way.Integrator);
    scene.Mapper->SetLightCaches(way.Caches);
    const Picture picture = scene.Render();
    EXPECT_EQ(scene.Mapper->GetStatistics()->GetLightMethod(), way.Method);
    double worst = 0, peak = 0;
    for (int y = 0; y < 6; ++y)
    {
      for (int x = 0; x < 6; ++x)
      {
        const double at = values[4 * (6 * y + x)];
        worst = std::max(worst, std::abs(picture.At(4 * x, 4 * y) - at));
        peak = std::max(peak, at);
      }
    }
    EXPECT_LT(worst, way.Tolerance * peak) << worst / peak;
  }
}
