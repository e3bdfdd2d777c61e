// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What one frame leaves for the next: images, the window, counters, early ends.
#include "ClosedForms.h"

#include "vtkLightCollection.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
/// A box with a varying field and a beam.
struct FieldScene : Scene
{
  explicit FieldScene(int integrator = vtkSingleScatteringVolumeMapper::FixedStep)
    : Scene(MakeImage(glm::ivec3(9), glm::dvec3(1),
              [](const glm::dvec3& p) { return std::max(1 - 1.6 * glm::length(p), 0.0); }),
        16)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetPaperThreshold(0.3);
    if (integrator == vtkSingleScatteringVolumeMapper::FixedStep)
    {
      this->Medium->SetExtinctionArrayName("density");
      this->Medium->SetExtinctionScale(0.5);
    }
    this->Medium->SetExtinction(2);
    this->AddBeam({ 1, -1, -0.3 });
    this->Look({ 0.3, 0.2, -1 }, 2);
  }
};

constexpr int Integrators[] = { vtkSingleScatteringVolumeMapper::Paper,
  vtkSingleScatteringVolumeMapper::FixedStep };
}

TEST(Frames, SameSceneTwiceIsIdentical)
{
  for (int integrator : Integrators)
  {
    FieldScene scene(integrator);
    const Picture first = scene.Render();
    ASSERT_GT(first.Mean(), 0);
    scene.Look({ 1, 0, 0 }, 2);
    scene.Render();
    scene.Look({ 0.3, 0.2, -1 }, 2);
    EXPECT_EQ(first.Values, scene.Render().Values);
    FieldScene fresh(integrator);
    EXPECT_EQ(first.Values, fresh.Render().Values);
  }
}

TEST(Frames, RenderToImageLeavesTheWindowUntouched)
{
  for (int integrator : Integrators)
  {
    FieldScene scene(integrator);
    scene.Renderer->SetBackground(0.2, 0.4, 0.6);
    scene.Volume->VisibilityOff();
    const std::vector<unsigned char> background = scene.RenderWindow();
    scene.Volume->VisibilityOn();
    const Picture shown = scene.Render();
    EXPECT_NE(background, scene.RenderWindow());
    scene.Mapper->RenderToImageOn();
    EXPECT_EQ(background, scene.RenderWindow());
    EXPECT_EQ(shown.Values, scene.Render().Values);
    EXPECT_EQ(scene.Depths().Values.size(), 16u * 16u);
    scene.Mapper->RenderToImageOff();
    EXPECT_NE(background, scene.RenderWindow());
  }
}

TEST(Frames, WindowShowsThePremultipliedImageOverTheBackground)
{
  FieldScene scene;
  scene.Renderer->SetBackground(0.5, 0.5, 0.5);
  const std::vector<unsigned char> bytes = scene.RenderWindow();
  const Picture picture = scene.Render();
  for (int y = 0; y < 16; ++y)
  {
    for (int x = 0; x < 16; ++x)
    {
      const double shown = picture.At(x, y) + (1 - picture.At(x, y, 3)) * 127.5 / 255;
      ASSERT_NEAR(bytes[3 * (16 * y + x)] / 255.0, shown, 1.5 / 255) << x << ", " << y;
    }
  }
}

TEST(Frames, ImageBeforeTheFirstFrameIsAnError)
{
  FieldScene scene;
  vtkNew<vtkImageData> image;
  scene.Mapper->GetColorImage(image);
  ASSERT_EQ(scene.Errors.size(), 1u);
  EXPECT_NE(scene.Errors[0].find("render a frame first"), std::string::npos);
}

TEST(Frames, ViewportOfAWindowIsItsOwnImage)
{
  FieldScene whole;
  const Picture reference = whole.Render();
  FieldScene part;
  part.Window->SetSize(32, 32);
  part.Renderer->SetViewport(0.5, 0, 1, 0.5);
  const Picture picture = part.Render();
  EXPECT_EQ(picture.Size, reference.Size);
  EXPECT_LT(Difference(reference, picture), 2e-4);
}

TEST(Frames, ImageFollowsTheWindowsSize)
{
  FieldScene scene;
  scene.Render();
  for (int size : { 1, 40, 7 })
  {
    scene.Window->SetSize(size, size);
    scene.Pixels = size;
    const Picture picture = scene.Render();
    EXPECT_EQ(picture.Size, glm::ivec2(size));
    EXPECT_TRUE(picture.IsLight());
  }
}

