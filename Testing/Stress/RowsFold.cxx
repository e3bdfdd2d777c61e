// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Row 56: images beyond the device's largest 3D texture. They lie in blocks, and no picture shows where.
#include "GLFault.h"
#include "StressRefusal.h"

#include "vtkMediumStatistics.h"

#include <memory>

namespace vtkMediumStress
{
namespace
{
/// An image that GLFault::Limit3D folds.
struct Folding
{
  const char* Name;
  glm::ivec3 Points;
  bool OnCells, Linear, Masked, Sparse;
};

constexpr Folding Foldings[] = {
  { "along x", { 40, 7, 6 }, false, true, false, false },
  { "along y, masked", { 7, 40, 8 }, false, true, true, false },
  { "cells along z, masked", { 8, 6, 40 }, true, true, true, false },
  { "nearest along x", { 40, 6, 7 }, false, false, false, false },
  { "nearest cells along y, masked", { 5, 41, 5 }, true, false, true, false },
  { "two axes", { 21, 18, 5 }, false, true, false, false },
  { "bricks too", { 160, 4, 4 }, false, true, false, true },
};

/// Values without a pattern, so that a wrong neighbour is seen; sparse ones are 0 in most places.
vtkSmartPointer<vtkImageData> MakeField(const Folding& folding)
{
  std::uint32_t index = 0;
  return MakeImage(
    folding.Points, { 1, 0.8, 0.9 },
    [&](const glm::dvec3& at) {
      const bool empty = folding.Sparse && std::fmod(at.x + 0.5, 0.4) > 0.1;
      const double value = vtkMediumFixtures::Random(index++, 7);
      return empty ? 0 : value;
    },
    folding.OnCells);
}

vtkSmartPointer<vtkImageData> MakeMask(const Folding& folding)
{
  std::uint32_t index = 0;
  return MakeImage(
    folding.Points, glm::dvec3(1),
    [&](const glm::dvec3&) { return vtkMediumFixtures::Random(index++, 9) < 0.7 ? 1 : 0; },
    folding.OnCells, VTK_UNSIGNED_CHAR);
}

struct FoldStage : Stage
{
  FoldStage(Trial& trial, const Folding& folding)
    : Stage(trial, MakeField(folding))
  {
    if (!trial.Is(Mapper::Paper)) // which is for homogeneous media
    {
      this->SetField(4);
    }
    this->Medium->SetAnisotropy(0.3);
    this->Property->SetInterpolationType(
      folding.Linear ? VTK_LINEAR_INTERPOLATION : VTK_NEAREST_INTERPOLATION);
    this->Scene::Mapper->SetMaskInput(folding.Masked ? MakeMask(folding) : nullptr);
    this->Scene::Mapper->SetMaximumError(0.1); // what it is does not matter here
    // Light rays that are marched ask for empty bricks, whatever the step.
    this->Scene::Mapper->SetLightCaches(
      folding.Sparse ? Mapper::CachesNever : Mapper::CachesAlways);
    this->Done()->CountTapsOn();
    this->SetSteps(0.013, 0.017);
    this->AddBeam({ 1, -0.3, -0.2 }); // through all blocks along x
    this->AddPointLight({ -0.9, 0.8, 0.7 });
    this->Look({ 0.43, -0.31, -1 }, 2.3);
  }

