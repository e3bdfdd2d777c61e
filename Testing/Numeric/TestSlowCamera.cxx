// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// No temporal pop: frames of a camera that moves slowly differ by no more than exact frames do, plus the error
// that each of the two may have. The way is long enough that a step is found anew on it.
#include "ReferenceScene.h"

using namespace vtkMediumTest;

namespace
{
constexpr int Frames = 7, Side = 48;
constexpr double DegreesAFrame = 2;
constexpr double MaximumError = 1.0 / 255;

std::vector<Picture> Move(ReferenceScene& scene)
{
  scene.Window->SetSize(Side, Side);
  scene.Look({ 0.4, -0.3, -1 }, 2.4);
  std::vector<Picture> frames;
  for (int frame = 0; frame < Frames; ++frame)
  {
    frames.push_back(scene.Render());
    scene.Camera->Azimuth(DegreesAFrame);
  }
  EXPECT_EQ(scene.Mapper->GetStatistics()->GetFramesReused(), 0);
  return frames;
}

double PeakOf(const std::vector<Picture>& frames)
{
  double peak = 0;
  for (const Picture& frame : frames)
  {
    for (std::size_t i = 0; i < frame.Values.size(); ++i)
    {
      peak = i % 4 < 3 ? std::max(peak, double(frame.Values[i])) : peak;
    }
  }
  return peak;
}

/// The largest of how much more the frames changed than the exact ones, of what they may.
double FindPop(const std::vector<Picture>& frames, const std::vector<Picture>& exact)
{
  const double peak = PeakOf(exact);
  double pop = 0;
  for (int frame = 1; frame < Frames; ++frame)
  {
    for (std::size_t i = 0; i < exact[frame].Values.size(); ++i)
    {
      const auto change = [&](const std::vector<Picture>& of) {
        return std::abs(double(of[frame].Values[i]) - of[frame - 1].Values[i]);
      };
      const double unit = i % 4 == 3 ? 1 : peak;
      pop = std::max(pop, (change(frames) - change(exact)) / (2 * MaximumError * unit));
    }
  }
  return pop;
}

struct SlowCamera : testing::TestWithParam<vtkMediumFixtures::Fields>
{
};
}

TEST_P(SlowCamera, ChangesFramesAsExactOnesChange)
{
  ReferenceScene scene(GetParam());
  scene.Renderer->RemoveAllLights();
  scene.AddBeam({ 1, -0.8, -0.2 });
  scene.Medium->SetExtinctionScale(6);
  scene.Mapper->SetMaximumError(MaximumError);
  scene.Mapper->SetIntegratorToExact();
  const std::vector<Picture> exact = Move(scene);
  scene.Mapper->SetIntegratorToErrorControlled();
  const std::vector<Picture> frames = Move(scene);
  EXPECT_GE(scene.Mapper->GetStatistics()->GetCalibrations(), 2) << "a step was found anew";
  EXPECT_LE(FindPop(frames, exact), 1);
  // One frame that is off by the light of a brick would be seen.
  std::vector<Picture> popped = frames;
  for (std::size_t i = 0; i < popped[4].Values.size(); ++i)
  {
    popped[4].Values[i] *= 1 + (i % (4 * Side) < 32 && i / (4 * Side * 8) == 4 ? 0.0f : 0.05f);
  }
  EXPECT_GT(FindPop(popped, exact), 1);
}

INSTANTIATE_TEST_SUITE_P(Over, SlowCamera,
  testing::Values(vtkMediumFixtures::Cloud, vtkMediumFixtures::Binary),
  [](const auto& parameters) { return std::string(vtkMediumFixtures::Name(parameters.param)); });
