// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumPlan.h"

#include "vtkMediumStructure.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
using Mapper = vtkSingleScatteringVolumeMapper;

//------------------------------------------------------------------------------
bool InUnitInterval(double value) // half open; false for NaN
{
  return value >= 0 && value < 1;
}

//------------------------------------------------------------------------------
std::string Unfit(const char* what, double value, const char* expected)
{
  std::ostringstream text;
  text << what << " is " << value << "; " << expected;
  return text.str();
}
}

//------------------------------------------------------------------------------
vtkMediumPlan::vtkMediumPlan(
  const vtkMediumScene& scene, const Settings& settings, const Capabilities& device)
{
  const bool paper = settings.Integrator == Mapper::Paper;
  this->Fields = paper ? PaperFields(scene) : scene.Content.Fields;
  this->Validate(settings);
  this->PlanFolds(device);
  this->ValidateCut(scene.Cut);
  this->PlanUserCode(settings);
  if (!this->Refusal.empty())
  {
    return;
  }
  this->ConstantExtinction = vtkMediumStructure::HasConstantExtinction(scene.Content);
  this->ChooseSteps(scene, settings);
  this->Jitter = settings.Jitter;
  this->DepthTransmittance = settings.DepthTransmittance;
  const bool gathers = settings.Output == Mapper::Radiance ||
    settings.Output == Mapper::SampleCount || settings.Output == Mapper::ErrorEstimate ||
    (settings.Output == Mapper::Depth && settings.DepthDefinition == Mapper::MeanScatteringDepth);
  // Distances and optical depths go through the whole volume, however thick it is.
  this->TransmittanceThreshold = gathers ? settings.TransmittanceThreshold : 0;
  const bool scatters = scene.Content.Altered || !scene.Content.Scattering.IsZero();
  this->Lit = gathers && !scene.Lights.empty() && scatters;
  this->OpaqueShadows = this->Lit && !scene.Casters.empty();
  this->OpaqueShadowResolution = settings.OpaqueShadowResolution;
  if (paper)
  {
    this->PlanPaper(scene, settings);
    if (!this->Refusal.empty())
    {
      return;
    }
  }
  if (this->HasClosedForm(scene, settings))
  {
    this->PlanClosedForm(scene, device);
  }
  else if (settings.Integrator == Mapper::Exact)
  {
    this->PlanExact(scene, device);
  }
  else
  {
    if (settings.Integrator == Mapper::ErrorControlled)
    {
      this->PlanErrorControlled(scene, settings);
    }
    this->SplitIntoPasses(scene, settings, device);
  }
  this->ChooseProgram(scene, settings, device);
  if (this->CacheRoughness && !this->OnlyRough && std::isfinite(this->PixelTolerance))
  {
    Settings rough = settings;
    rough.OnlyRough = true;
    this->Rough = std::make_shared<const vtkMediumPlan>(scene, rough, device);
  }
}

//------------------------------------------------------------------------------
void vtkMediumPlan::Validate(const Settings& settings)
{
  const double infinity = std::numeric_limits<double>::infinity();
  if (!(settings.SampleDistance >= 0 && settings.SampleDistance < infinity))
  {
    this->Refusal = Unfit("The sample distance", settings.SampleDistance,
      "set a length > 0 in world units, or 0 for one voxel (SetSampleDistance).");
  }
  else if (!(settings.LightSampleDistance >= 0 && settings.LightSampleDistance < infinity))
  {
    this->Refusal = Unfit("The light sample distance", settings.LightSampleDistance,
      "set a length > 0 in world units, or 0 for the eye rays' (SetLightSampleDistance).");
  }
  else if (!InUnitInterval(settings.Jitter))
  {
    this->Refusal =
      Unfit("The jitter", settings.Jitter, "set a fraction of a step in [0, 1) (SetJitter).");
  }
  else if (!InUnitInterval(settings.TransmittanceThreshold))
  {
    this->Refusal = Unfit("The transmittance threshold", settings.TransmittanceThreshold,
      "set a fraction in [0, 1), 0 to never stop early (SetTransmittanceThreshold).");
  }
  else if (!(settings.MaximumError > 0 && settings.MaximumError <= 1))
  {
    this->Refusal = Unfit("The maximum error", settings.MaximumError,
      "set a fraction of the peak radiance in (0, 1] (SetMaximumError).");
  }
  else if (!(settings.DepthTransmittance > 0 && settings.DepthTransmittance < 1))
  {
    this->Refusal = Unfit("The depth transmittance", settings.DepthTransmittance,
      "set a fraction in (0, 1) (SetDepthTransmittance).");
  }
  else if (settings.Output == Mapper::ErrorEstimate && settings.Integrator == Mapper::Exact)
  {
    this->Refusal =
      "The Exact integrator has no step to estimate an error from; choose another output "
      "(SetOutputToRadiance), or the FixedStep or ErrorControlled integrator.";
  }
}

