// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Tiles, viewports, renderers and windows that show the same volume.
#include "ClosedForms.h"

#include "vtkWindowToImageFilter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

using namespace vtkMediumTest;

namespace
{
constexpr int Side = 16;
/// Float rounding of rays that are interpolated over viewports of different sizes.
constexpr double SameRays = 1e-5;

/// A ball of fog, not in the middle.
struct BallScene : Scene
{
  vtkSmartPointer<vtkLight> Light;
  std::vector<Picture> Frames; ///< of each Render of the mapper, in order

  explicit BallScene(int pixels = Side, int integrator = vtkSingleScatteringVolumeMapper::FixedStep)
    : Scene(MakeImage(glm::ivec3(17), glm::dvec3(1),
              [](const glm::dvec3& p) { return std::max(1 - 2 * glm::length(p), 0.0); }),
        pixels)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetPaperThreshold(0.2);
    this->Medium->SetExtinction(3);
    if (integrator != vtkSingleScatteringVolumeMapper::Paper)
    {
      this->Medium->SetExtinctionArrayName("density");
      this->Medium->SetExtinctionScale(4);
    }
    this->Light = this->AddBeam({ 1, -1, -0.3 });
    this->Look({ 0.3, 0.2, -1 }, 2, { 0.1, 0.05, 0 });
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(this);
    listener->SetCallback([](vtkObject*, unsigned long, void* scene, void*) {
      auto* self = static_cast<BallScene*>(scene);
      vtkNew<vtkImageData> image;
      self->Mapper->GetColorImage(image);
      self->Frames.emplace_back(image);
    });
    this->Watch = this->Mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, listener);
  }
  ~BallScene() { this->Mapper->RemoveObserver(this->Watch); }

private:
  unsigned long Watch = 0;
};

struct Other
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;

  explicit Other(BallScene& scene)
  {
    this->Renderer->SetActiveCamera(scene.Camera);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddVolume(scene.Volume);
    this->Window->SetMultiSamples(0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(Side, Side);
    this->Window->AddRenderer(this->Renderer);
  }
};

constexpr int Integrators[] = { vtkSingleScatteringVolumeMapper::Paper,
  vtkSingleScatteringVolumeMapper::FixedStep, vtkSingleScatteringVolumeMapper::ErrorControlled };
}

TEST(Windows, TilesEqualTheWhole)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    BallScene whole(2 * Side, integrator);
    const Picture reference = whole.Render();
    ASSERT_GT(reference.Mean(), 1e-3);
    BallScene scene(Side, integrator);
    scene.Render();
    const double angle = scene.Camera->GetViewAngle();
    scene.Camera->SetViewAngle(std::atan(std::tan(angle * Pi / 360) / 2) * 360 / Pi);
    scene.Window->SetTileScale(2, 2);
    Picture tiled = reference;
    for (int tile = 0; tile < 4; ++tile)
    {
      const glm::ivec2 at(tile % 2, tile / 2);
      scene.Window->SetTileViewport(0.5 * at.x, 0.5 * at.y, 0.5 * (at.x + 1), 0.5 * (at.y + 1));
      scene.Camera->SetWindowCenter(2 * at.x - 1, 2 * at.y - 1);
      const Picture part = scene.Render();
      ASSERT_EQ(part.Size, glm::ivec2(Side));
      for (int i = 0; i < Side * Side * 4; ++i)
      {
        const int x = Side * at.x + i / 4 % Side, y = Side * at.y + i / 4 / Side;
        tiled.Values[4 * (y * tiled.Size.x + x) + i % 4] = part.Values[i];
      }
    }
    // ErrorControlled may choose another step for each.
    const bool controlled = integrator == vtkSingleScatteringVolumeMapper::ErrorControlled;
    EXPECT_LT(Difference(reference, tiled), controlled ? 1.0 / 255 : SameRays);
  }
}

