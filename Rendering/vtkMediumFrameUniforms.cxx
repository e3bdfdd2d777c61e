// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a scene and its plan that a program reads.
#include "vtkMediumCutUniforms.h"
#include "vtkMediumFrame.h"

#include "vtkMediumOpenGL.h"
#include "vtkShaderProgram.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, const glm::dvec3& value)
{
  const glm::vec3 rounded(value);
  program->SetUniform3f(name, &rounded[0]);
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, const glm::dvec4& value)
{
  const glm::vec4 rounded(value);
  program->SetUniform4f(name, &rounded[0]);
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, double value)
{
  program->SetUniformf(name, static_cast<float>(value));
}

//------------------------------------------------------------------------------
void SetUniform(vtkShaderProgram* program, const char* name, const glm::ivec2& value)
{
  const float rounded[2] = { static_cast<float>(value.x), static_cast<float>(value.y) };
  program->SetUniform2f(name, rounded);
}
}

//------------------------------------------------------------------------------
void vtkMediumFrame::SetFrameUniforms(
  vtkShaderProgram* program, const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  const vtkMediumScene::Box& box = scene.Geometry;
  const vtkMediumScene::View& eye = scene.Eye;
  const glm::mat3 axes(box.LocalToBoxAxes);
  float rows[9];
  std::copy(&axes[0][0], &axes[0][0] + 9, rows);
  program->SetUniformMatrix3x3("localToBoxAxes", rows);
  SetUniform(program, "localToBoxOrigin", box.LocalToBoxOrigin);
  SetUniform(program, "worldLength", box.Length);
  SetUniform(program, "eyeStep", plan.EyeStep);
  SetUniform(program, "eyeStretch", plan.EyeStretch);
  SetUniform(program, "longestStretch", vtkMediumPlan::LongestStretch);
  SetUniform(program, "lightStep", plan.LightStep);
  SetUniform(program, "transmittanceThreshold", plan.TransmittanceThreshold);
  SetUniform(program, "depthTransmittance", plan.DepthTransmittance);
  SetUniform(program, "viewportSize", this->View.GetRays());
  // Rays start near the volume, not at the eye, for a float is coarse far from the local origin.
  const double slope = glm::dot(glm::dvec3(eye.ClipW), eye.Direction);
  const double reach = eye.Parallel ? 0.0 : std::max(eye.ClipW.w / slope, 0.0);
  SetUniform(program, "eyeReach", reach);
  SetUniform(program, "eyeOrigin", eye.Origin + reach * eye.Direction);
  SetUniform(program, "eyeOriginX", eye.OriginX + reach * eye.DirectionX);
  SetUniform(program, "eyeOriginY", eye.OriginY + reach * eye.DirectionY);
  SetUniform(program, "eyeDirection", eye.Direction);
  SetUniform(program, "eyeDirectionX", eye.DirectionX);
  SetUniform(program, "eyeDirectionY", eye.DirectionY);
  SetUniform(program, "nearPlane", eye.ClipW + eye.ClipZ);
  SetUniform(program, "farPlane", eye.ClipW - eye.ClipZ);
  vtkMediumSetCutUniforms(program, scene.Cut);
}

//------------------------------------------------------------------------------
void vtkMediumFrame::SetContentUniforms(
  vtkShaderProgram* program, const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  const vtkMediumScene::Medium& content = scene.Content;
  const double unit = scene.Geometry.Length * content.DensityScale; // per world to per local unit
  auto scale = [&content](const vtkMediumScene::Coefficient& coefficient) {
    const bool field = coefficient.Source == vtkMediumScene::Coefficient::Field;
    return coefficient.Scale * (field ? content.Fields[coefficient.FieldIndex].GetUnit() : 1.0);
  };
  SetUniform(program, "extinctionScale", unit * scale(content.Extinction));
  SetUniform(program, "scatteringScale",
    (content.ScatteringIsAlbedo ? 1.0 : unit) * scale(content.Scattering));
  SetUniform(program, "emissionScale", unit * scale(content.Emission));
  SetUniform(program, "anisotropyScale", scale(content.Anisotropy));
  SetUniform(program, "phaseLobes",
    glm::dvec4(content.BackAnisotropy, content.ForwardWeight, content.DraineAlpha, 0));
  for (std::size_t i = 0; i < plan.Lattices.size(); ++i)
  {
    const std::string index = '[' + std::to_string(i) + ']';
    SetUniform(program, ("latticeScale" + index).c_str(), plan.Lattices[i].Scale);
    SetUniform(program, ("latticeBias" + index).c_str(), plan.Lattices[i].Bias);
  }
  program->SetUniformi("iterationBudget", plan.IterationBudget);
  SetUniform(program, "exactTolerance", vtkMediumPlan::ExactTolerance);
  SetUniform(program, "paperExtinction", plan.Filled.Extinction);
  SetUniform(program, "paperScattering", plan.Filled.Scattering);
  SetUniform(program, "paperAnisotropy", content.Anisotropy.Scale.x);
  SetUniform(program, "paperThreshold", plan.PaperThreshold);
  SetUniform(program, "paperJitter", plan.Jitter);
  program->SetUniform2i("firstPixel", &this->View.FirstPixel[0]);
}