//------------------------------------------------------------------------------
void vtkMediumPlan::ChooseSteps(const vtkMediumScene& scene, const Settings& settings)
{
  const double voxel = scene.Geometry.VoxelLength;
  const double eye = settings.SampleDistance > 0 ? settings.SampleDistance : voxel;
  const double light = settings.LightSampleDistance > 0 ? settings.LightSampleDistance : eye;
  const double length = scene.Geometry.Length;
  this->EyeStep = std::min(std::max(eye / length, ShortestStep), LongestStep);
  this->LightStep = std::min(std::max(light / length, ShortestStep), LongestStep);
}

//------------------------------------------------------------------------------
// Of the loops of one light ray, at most.
int vtkMediumPlan::CountLightIterations(bool paper) const
{
  if (this->CachedLights > 0 && !this->OnlyRough)
  {
    return 1; // a look-up, without a loop
  }
  if (this->ConstantExtinction && !paper)
  {
    return 5; // one segment, and what a loop costs beyond its iterations
  }
  const int steps = paper ? 1 : LightTapsPerIteration; // an iteration
  const int iterations = static_cast<int>(std::ceil(1 / (this->LightStep * steps)));
  // A loop from look-up to look-up inside of another.
  return 4 + iterations + (this->OnlyRough ? 4 * (iterations / this->LightLookUpEvery + 1) : 0);
}

//------------------------------------------------------------------------------
void vtkMediumPlan::SplitIntoPasses(
  const vtkMediumScene& scene, const Settings& settings, const Capabilities& device)
{
  const bool paper = settings.Integrator == Mapper::Paper;
  // The longest ray is the volume's diagonal, one local unit. The paper's march starts anew at each
  // surface, which at worst doubles its steps. Binary searches are written out and loop nowhere. Mesa
  // counts one or two iterations more for a loop than it makes, hence the fours.
  // Each part that cropping leaves of a ray ends with a step of its own.
  const int parts = scene.Cut.CutsRegions() ? 2 * MostKeptParts : 0;
  const int eyeSteps = static_cast<int>(std::ceil((paper ? 2 : 1) / this->EyeStep)) + 2 + parts;
  const int lightIterations = this->CountLightIterations(paper) + parts;
  const int eyeIterations = 4;

  const int lights = this->Lit ? static_cast<int>(scene.Lights.size()) : 0;
  const int reserve = 64;
  const int budget = device.LoopIterations - reserve;
  const int group =
    std::max(1, std::min(lights, (budget - eyeIterations) / std::max(lightIterations, 1)));
  for (int first = 0; first < std::max(lights, 1); first += group)
  {
    const int last = std::min(first + group, lights);
    const int steps = std::max(1, budget / (eyeIterations + (last - first) * lightIterations));
    for (int step = 0; step < eyeSteps; step += steps)
    {
      this->Passes.push_back({ first, last, step, std::min(step + steps, eyeSteps) });
    }
  }
}

//------------------------------------------------------------------------------
vtkMediumPlan vtkMediumPlan::Coarser() const
{
  vtkMediumPlan plan = *this; // its passes reach beyond the fewer steps
  plan.EyeStep *= 2;
  plan.LightStep *= 2;
  if (this->Rough)
  {
    plan.Rough = std::make_shared<const vtkMediumPlan>(this->Rough->Coarser());
  }
  return plan;
}

//------------------------------------------------------------------------------
glm::ivec4 vtkMediumPlan::FindScissor(
  const vtkMediumScene::View& eye, const vtkMediumScene::Box& box, const glm::ivec2& viewportSize)
{
  glm::dvec2 lower(1), upper(-1);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 at(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const glm::dvec4 clip = eye.LocalToClip * glm::dvec4(box.BoxToLocal(at), 1);
    if (!(clip.w > 0)) // beside or behind the eye: the projection says nothing
    {
      return { 0, 0, viewportSize };
    }
    lower = glm::min(lower, glm::dvec2(clip) / clip.w);
    upper = glm::max(upper, glm::dvec2(clip) / clip.w);
  }
  const glm::dvec2 size(viewportSize);
  const glm::dvec2 first =
    glm::clamp(glm::floor((lower * 0.5 + 0.5) * size) - 1.0, glm::dvec2(0), size);
  const glm::dvec2 last =
    glm::clamp(glm::ceil((upper * 0.5 + 0.5) * size) + 1.0, glm::dvec2(0), size);
  const glm::ivec2 extent = glm::max(glm::ivec2(last - first), glm::ivec2(0));
  return { glm::ivec2(first), extent };
}