// What vtkWindowToImageFilter does with a scale is tiles as well.
TEST(Windows, MagnifiedScreenshotShowsTheMagnifiedWindow)
{
  BallScene large(2 * Side), small;
  auto shot = [](BallScene& scene, int scale) {
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(scene.Window);
    filter->SetScale(scale);
    filter->ReadFrontBufferOff();
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    const auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
    return std::vector<unsigned char>(bytes, bytes + 3 * image->GetNumberOfPoints());
  };
  for (BallScene* scene : { &large, &small })
  {
    scene->Light->SetIntensity(10);
  }
  const std::vector<unsigned char> reference = shot(large, 1), tiled = shot(small, 2);
  ASSERT_EQ(reference.size(), tiled.size());
  int brightest = 0;
  for (std::size_t i = 0; i < reference.size(); ++i)
  {
    brightest = std::max<int>(brightest, reference[i]);
    ASSERT_NEAR(reference[i], tiled[i], 1) << i; // the filter's camera is not exact
  }
  EXPECT_GT(brightest, 50);
}

TEST(Windows, ViewportsThatShareAMapperAreTheirOwnImages)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    BallScene alone(Side, integrator);
    const Picture reference = alone.Render();
    BallScene scene(Side, integrator);
    vtkNew<vtkRenderer> second;
    second->SetActiveCamera(scene.Camera);
    second->AutomaticLightCreationOff();
    second->AddLight(scene.Light);
    second->AddVolume(scene.Volume);
    scene.Window->AddRenderer(second);
    scene.Window->SetSize(3 * Side, Side); // the first viewport is twice as wide as the second
    scene.Renderer->SetViewport(0, 0, 2.0 / 3, 1);
    second->SetViewport(2.0 / 3, 0, 1, 1);
    for (int frame = 0; frame < 3; ++frame)
    {
      scene.Frames.clear();
      scene.Window->Render();
      ASSERT_EQ(scene.Frames.size(), 2u);
      EXPECT_EQ(scene.Frames[0].Size, glm::ivec2(2 * Side, Side));
      EXPECT_LT(Difference(reference, scene.Frames[1]),
        integrator == vtkSingleScatteringVolumeMapper::ErrorControlled ? 1.0 / 255 : SameRays);
    }
    EXPECT_EQ(scene.Mapper->GetStatistics()->GetBrickBuilds(),
      integrator == vtkSingleScatteringVolumeMapper::ErrorControlled ? 1 : 0);
  }
}

// Each view sets how far its rays are apart as it begins: a coarse one fills the window, a fine one its middle.
TEST(Windows, FoveatedWindowIsFineInItsMiddleAndBuildsNothingMore)
{
  constexpr int Pixels = 4 * Side;
  BallScene scene(Pixels, vtkSingleScatteringVolumeMapper::ErrorControlled);
  scene.Light->SetIntensity(20); // differences of rays are many levels
  const std::vector<unsigned char> fine = scene.RenderWindow();
  scene.Mapper->SetImageSampleDistance(4);
  const std::vector<unsigned char> coarse = scene.RenderWindow();

  vtkNew<vtkRenderer> middle;
  middle->AutomaticLightCreationOff();
  middle->AddLight(scene.Light);
  middle->AddVolume(scene.Volume);
  middle->SetViewport(0.25, 0.25, 0.75, 0.75);
  vtkNew<vtkCamera> closer; // half of the window, along each axis
  closer->DeepCopy(scene.Camera);
  closer->SetViewAngle(
    2 * std::atan(std::tan(scene.Camera->GetViewAngle() * Pi / 360) / 2) * 180 / Pi);
  middle->SetActiveCamera(closer);
  scene.Window->AddRenderer(middle);
  auto begin = [&scene](vtkRenderer* renderer, vtkCallbackCommand* command) {
    command->SetClientData(&scene);
    command->SetCallback([](vtkObject* caller, unsigned long, void* data, void*) {
      auto* self = static_cast<BallScene*>(data);
      self->Mapper->SetImageSampleDistance(caller == self->Renderer ? 4 : 1);
    });
    renderer->AddObserver(vtkCommand::StartEvent, command);
  };
  vtkNew<vtkCallbackCommand> outside, inside;
  begin(scene.Renderer, outside);
  begin(middle, inside);
  const std::vector<unsigned char> both = scene.RenderWindow();
  int sharper = 0;
  for (int i = 0; i < 3 * Pixels * Pixels; ++i)
  {
    const int x = i / 3 % Pixels, y = i / 3 / Pixels;
    const bool isMiddle = std::min(x, y) >= Pixels / 4 && std::max(x, y) < 3 * Pixels / 4;
    ASSERT_NEAR(both[i], isMiddle ? fine[i] : coarse[i], 1) << x << ", " << y;
    sharper += isMiddle && std::abs(fine[i] - coarse[i]) > 1;
  }
  EXPECT_GT(sharper, 100);
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  const std::array<vtkTypeInt64, 4> before{ done->GetTextureUploads(), done->GetBrickBuilds(),
    done->GetLightCacheBuilds(), done->GetProgramCompiles() };
  scene.Camera->Azimuth(3);
  closer->Azimuth(3);
  scene.RenderWindow();
  EXPECT_EQ(before,
    (std::array<vtkTypeInt64, 4>{ done->GetTextureUploads(), done->GetBrickBuilds(),
      done->GetLightCacheBuilds(), done->GetProgramCompiles() }));
}