  vtkMediumStatistics* Done() { return this->Scene::Mapper->GetStatistics(); }
  double GetTaps() { return static_cast<double>(this->Done()->GetTaps()); }
};

/// Steps fall on a border between nearest voxels, or of a mask, within rounding: one in some 1e5 does, and is
/// of either voxel. So one pixel in ten may differ there, but not by much.
void CheckSameButForTies(
  Trial& trial, const Picture& a, const Picture& b, double allowed, const std::string& what)
{
  std::vector<float> apart;
  for (std::size_t i = 0; i < std::min(a.Values.size(), b.Values.size()); ++i)
  {
    apart.push_back(std::abs(a.Values[i] - b.Values[i]));
  }
  const std::size_t most = apart.size() * 9 / 10;
  trial.Holds(!apart.empty() && apart.size() == a.Values.size(), what + ": there are pictures");
  std::nth_element(apart.begin(), apart.begin() + most, apart.end());
  const float peak = *std::max_element(a.Values.begin(), a.Values.end());
  trial.AtMost(apart[most] / peak, allowed, what + ", nine pixels in ten");
  trial.AtMost(Difference(a, b), 0.03, what + ", all pixels");
}

void FoldedImages(Trial& trial)
{
  // Paper finds a surface to 2^-10 of its step, and there are some ten on a ray.
  const double allowed = trial.Is(Mapper::Paper) ? 1e-4 : 1e-5;
  for (const Folding& folding : Foldings)
  {
    FoldStage whole(trial, folding);
    const Picture expected = whole.Render();
    FoldStage folded(trial, folding);
    const GLFault fault(GLFault::SmallTextures3D);
    const Picture found = folded.Render();
    const bool ties = (folding.Masked || !folding.Linear) && !trial.Is(Mapper::Exact);
    (ties ? CheckSameButForTies : CheckSame)(trial, expected, found, allowed, folding.Name);
    const std::string name = folding.Name;
    trial.Holds(folded.Done()->GetGPUBytes() > whole.Done()->GetGPUBytes(),
      name + ": layers are repeated, so that there is a fold to be seen");
    if (trial.Is(Mapper::ErrorControlled) && folding.Linear && !folding.Masked)
    {
      trial.Holds(
        folding.Sparse || folded.Done()->GetLightMethod() == vtkMediumStatistics::LightLookedUp,
        name + ": light caches are folded too");
      trial.AtMost(std::abs(folded.GetTaps() / whole.GetTaps() - 1), 1e-3,
        name + ": look-ups, so that empty bricks are folded too");
    }
  }
}

/// Of the device's own limit. Without light where steps are not to be chosen: along so many voxels light rays
/// would take minutes.
void HugeImages(Trial& trial)
{
  GLint largest = 0;
  Stage stage(trial, MakeBox());
  if (trial.Is(Mapper::Paper) || trial.Is(Mapper::FixedStep))
  {
    stage.AddBeam({ 0.2, -1, 0 });
  }
  stage.Scene::Mapper->SetMaximumError(0.01);
  stage.LookParallel({ 0.1, 0.1, -1 }, 3, 0.6);
  stage.SetSteps(0.1, 0.1);
  const Picture expected = stage.Render();
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  stage.Scene::Mapper->SetInputData(MakeImage(
    { largest + 1, 3, 2 }, glm::dvec3(1), [](const glm::dvec3&) { return 1.0; }, false,
    VTK_UNSIGNED_CHAR));
  if (!trial.Is(Mapper::Paper))
  {
    stage.SetField(1);
  }
  CheckSame(trial, expected, stage.Render(), Same, "one value more than the device's texture has");
}

void ImagesWithoutRoom(Trial& trial)
{
  std::unique_ptr<GLFault> fault;
  CheckRefusal(
    trial, "largest 3D texture has 16, in which all 40 x 17 x 16 have no room",
    [&](Stage& stage) {
      fault.reset(new GLFault(GLFault::SmallTextures3D));
      if (!trial.Is(Mapper::Paper))
      {
        stage.SetField(1);
      }
      stage.Mapper->SetInputData(MakeImage(
        { 40, 17, 16 }, glm::dvec3(1), [](const glm::dvec3&) { return 1.0; }, false,
        VTK_UNSIGNED_CHAR));
    },
    [&](Stage& stage) {
      stage.Window->MakeCurrent();
      fault.reset();
      UseBox(stage);
      stage.Medium->SetExtinctionArrayName(nullptr);
    });
}

void ImagesBeyondTheDevice(Trial& trial)
{
  FoldedImages(trial);
  HugeImages(trial);
  ImagesWithoutRoom(trial);
}
}

std::vector<Row> FoldRows()
{
  return {
    { 56, "ImagesBeyondTheDeviceAreTheSameInBlocks",
      "1e-5: rounding, Paper 1e-4; 0.03 where steps fall on a voxel's border; E without room",
      ImagesBeyondTheDevice, {} },
  };
}
}
