// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What the Paper integrator asks of a scene, and the homogeneous medium that it makes of it.
#include "vtkMediumPlan.h"

#include "vtkMediumStructure.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include <numeric>
#include <sstream>

namespace
{
using Mapper = vtkSingleScatteringVolumeMapper;
using Coefficient = vtkMediumScene::Coefficient;

//------------------------------------------------------------------------------
// The sample of a function with the largest extinction among those at or above the threshold.
glm::dvec4 DensestSample(const vtkMediumFunction& function, double threshold)
{
  const std::vector<glm::dvec4>& samples = function.GetSamples();
  glm::dvec4 densest = samples.back();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double value = vtkMediumFunction::GetPlace(
      function.GetMinimum(), function.GetMaximum(), i, samples.size() - 1);
    if (value >= threshold && samples[i].w > densest.w)
    {
      densest = samples[i];
    }
  }
  return densest;
}

//------------------------------------------------------------------------------
// Empty, or why the Paper integrator cannot draw the scene.
std::string FindRefusal(const vtkMediumScene& scene, const vtkMediumPlan::Settings& settings)
{
  const vtkMediumScene::Medium& content = scene.Content;
  const vtkMediumField& scalars = scene.Scalars;
  if (!scalars.Array)
  {
    return "The Paper integrator compares the input's scalars with its threshold, but the "
           "input has no scalars; give it some, or use the FixedStep integrator.";
  }
  if (!(settings.PaperThreshold <= scalars.Maximum))
  {
    std::ostringstream text;
    text << "The paper threshold is " << settings.PaperThreshold << ", but the scalars end at "
         << scalars.Maximum << " (they span " << scalars.Minimum << ".." << scalars.Maximum
         << "), so that nothing is filled; set a threshold in that range "
         << "(SetPaperThreshold).";
    return text.str();
  }
  if (settings.Output > Mapper::Distance)
  {
    return "The Paper integrator has no such output (" + std::to_string(settings.Output) +
      "); choose Radiance, FirstHit or Distance, or the FixedStep integrator.";
  }
  if (settings.Output == Mapper::Radiance && scene.Lights.empty())
  {
    return "No light is on, but the Paper integrator shows nothing but scattered light; add "
           "a vtkLight with an intensity > 0 to the renderer, or show distances "
           "(SetOutputToDistance).";
  }
  for (const Coefficient* coefficient : { &content.Extinction, &content.Scattering })
  {
    if (coefficient->Source == Coefficient::Field ||
      (!coefficient->IsConstant() &&
        content.Fields[coefficient->FieldIndex].Array != scalars.Array))
    {
      return "The Paper integrator draws a homogeneous medium, but a coefficient comes from "
             "an array; set constants, or use the FixedStep integrator.";
    }
  }
  return {};
}
}

//------------------------------------------------------------------------------
void vtkMediumPlan::PlanPaper(const vtkMediumScene& scene, const Settings& settings)
{
  this->Refusal = FindRefusal(scene, settings);
  if (!this->Refusal.empty())
  {
    return;
  }
  const vtkMediumScene::Medium& content = scene.Content;
  const vtkMediumField& scalars = scene.Scalars;
  const double range = scalars.Maximum - scalars.Minimum;
  this->PaperThreshold = range > 0 ? (settings.PaperThreshold - scalars.Minimum) / range : 0;

  auto densest = [&](const Coefficient& coefficient) {
    if (coefficient.IsConstant())
    {
      return coefficient.Scale;
    }
    const glm::dvec4 sample =
      DensestSample(content.Functions[coefficient.FunctionIndex], settings.PaperThreshold);
    return coefficient.Scale *
      (coefficient.Source == Coefficient::FunctionAlpha ? glm::dvec3(sample.w)
                                                        : glm::dvec3(sample));
  };
  const double unit = content.DensityScale * scene.Geometry.Length;
  glm::dvec3 extinction = unit * densest(content.Extinction);
  const glm::dvec3 scattering =
    densest(content.Scattering) * (content.ScatteringIsAlbedo ? extinction : glm::dvec3(unit));
  if (content.ExtinctionIsAbsorption)
  {
    extinction += scattering;
  }
  this->Filled = Homogeneous{ extinction, scattering };
  this->ReadsJitter = settings.Jitter > 0;
}

//------------------------------------------------------------------------------
std::string vtkMediumPlan::PaperDefines(const Settings& settings) const
{
  std::ostringstream text;
  text << "#define BINARY_SEARCH_ITERATIONS " << settings.BinarySearchIterations << "\n";
  text << (settings.AssumeConvex ? "#define ASSUME_CONVEX\n" : "");
  text << (this->ReadsJitter ? "#define JITTER\n" : "");
  std::vector<int> masks(this->Fields.size() - 1);
  std::iota(masks.begin(), masks.end(), 1); // behind the scalars
  text << vtkMediumStructure::MaskDefines(masks);
  return text.str();
}

//------------------------------------------------------------------------------
// The scalars, and the masks behind them.
std::vector<vtkMediumField> vtkMediumPlan::PaperFields(const vtkMediumScene& scene)
{
  std::vector<vtkMediumField> fields{ scene.Scalars };
  for (int mask : scene.Content.Masks)
  {
    fields.push_back(scene.Content.Fields[mask]);
  }
  return fields;
}
