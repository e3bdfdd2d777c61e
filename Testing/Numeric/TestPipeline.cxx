// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What a VTK pipeline does to a mapper: inputs that change, events, aborts, level of detail, render
// passes, and resources that come and go.
#include "ClosedForms.h"
#include "OpaquePlane.h"

#include "vtkExtractVOI.h"
#include "vtkGaussianBlurPass.h"
#include "vtkLODProp3D.h"
#include "vtkProperty.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>

using namespace vtkMediumTest;

namespace
{
constexpr int Side = 16;

constexpr int Integrators[] = { vtkSingleScatteringVolumeMapper::Paper,
  vtkSingleScatteringVolumeMapper::FixedStep, vtkSingleScatteringVolumeMapper::ErrorControlled,
  vtkSingleScatteringVolumeMapper::Exact };

vtkSmartPointer<vtkImageData> MakeBall(double radius, const glm::ivec3& points = glm::ivec3(9))
{
  return MakeImage(points, glm::dvec3(1),
    [=](const glm::dvec3& p) { return std::max(1 - glm::length(p) / radius, 0.0); });
}

struct BallScene : Scene
{
  explicit BallScene(int integrator = vtkSingleScatteringVolumeMapper::FixedStep)
    : Scene(MakeBall(0.5), Side)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetPaperThreshold(0.3);
    this->Medium->SetExtinction(3);
    if (integrator != vtkSingleScatteringVolumeMapper::Paper)
    {
      this->Medium->SetExtinctionArrayName("");
      this->Medium->SetExtinctionScale(4);
    }
    this->AddBeam({ 1, -1, -0.3 });
    this->Look({ 0.3, 0.2, -1 }, 2);
  }

  /// Listens to the mapper until the scene is gone.
  void Watch(unsigned long event, std::function<void(void*)> action)
  {
    auto command = vtkSmartPointer<vtkCallbackCommand>::New();
    this->Actions.push_back(std::make_unique<std::function<void(void*)>>(std::move(action)));
    command->SetClientData(this->Actions.back().get());
    command->SetCallback([](vtkObject*, unsigned long, void* told, void* data) {
      (*static_cast<std::function<void(void*)>*>(told))(data);
    });
    this->Mapper->AddObserver(event, command);
  }

private:
  std::vector<std::unique_ptr<std::function<void(void*)>>> Actions;
};

/// Resident memory of this process, MiB.
double ResidentMemory()
{
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE) / (1 << 20);
}
}

TEST(Pipeline, TimeSeriesCostsAnUploadAndNoCompilation)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    BallScene scene(integrator);
    scene.Render();
    vtkMediumStatistics* statistics = scene.Mapper->GetStatistics();
    vtkTypeInt64 compiles = statistics->GetProgramCompiles();
    // ErrorControlled's steps may become so short that a software renderer's limit of iterations splits
    // a march into several draws; the program that carries it from one to the next is compiled once.
    int carried = integrator == vtkSingleScatteringVolumeMapper::ErrorControlled ? 1 : 0;
    for (int step = 1; step < 5; ++step)
    {
      const vtkTypeInt64 uploads = statistics->GetTextureUploads();
      // Also other dimensions, and another range of values.
      const glm::ivec3 points = step == 3 ? glm::ivec3(7, 8, 11) : glm::ivec3(9);
      vtkSmartPointer<vtkImageData> image = MakeBall(0.5 - 0.05 * step, points);
      scene.Mapper->SetInputData(image);
      const Picture picture = scene.Render();
      EXPECT_GT(statistics->GetTextureUploads(), uploads);
      const vtkTypeInt64 more = statistics->GetProgramCompiles() - compiles;
      EXPECT_LE(more, carried);
      compiles += more;
      carried -= static_cast<int>(more);
      BallScene fresh(integrator);
      fresh.Mapper->SetInputData(image);
      EXPECT_LT(Difference(fresh.Render(), picture), 1e-6) << "step " << step;
    }
    EXPECT_TRUE(scene.Errors.empty());
  }
}

TEST(Pipeline, InputsThatComeGoAndChangeTheirKind)
{
  BallScene scene;
  const Picture valid = scene.Render();
  vtkSmartPointer<vtkImageData> ball = MakeBall(0.5);
  vtkNew<vtkImageData> empty;
  for (int turn = 0; turn < 3; ++turn)
  {
    scene.Mapper->SetInputData(empty);
    scene.Window->Render();
    scene.Mapper->SetInputData(MakeBall(0.5, glm::ivec3(1, 9, 9)));
    scene.Window->Render();
    scene.Mapper->SetInputData(ball);
    EXPECT_EQ(scene.Render().Values, valid.Values);
  }
  double bounds[6];
  scene.Mapper->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(bounds[i], i % 2 ? 0.5 : -0.5, 1e-12);
  }
}