TEST(Frames, NumbersAndPosesCostNoUploadAndNoCompilation)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    FieldScene scene(integrator);
    scene.Medium->SetAnisotropy(0.2);
    vtkMediumStatistics* statistics = scene.Mapper->GetStatistics();
    scene.Render();
    const vtkTypeInt64 uploads = statistics->GetTextureUploads();
    const vtkTypeInt64 compiles = statistics->GetProgramCompiles();
    EXPECT_GT(uploads, 0);
    EXPECT_GT(compiles, 0);
    vtkLight* light = vtkLight::SafeDownCast(scene.Renderer->GetLights()->GetItemAsObject(0));
    const std::pair<const char*, std::function<void()>> changes[] = {
      { "nothing", [] {} },
      { "camera",
        [&] {
          scene.Look({ 1, 0.2, 0 }, 2);
        } },
      { "camera inside",
        [&] {
          scene.Look({ 1, 0.2, 0 }, 0.1);
        } },
      { "light's direction", [&] { light->SetPosition(0.3, 2, 1); } },
      { "light's colour", [&] { light->SetDiffuseColor(1, 0.5, 0.1); } },
      { "light's intensity", [&] { light->SetIntensity(3); } },
      { "step", [&] { scene.SetSteps(0.07, 0.09); } },
      { "anisotropy", [&] { scene.Medium->SetAnisotropy(0.3); } },
      { "extinction", [&] { scene.Medium->SetExtinctionScale(0.7); } },
      { "density", [&] { scene.Medium->SetDensityScale(1.1); } },
      { "transmittance threshold", [&] { scene.Mapper->SetTransmittanceThreshold(0.01); } },
      { "jitter", [&] { scene.Mapper->SetJitter(0.1); } },
      { "threshold", [&] { scene.Mapper->SetPaperThreshold(0.4); } },
    };
    vtkTypeInt64 frames = statistics->GetFrames();
    for (const auto& change : changes)
    {
      change.second();
      scene.Render();
      EXPECT_EQ(statistics->GetTextureUploads(), uploads) << change.first;
      EXPECT_EQ(statistics->GetProgramCompiles(), compiles) << change.first;
      EXPECT_EQ(statistics->GetFrames(), ++frames) << change.first;
    }
  }
}

TEST(Frames, ChangedDataAreUploadedAgain)
{
  FieldScene scene;
  const Picture before = scene.Render();
  const vtkTypeInt64 uploads = scene.Mapper->GetStatistics()->GetTextureUploads();
  vtkImageData* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput());
  vtkDataArray* density = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < density->GetNumberOfTuples(); ++i)
  {
    density->SetTuple1(i, 1 + 0.001 * i);
  }
  density->Modified();
  EXPECT_GT(Difference(before, scene.Render()), 0.05);
  EXPECT_EQ(scene.Mapper->GetStatistics()->GetTextureUploads(), uploads + 1);
}

TEST(Frames, EarlyEndErrsByAtMostItsThreshold)
{
  // What lies beyond a transmittance T is at most T times the furnace's p E.
  for (int integrator : Integrators)
  {
    Scene scene(MakeBox(), 16);
    scene.Mapper->SetIntegrator(integrator);
    scene.Mapper->SetJitter(0);
    scene.Medium->SetExtinction(12);
    scene.SetSteps(0.02, 0.02);
    scene.AddBeam({ 0.3, -1, -0.2 });
    scene.Look({ 0.3, 0.2, -1 }, 2);
    scene.Mapper->SetTransmittanceThreshold(0);
    const Picture full = scene.Render();
    double before = 0, largest = 0;
    for (double threshold : { 1e-6, 1e-3, 0.03, 0.2 })
    {
      scene.Mapper->SetTransmittanceThreshold(threshold);
      const Picture cut = scene.Render();
      largest = 0;
      for (std::size_t i = 0; i < cut.Values.size(); ++i)
      {
        const double lost = double(full.Values[i]) - cut.Values[i];
        const double most = i % 4 == 3 ? threshold : threshold * Isotropic;
        ASSERT_GE(lost, -1e-7) << "threshold " << threshold;
        ASSERT_LE(lost, most + 1e-7) << "threshold " << threshold;
        largest = std::max(largest, lost);
      }
      EXPECT_GE(largest, before);
      before = largest;
    }
    EXPECT_GT(largest, 1e-3); // rays did end early
  }
}

TEST(Frames, ReleasedResourcesComeBack)
{
  FieldScene scene;
  const Picture first = scene.Render();
  for (int i = 0; i < 5; ++i)
  {
    scene.Mapper->ReleaseGraphicsResources(scene.Window);
    ASSERT_EQ(first.Values, scene.Render().Values);
  }
}

TEST(Frames, MapperMovesToAnotherWindow)
{
  FieldScene scene;
  const Picture first = scene.Render();
  scene.Window->RemoveRenderer(scene.Renderer);
  vtkNew<vtkRenderWindow> other;
  other->SetMultiSamples(0);
  other->SetOffScreenRendering(1);
  other->SetSize(16, 16);
  other->AddRenderer(scene.Renderer);
  other->Render();
  vtkNew<vtkImageData> image;
  scene.Mapper->GetColorImage(image);
  EXPECT_EQ(first.Values, Picture(image).Values);
  other->RemoveRenderer(scene.Renderer);
}
