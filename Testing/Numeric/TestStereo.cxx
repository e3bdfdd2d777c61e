// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Two eyes: their pictures are those of two cameras, and they share all that is built.
#include "ClosedForms.h"
#include "vtkMediumTestHeadset.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
constexpr int Side = 24;
constexpr double SamePicture = 2e-4; // the same renderer, other roundings

constexpr int Integrators[] = { vtkSingleScatteringVolumeMapper::Paper,
  vtkSingleScatteringVolumeMapper::FixedStep, vtkSingleScatteringVolumeMapper::ErrorControlled };

struct FogScene : Scene
{
  std::vector<Picture> Frames; ///< of each Render of the mapper, in order

  explicit FogScene(int integrator)
    : Scene(MakeImage(glm::ivec3(17), glm::dvec3(1),
              [](const glm::dvec3& p) { return std::max(1 - 1.6 * glm::length(p), 0.0); }),
        Side)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetPaperThreshold(0.3);
    this->Medium->SetExtinction(3);
    this->Medium->SetAnisotropy(0.4);
    if (integrator != vtkSingleScatteringVolumeMapper::Paper)
    {
      this->Medium->SetExtinctionArrayName("density");
      this->Medium->SetExtinctionScale(4);
    }
    this->AddBeam({ 1, -1, -0.3 });
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(this);
    listener->SetCallback([](vtkObject*, unsigned long, void* scene, void*) {
      auto* self = static_cast<FogScene*>(scene);
      vtkNew<vtkImageData> image;
      self->Mapper->GetColorImage(image);
      self->Frames.emplace_back(image);
    });
    this->Watch = this->Mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, listener);
  }
  ~FogScene() { this->Mapper->RemoveObserver(this->Watch); }

  /// What a plain camera sees that stands and looks as an eye does.
  Picture RenderMono(const EyePose& eye)
  {
    vtkNew<vtkCamera> camera;
    vtkNew<vtkMatrix4x4> projection;
    eye.GetProjection(0.01, 100, projection);
    const glm::dvec3 focus = eye.Position - glm::cross(eye.Right, eye.Up);
    camera->SetPosition(eye.Position.x, eye.Position.y, eye.Position.z);
    camera->SetFocalPoint(focus.x, focus.y, focus.z);
    camera->SetViewUp(eye.Up.x, eye.Up.y, eye.Up.z);
    camera->SetExplicitProjectionTransformMatrix(projection);
    camera->UseExplicitProjectionTransformMatrixOn();
    this->Renderer->SetActiveCamera(camera);
    return this->Render();
  }

private:
  unsigned long Watch = 0;
};

/// Of the allowed error where a step is found for each, else of rounding.
double Tolerance(int integrator)
{
  return integrator == vtkSingleScatteringVolumeMapper::ErrorControlled ? 1.0 / 255 : SamePicture;
}

struct Counts
{
  vtkTypeInt64 Uploads, Compiles, Bricks, Caches, Calibrations;

  explicit Counts(vtkMediumStatistics* statistics)
    : Uploads(statistics->GetTextureUploads())
    , Compiles(statistics->GetProgramCompiles())
    , Bricks(statistics->GetBrickBuilds())
    , Caches(statistics->GetLightCacheBuilds())
    , Calibrations(statistics->GetCalibrations())
  {
  }
};
}

TEST(Stereo, EyesOfAHeadsetAreTwoMonoPictures)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    FogScene scene(integrator), mono(integrator);
    Headset headset;
    headset.PutOn(scene.Window, scene.Renderer);
    // Outside, at the edge, and inside the medium.
    for (const glm::dvec3& at : { glm::dvec3(0.1, 0.1, 1.3), { 0.1, 0.1, 0.5 }, { 0, 0.05, 0.1 } })
    {
      headset.Stand(at, 0.12, 0.2);
      scene.Frames.clear();
      scene.Window->Render();
      ASSERT_EQ(scene.Frames.size(), 2u);
      for (int eye : { 0, 1 })
      {
        const Picture truth = mono.RenderMono(headset.Camera->Eyes[eye]);
        ASSERT_GT(truth.Mean(), 1e-4);
        EXPECT_LT(Difference(truth, scene.Frames[eye]), Tolerance(integrator)) << "eye " << eye;
      }
      EXPECT_GT(Difference(scene.Frames[0], scene.Frames[1]), 0.05);
    }
  }
}

TEST(Stereo, EyesOfAHeadsetShareAllThatIsBuilt)
{
  for (int integrator : Integrators)
  {
    const bool controlled = integrator == vtkSingleScatteringVolumeMapper::ErrorControlled;
    for (const glm::dvec3& at : { glm::dvec3(0.1, 0.1, 1.3), { 0, 0.05, 0.1 } })
    {
      for (double tilt : { 0.0, 0.1 })
      {
        SCOPED_TRACE(testing::Message()
          << "integrator " << integrator << ", z = " << at.z << ", tilt " << tilt);
        FogScene scene(integrator);
        scene.Mapper->SetLightCachesToAlways();
        Headset headset;
        headset.PutOn(scene.Window, scene.Renderer);
        auto draw = [&](double sway) {
          headset.Stand(at + glm::dvec3(sway, 0, 0), 0.064, sway, tilt);
          scene.Window->Render();
          return Counts(scene.Mapper->GetStatistics());
        };
        const Counts first = draw(0);
        EXPECT_GT(first.Uploads, 0);
        EXPECT_EQ(first.Bricks, controlled ? 1 : 0);
        EXPECT_EQ(first.Caches, controlled ? 1 : 0);
        // One for both eyes, but each its own where they stand or look too differently.
        const bool alike = at.z > 1 && tilt == 0;
        EXPECT_LE(first.Calibrations, controlled ? (alike ? 1 : 2) : 0);
        for (int frame = 1; frame < 8; ++frame)
        {
          const Counts later = draw(0.004 * std::sin(frame));
          EXPECT_EQ(later.Uploads, first.Uploads);
          EXPECT_EQ(later.Compiles, first.Compiles);
          EXPECT_EQ(later.Bricks, first.Bricks);
          EXPECT_EQ(later.Caches, first.Caches);
          EXPECT_EQ(later.Calibrations, first.Calibrations);
        }
      }
    }
  }
}