// Another consumer may have asked the source for a part; a producer may hold a part of its whole extent.
TEST(Pipeline, PartsOfTheExtentAreNoObstacle)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-4, 4, -4, 4, -4, 4);
  source->Update();
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(source->GetOutput());
  BallScene scene, plain;
  for (BallScene* each : { &scene, &plain })
  {
    each->Medium->SetExtinctionArrayName("");
    each->Medium->SetExtinctionScale(1e-3);
    each->SetSteps(0.25, 0.25);
    each->Look({ 0.3, 0.2, -1 }, 20);
  }
  plain.Mapper->SetInputData(whole);
  const Picture expected = plain.Render();
  EXPECT_GT(expected.At(Side / 2, Side / 2, 3), 0.3);
  scene.Mapper->SetInputConnection(source->GetOutputPort());
  for (int turn = 0; turn < 2; ++turn)
  {
    const int part[6] = { -4, 0, -2, 4, -1, 1 + turn };
    source->UpdateExtent(part);
    EXPECT_EQ(scene.Render().Values, expected.Values);
  }
  // A part of a larger whole is drawn in its place.
  vtkNew<vtkExtractVOI> extract;
  extract->SetInputData(whole);
  extract->SetVOI(-4, 1, -2, 4, -3, 3);
  extract->Update();
  plain.Mapper->SetInputData(extract->GetOutput());
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(extract->GetOutput());
  producer->SetWholeExtent(-4, 4, -4, 4, -4, 4);
  scene.Mapper->SetInputConnection(producer->GetOutputPort());
  EXPECT_EQ(scene.Render().Values, plain.Render().Values);
  EXPECT_TRUE(scene.Errors.empty());
}

TEST(Pipeline, EventsTellWhenAFrameBeginsAdvancesAndEnds)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    BallScene scene(integrator);
    scene.Window->SetSize(4, 4);
    scene.SetSteps(5e-4, 0.02); // several draws
    std::vector<double> told;
    scene.Watch(vtkCommand::VolumeMapperRenderStartEvent, [&](void*) { told.push_back(-1); });
    scene.Watch(vtkCommand::VolumeMapperRenderProgressEvent,
      [&](void* data) { told.push_back(*static_cast<double*>(data)); });
    scene.Watch(vtkCommand::VolumeMapperRenderEndEvent, [&](void*) { told.push_back(2); });
    scene.Window->Render();
    ASSERT_GE(told.size(), 3u);
    EXPECT_EQ(told.front(), -1);
    EXPECT_EQ(told.back(), 2);
    EXPECT_EQ(told[told.size() - 2], 1);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    const vtkTypeInt64 draws = scene.Mapper->GetStatistics()->GetPasses();
    EXPECT_EQ(told.size() - 2, std::size_t(draws));
    EXPECT_GT(scene.Mapper->GetTimeToDraw(), 0);
    EXPECT_LT(scene.Mapper->GetTimeToDraw(), 100);
  }
}

TEST(Pipeline, AnAbortedFrameIsNotShownAndTheNextOneIsWhole)
{
  BallScene scene;
  scene.Window->SetSize(4, 4);
  scene.SetSteps(1e-4, 0.02); // many draws
  const Picture whole = scene.Render();
  const vtkTypeInt64 draws = scene.Mapper->GetStatistics()->GetPasses();
  const vtkTypeInt64 frames = scene.Mapper->GetStatistics()->GetFrames();
  ASSERT_GT(draws, 3);
  scene.Medium->SetAlbedo(0.5); // or the last frame would be shown again
  int told = 0;
  bool stop = true;
  scene.Watch(vtkCommand::VolumeMapperRenderProgressEvent, [&](void*) {
    ++told;
    scene.Window->SetAbortRender(stop && told == 2);
  });
  scene.Window->Render();
  EXPECT_EQ(told, 2); // it went no further
  EXPECT_EQ(scene.Mapper->GetStatistics()->GetFrames(), frames);
  vtkNew<vtkImageData> image;
  scene.Mapper->GetColorImage(image);
  ASSERT_EQ(scene.Errors.size(), 1u);
  EXPECT_NE(scene.Errors[0].find("render a frame first"), std::string::npos) << scene.Errors[0];
  stop = false;
  scene.Window->Render();
  scene.Medium->SetAlbedo(1);
  EXPECT_EQ(scene.Render().Values, whole.Values);
}

