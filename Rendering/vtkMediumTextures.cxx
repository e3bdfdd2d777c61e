// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumTextures.h"

#include "vtkMediumAllocation.h"
#include "vtkMediumFoldUniforms.h"
#include "vtkMediumFormulas.h"
#include "vtkMediumPackedTexels.h"
#include "vtkMediumTexels.h"

#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <sstream>

namespace
{
constexpr int JitterSize = 64;    // texels along an edge of the table of random numbers
constexpr int TexelsPerLight = 4; // see Shaders/vtkMediumLights.glsl

//------------------------------------------------------------------------------
void AppendTexel(std::vector<float>& texels, const glm::dvec3& rgb, double alpha)
{
  for (int c = 0; c < 3; ++c)
  {
    texels.push_back(static_cast<float>(rgb[c]));
  }
  texels.push_back(static_cast<float>(alpha));
}

//------------------------------------------------------------------------------
std::vector<float> SamplesOf(const std::vector<vtkMediumFunction>& functions)
{
  std::vector<float> texels;
  for (const vtkMediumFunction& function : functions)
  {
    for (const glm::dvec4& sample : function.GetSamples())
    {
      AppendTexel(texels, glm::dvec3(sample), sample.w);
    }
  }
  return texels;
}

//------------------------------------------------------------------------------
// From a function's first sample to each, its range as 1.
std::vector<float> IntegralsOf(const std::vector<vtkMediumFunction>& functions)
{
  std::vector<float> texels;
  for (const vtkMediumFunction& function : functions)
  {
    const std::vector<glm::dvec4>& samples = function.GetSamples();
    const double intervals = static_cast<double>(samples.size()) - 1;
    glm::dvec4 integral(0);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      integral += i == 0 ? glm::dvec4(0) : 0.5 * (samples[i - 1] + samples[i]) / intervals;
      AppendTexel(texels, glm::dvec3(integral), integral.w);
    }
  }
  return texels;
}

//------------------------------------------------------------------------------
std::string Indexed(const char* name, std::size_t index)
{
  return std::string(name) + '[' + std::to_string(index) + ']';
}
}

//------------------------------------------------------------------------------
std::string vtkMediumTextures::Update(
  vtkOpenGLRenderWindow* window, const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  this->Window = window;
  this->NonFinite = 0;
  while (this->Fields.size() < plan.Fields.size())
  {
    this->Fields.emplace_back(new FieldTexture);
  }
  for (std::size_t i = 0; i < plan.Fields.size(); ++i)
  {
    if (!this->UpdateField(*this->Fields[i], plan.Fields[i], plan.Folds[i]))
    {
      const glm::ivec3 size = plan.Folds[i].GetSize();
      std::ostringstream text;
      text << "The device could not allocate a 3D texture of " << size.x << " x " << size.y << " x "
           << size.z << " x " << plan.Fields[i].Components
           << " floats; free device memory, or resample the image (vtkImageResize).";
      return text.str();
    }
  }
  this->TableFailed = false;
  if (plan.ReadsFunctions)
  {
    this->UpdateFunctions(scene.Content.Functions, plan.ReadsFunctionIntegrals);
  }
  this->UpdateLights(scene.Lights);
  this->UpdatePhase(scene.Content.PhaseTable);
  if (plan.ReadsJitter)
  {
    this->UpdateJitter();
  }
  if (this->TableFailed)
  {
    return "The device could not allocate a table of floats; free device memory.";
  }
  return {};
}

//------------------------------------------------------------------------------
bool vtkMediumTextures::UpdateField(
  FieldTexture& texture, const vtkMediumField& field, const vtkMediumFold& fold)
{
  vtkTextureObject* object = texture.Texture;
  const bool kept = object->GetHandle() && texture.Array == field.Array.Get() &&
    texture.Time == field.Time && texture.FirstComponent == field.FirstComponent &&
    texture.Components == field.Components && texture.Fold == fold;
  if (!kept)
  {
    if (!this->UploadField(object, field, fold))
    {
      object->ReleaseGraphicsResources(this->Window);
      return false;
    }
    texture.Array = field.Array;
    texture.Time = field.Time;
    texture.FirstComponent = field.FirstComponent;
    texture.Components = field.Components;
    texture.Fold = fold;
    const glm::ivec3 size = fold.GetSize();
    texture.Bytes = static_cast<vtkTypeInt64>(size.x) * size.y * size.z * field.Components *
      (vtkMediumPackingFactor(field) > 0 ? sizeof(std::uint16_t) : sizeof(float));
    ++this->Uploads;
  }
  const int filter = field.Linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  object->SetMinificationFilter(filter);
  object->SetMagnificationFilter(filter);
  return true;
}