// The jitter of a pixel is the same in both eyes and in every frame.
TEST(Stereo, JitterDoesNotShimmer)
{
  FogScene scene(vtkSingleScatteringVolumeMapper::Paper);
  scene.Mapper->SetJitter(0.9);
  scene.Mapper->SetSampleDistance(0.15);
  Headset headset;
  headset.PutOn(scene.Window, scene.Renderer);
  for (int frame = 0; frame < 3; ++frame)
  {
    // The second eye comes to stand where the first one stood, so that nothing is merely shown again.
    headset.Stand({ 0.1, 0.1, 1.3 }, 0.1);
    const EyePose pose = headset.Camera->Eyes[0];
    scene.Window->Render();
    std::swap(headset.Camera->Eyes[0], headset.Camera->Eyes[1]);
    scene.Window->Render();
    ASSERT_EQ(headset.Camera->Eyes[1].Position, pose.Position);
  }
  ASSERT_EQ(scene.Frames.size(), 12u);
  for (int i = 0; i < 12; i += 4)
  {
    EXPECT_EQ(scene.Frames[i].Values, scene.Frames[0].Values);     // the left eye
    EXPECT_EQ(scene.Frames[i + 3].Values, scene.Frames[0].Values); // the right eye in its place
    EXPECT_EQ(scene.Frames[i + 1].Values, scene.Frames[1].Values);
    EXPECT_EQ(scene.Frames[i + 2].Values, scene.Frames[1].Values);
  }
  scene.Mapper->SetJitter(0);
  scene.Window->Render();
  EXPECT_GT(Difference(scene.Frames[3], scene.Frames.back()), 1e-3); // there was jitter
}

// VTK's camera shears the view of an eye by half the eye angle about the focal point.
TEST(Stereo, EveryStereoTypeDrawsTheEyesOfTwoMonoCameras)
{
  struct Type
  {
    int Stereo;
    std::vector<double> Eyes; ///< -1 left, 1 right, in the order in which they are drawn
  };
  const Type types[] = { { VTK_STEREO_LEFT, { -1 } }, { VTK_STEREO_RIGHT, { 1 } },
    { VTK_STEREO_ANAGLYPH, { -1, 1 } }, { VTK_STEREO_RED_BLUE, { -1, 1 } },
    { VTK_STEREO_SPLITVIEWPORT_HORIZONTAL, { -1, 1 } }, { VTK_STEREO_INTERLACED, { -1, 1 } },
    { VTK_STEREO_CHECKERBOARD, { -1, 1 } }, { VTK_STEREO_DRESDEN, { -1, 1 } } };
  const double angle = 4;
  for (int integrator : Integrators)
  {
    FogScene mono(integrator);
    mono.Look({ 0.3, 0.2, -1 }, 2);
    std::vector<Picture> eyes;
    for (double eye : { -1.0, 1.0 })
    {
      mono.Camera->SetViewShear(eye * std::tan(0.5 * angle * Pi / 180), 0, 1);
      eyes.push_back(mono.Render());
    }
    ASSERT_GT(Difference(eyes[0], eyes[1]), 0.03);
    for (const Type& type : types)
    {
      SCOPED_TRACE(testing::Message() << "integrator " << integrator << ", type " << type.Stereo);
      FogScene scene(integrator);
      scene.Look({ 0.3, 0.2, -1 }, 2);
      scene.Camera->SetEyeAngle(angle);
      scene.Window->SetStereoType(type.Stereo);
      scene.Window->StereoRenderOn();
      for (int frame = 0; frame < 2; ++frame)
      {
        scene.Frames.clear();
        scene.Window->Render();
        ASSERT_EQ(scene.Frames.size(), type.Eyes.size());
        for (std::size_t i = 0; i < type.Eyes.size(); ++i)
        {
          const Picture& truth = eyes[type.Eyes[i] < 0 ? 0 : 1];
          ASSERT_EQ(truth.Size, scene.Frames[i].Size);
          EXPECT_LT(Difference(truth, scene.Frames[i]), Tolerance(integrator)) << "eye " << i;
        }
      }
      const bool controlled = integrator == vtkSingleScatteringVolumeMapper::ErrorControlled;
      EXPECT_EQ(scene.Mapper->GetStatistics()->GetBrickBuilds(), controlled ? 1 : 0);
      EXPECT_EQ(scene.Mapper->GetStatistics()->GetCalibrations(), controlled ? 1 : 0);
    }
  }
}