// The lights belong to a renderer, not to the mapper.
TEST(Windows, RenderersThatShareAMapperLightItEachInItsWay)
{
  BallScene scene;
  const Picture lit = scene.Render();
  Other other(scene); // without lights
  other.Window->Render();
  EXPECT_EQ(scene.Frames.back().Mean(), 0);
  EXPECT_EQ(scene.Frames.back().Mean(3), lit.Mean(3));
  EXPECT_EQ(scene.Render().Values, lit.Values);
}

TEST(Windows, TwoWindowsShowTheSameVolumeInTurn)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    BallScene scene(Side, integrator);
    BallScene bystander; // keeps resources in the first window that must stay whole
    scene.Window->AddRenderer(bystander.Renderer);
    scene.Window->SetSize(2 * Side, Side);
    scene.Renderer->SetViewport(0, 0, 0.5, 1);
    bystander.Renderer->SetViewport(0.5, 0, 1, 1);
    Other other(scene);
    other.Renderer->AddLight(scene.Light);
    const Picture first = scene.Render();
    const Picture beside = bystander.Frames.back();
    for (int turn = 0; turn < 3; ++turn)
    {
      other.Window->Render();
      EXPECT_EQ(scene.Frames.back().Values, first.Values);
      EXPECT_EQ(scene.Render().Values, first.Values);
      EXPECT_EQ(bystander.Frames.back().Values, beside.Values);
    }
    EXPECT_TRUE(scene.Errors.empty());
    scene.Window->RemoveRenderer(bystander.Renderer);
  }
}

TEST(Windows, AWindowThatIsGoneLeavesTheOtherWhole)
{
  BallScene scene;
  const Picture first = scene.Render();
  for (int turn = 0; turn < 3; ++turn)
  {
    {
      Other other(scene);
      other.Renderer->AddLight(scene.Light);
      other.Window->Render();
      EXPECT_EQ(scene.Frames.back().Values, first.Values);
    }
    EXPECT_EQ(scene.Render().Values, first.Values);
  }
  EXPECT_TRUE(scene.Errors.empty());
}

//------------------------------------------------------------------------------
// Exact carries its march from draw to draw in an image more than FixedStep has.
TEST(Windows, GrowsFromAMarchThatIsCarriedToOneThatIsNot)
{
  const int larger = 3 * Side;
  BallScene fresh(larger), grown(Side, vtkSingleScatteringVolumeMapper::Exact);
  fresh.Render();
  grown.Render();
  grown.Window->SetSize(larger, larger);
  grown.Mapper->SetIntegrator(vtkSingleScatteringVolumeMapper::FixedStep);
  grown.Render();
  EXPECT_LT(Difference(fresh.Frames.back(), grown.Frames.back()), SameRays);
}
