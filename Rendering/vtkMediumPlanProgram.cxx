// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The program of a plan: its defines and the shader files that it is made of.
#include "vtkMediumPlan.h"

#include "vtkMediumStructure.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include <algorithm>
#include <initializer_list>
#include <sstream>

namespace
{
using Mapper = vtkSingleScatteringVolumeMapper;
}

//------------------------------------------------------------------------------
std::string vtkMediumPlan::OutputDefines(const Settings& settings) const
{
  const bool depth = settings.Output == Mapper::Depth;
  const bool firstHit = settings.Output == Mapper::FirstHit ||
    (depth && settings.DepthDefinition == Mapper::FirstHitDepth);
  std::string text = std::string("#define FIRST_HIT_ONLY ") + (firstHit ? "true\n" : "false\n");
  if (settings.CountTaps || settings.Output == Mapper::SampleCount)
  {
    text += "#define COUNT_TAPS\n";
  }
  if (settings.Output == Mapper::Transmittance)
  {
    text += "#define OUTPUT_TRANSMITTANCE\n";
  }
  if (settings.Output == Mapper::OpticalDepth)
  {
    text += "#define OUTPUT_OPTICAL_DEPTH\n";
  }
  if (depth && settings.DepthDefinition == Mapper::MeanScatteringDepth)
  {
    text += "#define OUTPUT_MEAN_DEPTH\n";
  }
  if (depth && settings.DepthDefinition == Mapper::TransmittanceDepth)
  {
    text += "#define OUTPUT_TRANSMITTANCE_DEPTH\n";
  }
  return text;
}

//------------------------------------------------------------------------------
void vtkMediumPlan::ChooseProgram(
  const vtkMediumScene& scene, const Settings& settings, const Capabilities& device)
{
  const bool paper = settings.Integrator == Mapper::Paper;
  const bool exact = settings.Integrator == Mapper::Exact;
  this->ReadsFunctions = !paper && !scene.Content.Functions.empty();
  std::ostringstream defines;
  defines << (this->Lit ? "#define LIT\n" : "");
  defines << (this->OpaqueShadows ? "#define OPAQUE_SHADOWS\n" : "");
  defines << (this->NeedsState() ? "#define CARRY_STATE\n" : "");
  defines << this->OutputDefines(settings);
  defines << this->FieldDefines();
  if (paper)
  {
    defines << this->PaperDefines(settings);
  }
  else
  {
    defines << vtkMediumStructure::ContentDefines(scene.Content);
    defines << "#define LIGHT_TAPS " << LightTapsPerIteration << "\n";
  }
  if (this->UseTiles)
  {
    defines << "#define TILES " << TileEdge << "\n";
  }
  if (this->CachedLights > 0)
  {
    defines << "#define LIGHT_CACHE_TEXTURES " << this->GetCacheTextures() << "\n";
    defines << "#define LIGHTS_PER_CACHE_TEXTURE " << this->GetLightsPerTexture() << "\n";
    defines << (this->CacheRoughness ? "#define LIGHT_CACHE_ROUGHNESS\n" : "");
    defines << (this->OnlyRough ? "#define ONLY_ROUGH\n" : "");
  }
  if (this->Lit && (this->CachedLights == 0 || this->OnlyRough))
  {
    defines << "#define MARCHED_LIGHT\n";
  }
  if (exact && !this->ClosedForm)
  {
    const std::string functions = vtkMediumStructure::ExactDefines(scene.Content);
    this->ReadsFunctionIntegrals = !functions.empty();
    defines << functions;
    defines << "#define EXACT_PARTS " << ExactParts << "\n";
    defines << "#define LATTICE_COUNT " << this->Lattices.size() << "\n";
    const bool linear = std::any_of(this->Fields.begin(), this->Fields.end(),
      [](const vtkMediumField& field) { return field.Linear; });
    defines << (device.CoarseFilter && linear ? "#define COARSE_FILTER\n" : "");
  }
  defines << vtkMediumStructure::CutDefines(scene.Cut);
  defines << vtkMediumStructure::LightDefines(scene.Lights);
  defines << vtkMediumStructure::PhaseDefines(scene.Content, paper);
  this->ShaderDefines = defines.str();
  this->ChooseShaderFiles(scene, settings.Integrator);
}

//------------------------------------------------------------------------------
void vtkMediumPlan::ChooseShaderFiles(const vtkMediumScene& scene, int integrator)
{
  std::vector<std::string>& files = this->ShaderFiles;
  auto add = [&files](std::initializer_list<const char*> names) {
    files.insert(files.end(), names.begin(), names.end());
  };
  add({ "Phase", "RayBox", "Segment", "Transmittance", "Frame" });
  if (!scene.Cut.Planes.empty())
  {
    add({ "ClippingPlanes" });
  }
  add({ scene.Cut.CutsRegions() ? "KeptRegions" : "KeptInterval", "EyeRay", "Fold", "Fields" });
  if (this->Lit)
  {
    add({ "PhaseLobes", "Light" });
    if (this->OpaqueShadows)
    {
      add({ "ShadowMap" });
    }
    add({ "Lights" });
  }
  if (this->ClosedForm)
  {
    add({ "Content", "Output", "ClosedForm" });
  }
  else
  {
    this->ChooseIntegratorFiles(integrator);
  }
}

//------------------------------------------------------------------------------
void vtkMediumPlan::ChooseIntegratorFiles(int integrator)
{
  std::vector<std::string>& files = this->ShaderFiles;
  auto add = [&files](std::initializer_list<const char*> names) {
    files.insert(files.end(), names.begin(), names.end());
  };
  switch (integrator)
  {
    case Mapper::Paper:
      add({ "PaperSearch", "Paper" });
      break;
    case Mapper::Exact:
      add({ "Content", "CellWalk", "ExactDepth", "InScatter", "Output", "Exact" });
      break;
    default:
      add({ "Content" });
      if (this->UseTiles)
      {
        add({ "EmptyBricks" });
      }
      if (this->Lit)
      {
        this->ChooseLightFiles();
      }
      add({ "InScatter", "Output", "FixedStep" });
  }
}

//------------------------------------------------------------------------------
void vtkMediumPlan::ChooseLightFiles()
{
  std::vector<std::string>& files = this->ShaderFiles;
  const bool marches = this->CachedLights == 0 || this->OnlyRough;
  if (marches)
  {
    files.push_back("LightSteps");
  }
  if (this->CachedLights > 0)
  {
    files.push_back("LightCache");
  }
  if (marches)
  {
    files.push_back(this->OnlyRough ? "LightMarchToCache" : "LightRay");
  }
}
