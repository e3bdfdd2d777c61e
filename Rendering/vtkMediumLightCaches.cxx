// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightCaches.h"

#include "vtkMediumAllocation.h"
#include "vtkMediumFoldUniforms.h"
#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <sstream>
#include <utility>

namespace
{
//------------------------------------------------------------------------------
// The lights of a texture: [first, last).
glm::ivec2 LightsOf(int group, const vtkMediumPlan& plan)
{
  const int first = group * plan.GetLightsPerTexture();
  return { first, std::min(first + plan.GetLightsPerTexture(), plan.CachedLights) };
}

//------------------------------------------------------------------------------
// Channels of a texture: what its lights need, as OpenGL has it.
int CountChannels(const glm::ivec2& lights, bool roughness)
{
  const int count = (lights.y - lights.x) * vtkMediumPlan::ChannelsPerLight(roughness);
  return count == 3 ? 4 : count;
}

//------------------------------------------------------------------------------
// The lattice points that look-ups where there is extinction can meet. A light ray that leaves them finds the
// value of the face that it left through: behind that face nothing is in its way.
vtkMediumLatticePart FindPart(const vtkMediumExtinctionGrid& grid)
{
  const vtkMediumLatticePart& occupied = grid.GetOccupiedPart();
  return occupied.IsEmpty() ? vtkMediumLatticePart{ glm::ivec3(0), glm::ivec3(1) }
                            : occupied.Grow(1, grid.GetDimensions());
}
}

//------------------------------------------------------------------------------
bool vtkMediumLightCaches::AreBuilt(const vtkMediumScene& scene, const vtkMediumPlan& plan) const
{
  bool built = static_cast<int>(this->Lights.size()) == plan.CachedLights;
  for (int number = 0; number < plan.CachedLights && built; ++number)
  {
    built = this->HasCache(number, scene.Lights[number]);
  }
  return built;
}

//------------------------------------------------------------------------------
bool vtkMediumLightCaches::HasCache(int number, const vtkMediumScene::Light& pose) const
{
  const std::unique_ptr<CachedLight>& light = this->Lights[number];
  return light && vtkMediumLightCache::HaveSamePose(light->Pose, pose);
}

//------------------------------------------------------------------------------
std::string vtkMediumLightCaches::Update(vtkOpenGLRenderWindow* window,
  const vtkMediumExtinctionGrid& grid, const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  const double densityScale = scene.Content.DensityScale;
  const bool allNew = this->Lights.empty() || plan.CachedLights != this->CachedLights ||
    plan.CacheRoughness != this->Roughness || densityScale != this->DensityScale;
  this->Part = FindPart(grid);
  this->Fold = vtkMediumFold(this->Part.GetSize(), plan.LargestTexture);
  this->Lights.resize(plan.CachedLights);
  this->Textures.resize(plan.GetCacheTextures());
  this->CachedLights = plan.CachedLights;
  this->Roughness = plan.CacheRoughness;
  this->DensityScale = densityScale;
  for (int group = 0; group < plan.GetCacheTextures(); ++group)
  {
    bool changed = allNew || !this->Textures[group] || !this->Textures[group]->GetHandle();
    const glm::ivec2 lights = LightsOf(group, plan);
    for (int number = lights.x; number < lights.y; ++number)
    {
      changed = this->BuildLight(number, grid, scene.Lights[number]) || changed;
    }
    if (changed && !this->UploadGroup(window, group, plan))
    {
      this->Forget();
      const glm::ivec3 size = this->Fold.GetSize();
      std::ostringstream text;
      text << "The device could not allocate the light caches, " << plan.CachedLights << " x "
           << size.x << " x " << size.y << " x " << size.z
           << " half floats; free device memory, or use the FixedStep integrator.";
      return text.str();
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// False where the light has its cache.
bool vtkMediumLightCaches::BuildLight(
  int number, const vtkMediumExtinctionGrid& grid, const vtkMediumScene::Light& pose)
{
  if (this->HasCache(number, pose))
  {
    return false;
  }
  std::unique_ptr<CachedLight>& light = this->Lights[number];
  light.reset(new CachedLight);
  light->Cache.Build(grid, pose);
  light->Pose = pose;
  ++this->Builds;
  return true;
}

//------------------------------------------------------------------------------
bool vtkMediumLightCaches::UploadGroup(
  vtkOpenGLRenderWindow* window, int group, const vtkMediumPlan& plan)
{
  const glm::ivec2 lights = LightsOf(group, plan);
  const int channels = CountChannels(lights, plan.CacheRoughness);
  std::vector<std::uint16_t> texels(this->Part.GetNumberOfPoints() * channels);
  for (int number = lights.x; number < lights.y; ++number)
  {
    const int channel = (number - lights.x) * vtkMediumPlan::ChannelsPerLight(plan.CacheRoughness);
    this->Lights[number]->Cache.Pack(
      this->DensityScale, this->Part, plan.CacheRoughness, texels.data() + channel, channels);
  }
  static const unsigned int formats[5] = { 0, GL_R16F, GL_RG16F, GL_RGBA16F, GL_RGBA16F };
  if (!this->Textures[group])
  {
    this->Textures[group] = vtkSmartPointer<vtkTextureObject>::New();
  }
  vtkTextureObject* texture = this->Textures[group];
  texture->SetContext(window);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  texture->SetWrapR(vtkTextureObject::ClampToEdge);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  texture->ResetFormatAndType(); // it may have had other channels
  texture->SetInternalFormat(formats[channels]);
  texture->SetDataType(GL_HALF_FLOAT);
  ++this->Uploads;
  const glm::ivec3 size = this->Fold.GetSize();
  texels = this->Fold.Fold(std::move(texels), channels);
  return texture->Create3DFromRaw(size.x, size.y, size.z, channels, VTK_FLOAT, texels.data()) &&
    vtkMediumIsAllocated(texture);
}

//------------------------------------------------------------------------------
void vtkMediumLightCaches::Activate(vtkShaderProgram* program, const vtkMediumExtinctionGrid& grid,
  const vtkMediumPlan& plan, std::vector<vtkTextureObject*>& active) const
{
  for (int group = 0; group < plan.GetCacheTextures(); ++group)
  {
    vtkTextureObject* texture = this->Textures[group];
    texture->Activate();
    const std::string name = "lightCaches[" + std::to_string(group) + ']';
    program->SetUniformi(name.c_str(), texture->GetTextureUnit());
    active.push_back(texture);
  }
  const glm::dvec3 first(this->Part.Begin);
  vtkMediumSetLatticeUniforms(program, { "lightCacheScale", "lightCacheBias", "lightCacheFold" },
    this->Fold, grid.GetLower() - first, grid.GetUpper() - first, plan.Folded);
}

//------------------------------------------------------------------------------
void vtkMediumLightCaches::ReleaseTextures(vtkWindow* window)
{
  for (auto& texture : this->Textures)
  {
    if (texture)
    {
      texture->ReleaseGraphicsResources(window);
    }
  }
  this->Textures.clear();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumLightCaches::GetBytes() const
{
  vtkTypeInt64 bytes = 0;
  for (const auto& texture : this->Textures)
  {
    bytes += vtkMediumBytesOf(texture, sizeof(std::uint16_t));
  }
  return bytes;
}
