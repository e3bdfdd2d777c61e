// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumStructure.h"

#include "vtkMediumPlan.h"

#include <sstream>

namespace
{
//------------------------------------------------------------------------------
// A coefficient as an expression of the box coordinate `box`: its source times its scale.
std::string Expression(const vtkMediumScene::Coefficient& coefficient, const char* scale,
  const vtkMediumScene::Medium& content)
{
  using Coefficient = vtkMediumScene::Coefficient;
  std::ostringstream text;
  switch (coefficient.Source)
  {
    case Coefficient::Field:
    {
      const char* swizzles[4] = { ".rrr", ".ggg", ".bbb", ".aaa" };
      const bool rgb =
        coefficient.Component < 0 && content.Fields[coefficient.FieldIndex].Components >= 3;
      text << "(fieldValue(" << coefficient.FieldIndex << ", box)"
           << (rgb ? ".rgb" : swizzles[coefficient.Component < 0 ? 0 : coefficient.Component])
           << " * " << scale << ")";
      break;
    }
    case Coefficient::FunctionRGB:
    case Coefficient::FunctionAlpha:
      text << "(functionValue(" << coefficient.FunctionIndex << ", fieldTexel("
           << coefficient.FieldIndex << ", box).r)"
           << (coefficient.Source == Coefficient::FunctionRGB ? ".rgb" : ".aaa") << " * " << scale
           << ")";
      break;
    default:
      text << scale;
  }
  return text.str();
}
}

//------------------------------------------------------------------------------
bool vtkMediumStructure::HasConstantExtinction(const vtkMediumScene::Medium& content)
{
  return !content.Altered && content.Masks.empty() && content.Extinction.IsConstant() &&
    (!content.ExtinctionIsAbsorption || content.Scattering.IsConstant());
}

//------------------------------------------------------------------------------
std::string vtkMediumStructure::ContentDefines(const vtkMediumScene::Medium& content)
{
  std::ostringstream text;
  const char* mask = content.Masks.empty() ? "" : " * MASK(box)";
  text << MaskDefines(content.Masks);
  text << "#define FUNCTION_COUNT " << content.Functions.size() << "\n";
  text << "#define EXTINCTION(box) (" << Expression(content.Extinction, "extinctionScale", content)
       << mask << ")\n";
  text << "#define SCATTERING(box) (" << Expression(content.Scattering, "scatteringScale", content)
       << (content.ScatteringIsAlbedo ? "" : mask) << ")\n";
  text << (content.Altered ? "#define USER_COEFFICIENTS\n" : "");
  if (HasConstantExtinction(content))
  {
    text << "#define EXTINCTION_CONSTANT\n";
  }
  if (content.ExtinctionIsAbsorption)
  {
    text << "#define EXTINCTION_IS_ABSORPTION\n";
  }
  if (content.ScatteringIsAlbedo)
  {
    text << "#define SCATTERING_IS_ALBEDO\n";
  }
  if (!content.Emission.IsZero())
  {
    text << "#define EMISSION(box) (" << Expression(content.Emission, "emissionScale", content)
         << mask << ")\n";
  }
  text << "#define ANISOTROPY(box) " << Expression(content.Anisotropy, "anisotropyScale", content)
       << ".x\n";
  if (content.ChromaticExtinction)
  {
    text << "#define CHROMATIC_EXTINCTION\n";
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string vtkMediumStructure::ExactDefines(const vtkMediumScene::Medium& content)
{
  using Coefficient = vtkMediumScene::Coefficient;
  const Coefficient& extinction = content.Extinction;
  const bool function = extinction.Source == Coefficient::FunctionRGB ||
    extinction.Source == Coefficient::FunctionAlpha;
  if (!function || content.Altered || content.ExtinctionIsAbsorption ||
    !content.Fields[extinction.FieldIndex].Linear)
  {
    return {}; // affine in the field, a sum that has no table of its own, or constant in a cell
  }
  std::ostringstream text;
  text << "#define EXTINCTION_TEXEL(box) fieldTexel(" << extinction.FieldIndex << ", box).r\n";
  text << "#define EXTINCTION_BETWEEN(a, b) (functionMean(" << extinction.FunctionIndex << ", a, b)"
       << (extinction.Source == Coefficient::FunctionRGB ? ".rgb" : ".aaa")
       << " * extinctionScale)\n";
  return text.str();
}

//------------------------------------------------------------------------------
std::string vtkMediumStructure::MaskDefines(const std::vector<int>& textures)
{
  std::ostringstream text;
  for (int texture : textures)
  {
    text << (text.tellp() == 0 ? "#define MASK(box) (" : " * ") << "fieldNearest(" << texture
         << ", box)";
  }
  return textures.empty() ? std::string() : text.str() + ")\n";
}

//------------------------------------------------------------------------------
std::string vtkMediumStructure::CutDefines(const vtkMediumCut& cut)
{
  if (cut.Planes.empty())
  {
    return {};
  }
  std::ostringstream text;
  text << "#define CLIPPING_PLANES " << cut.Planes.size() << "\n";
  text << "#define CLIPPING_PLANES_MOST " << vtkMediumPlan::MostClippingPlanes << "\n";
  return text.str();
}

//------------------------------------------------------------------------------
std::string vtkMediumStructure::LightDefines(const std::vector<vtkMediumScene::Light>& lights)
{
  bool positional = false, spot = false;
  for (const vtkMediumScene::Light& light : lights)
  {
    positional |= light.Type != vtkMediumScene::Light::Directional;
    spot |= light.Type == vtkMediumScene::Light::Spot;
  }
  std::string text;
  text += positional ? "#define POSITIONAL_LIGHTS\n" : "";
  text += spot ? "#define SPOT_LIGHTS\n" : "";
  text += lights.size() == 1 ? "#define ONE_LIGHT\n" : "";
  return text;
}

//------------------------------------------------------------------------------
std::string vtkMediumStructure::PhaseDefines(const vtkMediumScene::Medium& content, bool schlick)
{
  vtkMediumScene::Phases phase = content.Phase;
  if (schlick && phase != vtkParticipatingMedium::SchlickK)
  {
    phase = vtkParticipatingMedium::Schlick;
  }
  const bool oneLobe = phase == vtkParticipatingMedium::Schlick ||
    phase == vtkParticipatingMedium::SchlickK || phase == vtkParticipatingMedium::HenyeyGreenstein;
  if (oneLobe && content.Anisotropy.IsZero())
  {
    phase = vtkParticipatingMedium::Isotropic;
  }
  return "#define PHASE(angle, g) PHASE_" + std::to_string(phase) + "(angle, g)\n";
}
