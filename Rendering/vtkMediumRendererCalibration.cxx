// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// How vtkMediumRenderer integrates the probe pixels that vtkMediumStepControl asks for.
#include "vtkMediumRenderer.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>

#include <algorithm>

namespace
{
// Of the viewport's size along each axis, and the least and most pixels of it.
constexpr int ProbeReduction = 8;
constexpr int FewestProbes = 32;
constexpr int MostProbes = 96;
// The error of light caches is probed by pixels along each axis, in steps of voxels.
constexpr int CacheProbes = 32;
constexpr double CacheProbeStep = 1;
constexpr double LargestProbeStep = 1.0 / 64; // of the box's diagonal, where voxels are large
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumRenderer::IntegrateProbes(const glm::ivec2& pixels,
  const vtkMediumPlan::Settings& settings, const vtkMediumPlan::Capabilities& device,
  std::string& refusal)
{
  vtkMediumFrame::Viewport viewport;
  viewport.Size = pixels;
  const vtkMediumPlan plan(this->Scene, settings, device);
  std::string problem = this->Accelerator.Update(this->Window, this->Scene, plan);
  problem =
    problem.empty() ? this->Probe.Begin(this->Window, viewport, plan.NeedsState(), false) : problem;
  problem = problem.empty() ? this->Integrate(this->Probe, plan) : problem;
  refusal = refusal.empty() ? problem : refusal;
  return this->Probe.DownloadRadiance();
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::FindStep(const Request& request,
  const vtkMediumPlan::Capabilities& device, vtkMediumStepControl::CacheUses caches)
{
  const glm::ivec2 pixels = glm::clamp(FindViewport(request.Renderer).Size / ProbeReduction,
    glm::ivec2(FewestProbes), glm::ivec2(MostProbes));
  const vtkMediumScene::Box& box = this->Scene.Geometry;
  const double voxel = box.VoxelLength / box.Length;
  vtkMediumPlan::Settings settings = request.Settings;
  settings.Output = vtkSingleScatteringVolumeMapper::Radiance;

  std::string refusal;
  auto integrate = [&](const glm::ivec2& size, const vtkMediumStepControl::Light& light) {
    settings.LightMethod = light.Method;
    settings.LightTolerance = light.Tolerance;
    settings.PixelTolerance = light.PixelTolerance;
    return this->IntegrateProbes(size, settings, device, refusal);
  };
  vtkMediumStepControl::Probes probes;
  probes.Caches = caches;
  probes.InSteps = [&](const vtkMediumStepControl::Light& light, double step) {
    settings.StretchSteps = true;
    settings.ControlledStep = step;
    settings.ControlledLightStep = 0;
    return integrate(pixels, light);
  };
  probes.InLight = [&](const vtkMediumStepControl::Light& light, double lightStep) {
    settings.StretchSteps = false; // programs that march light group the steps otherwise
    settings.ControlledStep = CacheProbeStep * std::min(voxel, LargestProbeStep);
    settings.ControlledLightStep = lightStep;
    return integrate(glm::ivec2(CacheProbes), light);
  };
  probes.Bounds = [&] { return this->Probe.DownloadBounds(); };
  this->StepControl.Calibrate(this->Scene, request.MaximumError, voxel, probes);
  if (!refusal.empty())
  {
    this->StepControl.Forget();
  }
  return refusal;
}