TEST(Pipeline, LevelOfDetailDrawsWithEitherMapper)
{
  BallScene scene;
  const Picture fine = scene.Render();
  scene.Renderer->RemoveVolume(scene.Volume);
  vtkNew<vtkSingleScatteringVolumeMapper> coarse;
  coarse->ShallowCopy(scene.Mapper);
  coarse->SetSampleDistance(0.5);
  vtkNew<vtkLODProp3D> levels;
  const int first = levels->AddLOD(scene.Mapper, scene.Property, 0.0);
  const int second = levels->AddLOD(coarse, scene.Property, 0.0);
  levels->AutomaticLODSelectionOff();
  scene.Renderer->AddViewProp(levels);
  for (int turn = 0; turn < 2; ++turn)
  {
    levels->SetSelectedLODID(second);
    scene.Window->Render();
    vtkNew<vtkImageData> image;
    coarse->GetColorImage(image);
    EXPECT_GT(Difference(fine, Picture(image)), 1e-3);
    EXPECT_LT(Difference(fine, Picture(image)), 0.5);
    levels->SetSelectedLODID(first);
    EXPECT_EQ(scene.Render().Values, fine.Values);
  }
}

// A mapper under VTK's render passes draws what it draws without them.
TEST(Pipeline, RenderPassesShowTheSameMedium)
{
  BallScene scene;
  scene.Renderer->SetBackground(0.2, 0.4, 0.6);
  const std::vector<unsigned char> plain = scene.RenderWindow();
  const Picture picture = scene.Render();
  {
    vtkNew<vtkRenderStepsPass> steps;
    scene.Renderer->SetPass(steps);
    EXPECT_EQ(scene.RenderWindow(), plain);
    vtkNew<vtkSSAAPass> smooth; // draws twice as large, then smaller
    smooth->SetDelegatePass(steps);
    scene.Renderer->SetPass(smooth);
    const std::vector<unsigned char> smoothed = scene.RenderWindow();
    ASSERT_EQ(smoothed.size(), plain.size());
    double change = 0, mean = 0;
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
      change += std::abs(int(plain[i]) - int(smoothed[i])) / double(plain.size());
      mean += plain[i] / double(plain.size());
    }
    EXPECT_LT(change, 0.05 * mean); // of 16 pixels across, many are edges
    smooth->ReleaseGraphicsResources(scene.Window);
    vtkNew<vtkGaussianBlurPass> blur; // keeps the mean and lowers the peak
    blur->SetDelegatePass(steps);
    scene.Renderer->SetPass(blur);
    const std::vector<unsigned char> blurred = scene.RenderWindow();
    double blurredMean = 0;
    for (unsigned char value : blurred)
    {
      blurredMean += value / double(plain.size());
    }
    EXPECT_NEAR(blurredMean, mean, 0.06 * mean); // the border counts more; without the ball: 0.36
    EXPECT_NE(blurred, plain);
    blur->ReleaseGraphicsResources(scene.Window);
  }
  scene.Renderer->SetPass(nullptr);
  EXPECT_EQ(scene.RenderWindow(), plain);
  EXPECT_EQ(scene.Render().Values, picture.Values);
  EXPECT_TRUE(scene.Errors.empty());
}

TEST(Pipeline, WindowsWithSRGBAndSamplesHoldTheSameImage)
{
  BallScene scene;
  const Picture reference = scene.Render();
  for (int samples : { 0, 4 })
  {
    for (bool srgb : { false, true })
    {
      BallScene other;
      other.Window->SetMultiSamples(samples);
      other.Window->SetUseSRGBColorSpace(srgb);
      EXPECT_EQ(other.Render().Values, reference.Values) << samples << ", sRGB " << srgb;
    }
  }
}

TEST(Pipeline, AHundredReleasesLeaveTheMemoryFlat)
{
  for (int integrator : { vtkSingleScatteringVolumeMapper::FixedStep,
         vtkSingleScatteringVolumeMapper::ErrorControlled })
  {
    BallScene scene(integrator);
    const Picture first = scene.Render();
    double before = 0;
    for (int turn = 0; turn < 100; ++turn)
    {
      before = turn == 40 ? ResidentMemory() : before; // the driver's own caches are full by then
      scene.Mapper->ReleaseGraphicsResources(scene.Window);
      ASSERT_EQ(first.Values, scene.Render().Values) << "turn " << turn;
    }
    EXPECT_LT(ResidentMemory() - before, 4) << "MiB over sixty turns";
  }
}

TEST(Pipeline, AHundredContextsLeaveTheMemoryFlat)
{
  BallScene scene;
  const Picture first = scene.Render();
  double before = 0;
  for (int turn = 0; turn < 100; ++turn)
  {
    before = turn == 40 ? ResidentMemory() : before;
    scene.Window->Finalize();
    ASSERT_EQ(first.Values, scene.Render().Values) << "turn " << turn;
  }
  EXPECT_LT(ResidentMemory() - before, 12) << "MiB over sixty contexts";
}