//------------------------------------------------------------------------------
bool vtkMediumTextures::UploadField(
  vtkTextureObject* texture, const vtkMediumField& field, const vtkMediumFold& fold)
{
  texture->SetContext(this->Window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->ResetFormatAndType(); // it may have held another field
  auto create = [&](int type, void* texels) {
    const glm::ivec3 size = fold.GetSize();
    return texture->Create3DFromRaw(size.x, size.y, size.z, field.Components, type, texels) &&
      vtkMediumIsAllocated(texture);
  };
  if (vtkMediumPackingFactor(field) > 0)
  {
    static const unsigned int formats[5] = { 0, GL_R16, GL_RG16, GL_RGB16, GL_RGBA16 };
    texture->SetInternalFormat(formats[field.Components]);
    std::vector<std::uint16_t> texels = fold.Fold(vtkMediumPackedTexels(field), field.Components);
    return create(VTK_UNSIGNED_SHORT, texels.data());
  }
  std::vector<float> texels = fold.Fold(vtkMediumTexels(field, this->NonFinite), field.Components);
  return create(VTK_FLOAT, texels.data());
}

//------------------------------------------------------------------------------
void vtkMediumTextures::UploadTable(vtkTextureObject* texture, int width, int height,
  int components, const std::vector<float>& texels, bool linear)
{
  const int filter = linear ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  texture->SetContext(this->Window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  const bool created = texture->Create2DFromRaw(
    width, height, components, VTK_FLOAT, const_cast<float*>(texels.data()));
  if (!created || !vtkMediumIsAllocated(texture))
  {
    texture->ReleaseGraphicsResources(this->Window); // so that the next frame tries anew
    this->TableFailed = true;
  }
  ++this->Uploads;
}

//------------------------------------------------------------------------------
void vtkMediumTextures::UpdateFunctions(
  const std::vector<vtkMediumFunction>& functions, bool integrals)
{
  if (functions != this->Functions)
  {
    this->FunctionTable->ReleaseGraphicsResources(this->Window);
    this->PrimitiveTable->ReleaseGraphicsResources(this->Window);
    this->Functions = functions;
  }
  const int width = static_cast<int>(functions.front().GetSamples().size());
  const int height = static_cast<int>(functions.size());
  if (!this->FunctionTable->GetHandle())
  {
    this->UploadTable(this->FunctionTable, width, height, 4, SamplesOf(functions), true);
  }
  if (integrals && !this->PrimitiveTable->GetHandle())
  {
    this->UploadTable(this->PrimitiveTable, width, height, 4, IntegralsOf(functions), false);
  }
}

//------------------------------------------------------------------------------
void vtkMediumTextures::UpdateLights(const std::vector<vtkMediumScene::Light>& lights)
{
  std::vector<float> texels;
  for (const vtkMediumScene::Light& light : lights)
  {
    const bool directional = light.Type == vtkMediumScene::Light::Directional;
    AppendTexel(texels, directional ? -light.Direction : light.Position, light.Type);
    AppendTexel(texels, light.Irradiance, light.CosCone);
    AppendTexel(texels, light.Attenuation, light.Exponent);
    AppendTexel(texels, light.Direction, 0);
  }
  if (texels.empty() || (this->LightTable->GetHandle() && texels == this->LightTexels))
  {
    this->LightTexels = texels;
    return;
  }
  this->UploadTable(
    this->LightTable, TexelsPerLight, static_cast<int>(lights.size()), 4, texels, false);
  --this
      ->Uploads; // a light's numbers are no upload worth counting: a headlight's change every frame
  this->LightTexels = texels;
}

//------------------------------------------------------------------------------
void vtkMediumTextures::UpdatePhase(const std::vector<double>& table)
{
  const std::vector<float> texels(table.begin(), table.end());
  if (texels.empty() || (this->PhaseTable->GetHandle() && texels == this->PhaseTexels))
  {
    return;
  }
  this->UploadTable(this->PhaseTable, static_cast<int>(texels.size()), 1, 1, texels, true);
  this->PhaseTexels = texels;
}

//------------------------------------------------------------------------------
void vtkMediumTextures::UpdateJitter()
{
  if (this->JitterTable->GetHandle())
  {
    return;
  }
  std::vector<float> texels;
  for (unsigned int y = 0; y < JitterSize; ++y)
  {
    for (unsigned int x = 0; x < JitterSize; ++x)
    {
      texels.push_back(vtkMediumFormulas::Float::jitterOffset(x, y, 0u));
    }
  }
  this->UploadTable(this->JitterTable, JitterSize, JitterSize, 1, texels, false);
}

//------------------------------------------------------------------------------
void vtkMediumTextures::Activate(vtkShaderProgram* program, const vtkMediumPlan& plan)
{
  auto activate = [&](vtkTextureObject* texture, const std::string& name) {
    if (texture->GetHandle() && program->IsUniformUsed(name.c_str()))
    {
      texture->Activate();
      program->SetUniformi(name.c_str(), texture->GetTextureUnit());
      this->Active.push_back(texture);
    }
  };
  for (std::size_t i = 0; i < plan.Fields.size(); ++i)
  {
    const vtkMediumField& field = plan.Fields[i];
    activate(this->Fields[i]->Texture, Indexed("fields", i));
    vtkMediumSetLatticeUniforms(program,
      { Indexed("fieldScale", i), Indexed("fieldBias", i), Indexed("fieldFolds", i) },
      plan.Folds[i], field.BoxToLattice(glm::dvec3(0)), field.BoxToLattice(glm::dvec3(1)),
      plan.Folded);
    program->SetUniformf(
      Indexed("fieldTexelScale", i).c_str(), static_cast<float>(vtkMediumTexelScale(field)));
    // In the field's own unit, which the coefficients' scales take up (vtkMediumFrame): a double may be
    // beyond float.
    const double minimum = field.Minimum / field.GetUnit();
    const double range = field.Maximum / field.GetUnit() - minimum;
    program->SetUniformf(Indexed("fieldMinimum", i).c_str(), static_cast<float>(minimum));
    program->SetUniformf(Indexed("fieldRange", i).c_str(), static_cast<float>(range));
  }
  if (!this->Functions.empty())
  {
    // A texel of 0 is the centre of the first entry, 1 that of the last.
    const float width = static_cast<float>(this->Functions.front().GetSamples().size());
    const float scale[2] = { (width - 1) / width, 0.5f / width };
    program->SetUniform2f("functionScale", scale);
  }
  activate(this->FunctionTable, "functions");
  activate(this->PrimitiveTable, "primitives");
  activate(this->LightTable, "lights");
  if (this->LightTexels.size() == 4 * TexelsPerLight && program->IsUniformUsed("oneLight"))
  {
    float texels[TexelsPerLight][4];
    std::copy(this->LightTexels.begin(), this->LightTexels.end(), &texels[0][0]);
    program->SetUniform4fv("oneLight", TexelsPerLight, texels);
  }
  activate(this->PhaseTable, "phaseTable");
  activate(this->JitterTable, "jitterTable");
}

//------------------------------------------------------------------------------
void vtkMediumTextures::Deactivate()
{
  for (vtkTextureObject* texture : this->Active)
  {
    texture->Deactivate();
  }
  this->Active.clear();
}

//------------------------------------------------------------------------------
void vtkMediumTextures::ReleaseUnread(const vtkMediumPlan& plan)
{
  if (this->LightTexels.empty())
  {
    this->LightTable->ReleaseGraphicsResources(this->Window);
  }
  while (this->Fields.size() > plan.Fields.size())
  {
    this->Fields.back()->Texture->ReleaseGraphicsResources(this->Window);
    this->Fields.pop_back();
  }
}

//------------------------------------------------------------------------------
void vtkMediumTextures::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& field : this->Fields)
  {
    field->Texture->ReleaseGraphicsResources(window);
  }
  this->Fields.clear();
  this->FunctionTable->ReleaseGraphicsResources(window);
  this->PrimitiveTable->ReleaseGraphicsResources(window);
  this->LightTable->ReleaseGraphicsResources(window);
  this->PhaseTable->ReleaseGraphicsResources(window);
  this->JitterTable->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumTextures::GetBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (const auto& field : this->Fields)
  {
    bytes += field->Bytes;
  }
  for (vtkTextureObject* table : { this->FunctionTable.Get(), this->PrimitiveTable.Get(),
         this->LightTable.Get(), this->PhaseTable.Get(), this->JitterTable.Get() })
  {
    bytes += vtkMediumBytesOf(table, sizeof(float));
  }
  return bytes;
}
