// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumUserCode.h"

#include "vtkOpenGLUniforms.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <sstream>

namespace
{
constexpr const char* UniformsTag = "//VTK::CustomUniforms::Dec"; // VTK's own
const std::initializer_list<const char*> Points = { vtkMediumUserCode::Declarations,
  vtkMediumUserCode::Coefficients, vtkMediumUserCode::InScatter, vtkMediumUserCode::Color };

//------------------------------------------------------------------------------
// The first occurrence only: code may repeat the tag that it replaces.
void Replace(std::string& text, const std::string& tag, const std::string& code)
{
  const std::size_t at = text.find(tag);
  if (at != std::string::npos)
  {
    text.replace(at, tag.size(), code);
  }
}
}

//------------------------------------------------------------------------------
vtkMediumUserCode::vtkMediumUserCode(vtkVolume* volume)
{
  vtkShaderProperty* property = volume->GetShaderProperty();
  this->Refusal = CheckUnused(property);
  if (!this->Refusal.empty())
  {
    return;
  }
  this->Gather(property);
  if (this->Replacements.empty())
  {
    return; // nothing reads the uniforms
  }
  this->Values = vtkOpenGLUniforms::SafeDownCast(property->GetFragmentCustomUniforms());
  this->Uniforms = this->Values ? this->Values->GetDeclarations() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkMediumUserCode::GetKey(const std::vector<std::string>& files) const
{
  const bool finishes = std::find(files.begin(), files.end(), "Finish") != files.end();
  std::string key = this->Uniforms;
  for (const auto& replacement : this->Replacements)
  {
    const std::string& point = replacement.first;
    const bool isThere = point == Declarations || (point == Color) == finishes;
    key += isThere ? point + '\n' + replacement.second + '\n' : std::string();
  }
  return key;
}

//------------------------------------------------------------------------------
std::string vtkMediumUserCode::CheckUnused(vtkShaderProperty* property)
{
  if (property->HasVertexShaderCode() || property->HasFragmentShaderCode() ||
    property->HasGeometryShaderCode())
  {
    return "The volume's vtkShaderProperty holds a whole shader, but this mapper's programs are "
           "several and depend on the scene; add code at a point of them instead "
           "(AddFragmentShaderReplacement, //VTK::Medium::...).";
  }
  if (property->GetVertexCustomUniforms()->GetNumberOfUniforms() > 0 ||
    property->GetGeometryCustomUniforms()->GetNumberOfUniforms() > 0)
  {
    return "The volume's vtkShaderProperty has uniforms of a vertex or geometry shader, but code "
           "of "
           "the user runs in fragment shaders only; use GetFragmentCustomUniforms.";
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkMediumUserCode::Gather(vtkShaderProperty* property)
{
  for (bool first : { true, false }) // what replaces first stands before what does not
  {
    for (int i = 0; i < property->GetNumberOfShaderReplacements(); ++i)
    {
      std::string tag, code;
      bool replacesFirst = false, replacesAll = false;
      property->GetNthShaderReplacement(i, tag, replacesFirst, code, replacesAll);
      bool known = property->GetNthShaderReplacementTypeAsString(i) == "Fragment";
      bool isPoint = false;
      std::ostringstream points;
      for (const char* point : Points)
      {
        isPoint = isPoint || tag == point;
        points << ' ' << point;
      }
      known = known && isPoint;
      if (!known)
      {
        std::ostringstream text;
        text
          << "The volume's vtkShaderProperty replaces '" << tag << "' in a "
          << property->GetNthShaderReplacementTypeAsString(i)
          << " shader, which is no point of this mapper's shaders; those of its fragment shaders "
             "are"
          << points.str() << '.';
        this->Refusal = text.str();
        return;
      }
      if (replacesFirst == first && !code.empty())
      {
        this->Replacements[tag] += code + '\n';
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<double> vtkMediumUserCode::GetSignature() const
{
  if (this->IsEmpty())
  {
    return {};
  }
  const std::string text = this->GetKey({}) + this->GetKey({ "Finish" });
  const std::uint64_t hash = std::hash<std::string>()(text);
  const double time = this->Values ? static_cast<double>(this->Values->GetMTime()) : 0;
  return { static_cast<double>(hash >> 32), static_cast<double>(hash & 0xffffffffu), time };
}

//------------------------------------------------------------------------------
void vtkMediumUserCode::Insert(std::string& shader) const
{
  Replace(shader, UniformsTag, this->Uniforms);
  for (const auto& replacement : this->Replacements)
  {
    Replace(shader, replacement.first, replacement.second);
  }
}

//------------------------------------------------------------------------------
void vtkMediumUserCode::SetUniforms(vtkShaderProgram* program) const
{
  if (this->Values)
  {
    this->Values->SetUniforms(program);
  }
}
