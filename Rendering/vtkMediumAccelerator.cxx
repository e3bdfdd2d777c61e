// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumAccelerator.h"

#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
int CountGroups(int lights)
{
  return (lights + vtkMediumAccelerator::LightsPerTexture - 1) /
    vtkMediumAccelerator::LightsPerTexture;
}

//------------------------------------------------------------------------------
// Channels of a group's texture: what its lights need, as OpenGL has it.
int CountChannels(int group, int lights)
{
  const int here = std::min(lights - group * vtkMediumAccelerator::LightsPerTexture,
    vtkMediumAccelerator::LightsPerTexture);
  return here == 3 ? 4 : here;
}
}

//------------------------------------------------------------------------------
std::string vtkMediumAccelerator::Update(
  vtkOpenGLRenderWindow* window, const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  this->Window = window;
  if (!plan.UseBricks)
  {
    return {};
  }
  this->UpdateGrid(scene);
  const vtkMediumSignature occupancy = vtkMediumSignature::OfOccupancy(scene);
  if (occupancy != this->BrickSignature)
  {
    this->Bricks.Build(scene, this->Grid);
    this->BrickSignature = occupancy;
    ++this->BrickBuilds;
  }
  if (!this->UpdateCaches(scene, plan.CachedLights))
  {
    const glm::ivec3& size = this->Grid.GetDimensions();
    std::ostringstream text;
    text << "The device could not allocate the light caches, " << plan.CachedLights << " x "
         << size.x << " x " << size.y << " x " << size.z
         << " half floats; free device memory, or use the FixedStep integrator.";
    return text.str();
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::UpdateGrid(const vtkMediumScene& scene)
{
  const vtkMediumSignature extinction = vtkMediumSignature::OfExtinction(scene);
  if (extinction != this->GridSignature)
  {
    this->Grid.Build(scene);
    this->GridSignature = extinction;
    this->Lights.clear();
  }
}

//------------------------------------------------------------------------------
bool vtkMediumAccelerator::UpdateCaches(const vtkMediumScene& scene, int lights)
{
  const double densityScale = scene.Content.DensityScale;
  const bool allNew = this->Lights.empty() || lights != this->CachedLights ||
    densityScale != this->CachedDensityScale;
  this->Lights.resize(lights);
  this->CacheTextures.resize(CountGroups(lights));
  this->CachedLights = lights;
  this->CachedDensityScale = densityScale;
  for (int group = 0; group < CountGroups(lights); ++group)
  {
    bool changed =
      allNew || !this->CacheTextures[group] || !this->CacheTextures[group]->GetHandle();
    const int end = std::min((group + 1) * LightsPerTexture, lights);
    for (int number = group * LightsPerTexture; number < end; ++number)
    {
      std::unique_ptr<CachedLight>& light = this->Lights[number];
      if (!light || !vtkMediumLightCache::HaveSamePose(light->Pose, scene.Lights[number]))
      {
        light.reset(new CachedLight);
        light->Cache.Build(this->Grid, scene.Lights[number]);
        light->Pose = scene.Lights[number];
        ++this->LightCacheBuilds;
        changed = true;
      }
    }
    if (changed && !this->UploadGroup(group, lights, densityScale))
    {
      this->Lights.clear();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMediumAccelerator::UploadGroup(int group, int lights, double densityScale)
{
  const int channels = CountChannels(group, lights);
  const int end = std::min((group + 1) * LightsPerTexture, lights);
  const glm::ivec3& size = this->Grid.GetDimensions();
  std::vector<std::uint16_t> texels(this->Grid.GetValues().size() * channels);
  for (int number = group * LightsPerTexture; number < end; ++number)
  {
    this->Lights[number]->Cache.PackTransmittance(
      densityScale, true, texels.data() + number % LightsPerTexture, channels);
  }
  static const unsigned int formats[5] = { 0, GL_R16F, GL_RG16F, GL_RGBA16F, GL_RGBA16F };
  if (!this->CacheTextures[group])
  {
    this->CacheTextures[group] = vtkSmartPointer<vtkTextureObject>::New();
  }
  vtkTextureObject* texture = this->CacheTextures[group];
  texture->SetContext(this->Window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->SetInternalFormat(formats[channels]);
  texture->SetDataType(GL_HALF_FLOAT);
  while (glGetError() != GL_NO_ERROR)
  {
  }
  return texture->Create3DFromRaw(size.x, size.y, size.z, channels, VTK_FLOAT, texels.data()) &&
    glGetError() == GL_NO_ERROR;
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::ProjectTiles(const vtkMediumScene& scene, const glm::ivec2& viewportSize)
{
  vtkMediumBricks::Tiles tiles = this->Bricks.ProjectToTiles(scene, viewportSize.x, viewportSize.y);
  this->Scissor = tiles.Scissor;
  if (tiles.Scissor.z < 1 || tiles.Scissor.w < 1)
  {
    return;
  }
  vtkTextureObject* texture = this->TileTexture;
  texture->SetContext(this->Window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->Create2DFromRaw(
    tiles.Count.x, tiles.Count.y, 2, VTK_FLOAT, static_cast<void*>(tiles.Ranges.data()));
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::Activate(vtkShaderProgram* program, const vtkMediumPlan& plan)
{
  auto activate = [&](vtkTextureObject* texture, const std::string& name) {
    texture->Activate();
    program->SetUniformi(name.c_str(), texture->GetTextureUnit());
    this->Active.push_back(texture);
  };
  if (plan.UseBricks)
  {
    activate(this->TileTexture, "tiles");
  }
  for (int group = 0; group < CountGroups(plan.CachedLights); ++group)
  {
    activate(this->CacheTextures[group], "lightCaches[" + std::to_string(group) + ']');
  }
  const glm::dvec3 size(this->Grid.GetDimensions());
  const glm::vec3 scale((this->Grid.GetUpper() - this->Grid.GetLower()) / size);
  const glm::vec3 bias((this->Grid.GetLower() + 0.5) / size);
  program->SetUniform3f("lightCacheScale", &scale[0]);
  program->SetUniform3f("lightCacheBias", &bias[0]);
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::Deactivate()
{
  for (vtkTextureObject* texture : this->Active)
  {
    texture->Deactivate();
  }
  this->Active.clear();
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& texture : this->CacheTextures)
  {
    if (texture)
    {
      texture->ReleaseGraphicsResources(window);
    }
  }
  this->CacheTextures.clear();
  this->TileTexture->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumAccelerator::GetBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (int group = 0; group < static_cast<int>(this->CacheTextures.size()); ++group)
  {
    bytes += static_cast<vtkTypeInt64>(this->Grid.GetValues().size()) *
      CountChannels(group, this->CachedLights) * sizeof(std::uint16_t);
  }
  return bytes;
}
