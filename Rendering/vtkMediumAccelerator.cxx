// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumAccelerator.h"

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
  const int count = (lights.y - lights.x) * (roughness ? 2 : 1);
  return count == 3 ? 4 : count;
}

//------------------------------------------------------------------------------
// The lattice points that look-ups where there is extinction can meet. A light ray that leaves them finds the
// value of the face that it left through: behind that face nothing is in its way.
vtkMediumLatticePart FindCachedPart(const vtkMediumExtinctionGrid& grid)
{
  const vtkMediumLatticePart& occupied = grid.GetOccupiedPart();
  return occupied.IsEmpty() ? vtkMediumLatticePart{ glm::ivec3(0), glm::ivec3(1) }
                            : occupied.Grow(1, grid.GetDimensions());
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
  this->UpdateGrid(scene, plan);
  const vtkMediumSignature occupancy = vtkMediumSignature::OfOccupancy(scene);
  if (occupancy != this->BrickSignature)
  {
    this->Bricks.Build(scene, this->Grid);
    this->EmptyBricks.Build(this->Bricks);
    this->EmptyTexture->ReleaseGraphicsResources(window);
    this->BrickSignature = occupancy;
    ++this->BrickBuilds;
  }
  this->CachedPart = FindCachedPart(this->Grid);
  this->GridFold = vtkMediumFold(this->CachedPart.GetSize(), plan.LargestTexture);
  this->BrickFold = vtkMediumFold(this->Bricks.GetCount(), plan.LargestTexture);
  this->UploadEmptyBricks();
  if (plan.CachedLights > 0 && !this->UpdateCaches(scene, plan))
  {
    const glm::ivec3 size = this->GridFold.GetSize();
    std::ostringstream text;
    text << "The device could not allocate the light caches, " << plan.CachedLights << " x "
         << size.x << " x " << size.y << " x " << size.z
         << " half floats; free device memory, or use the FixedStep integrator.";
    return text.str();
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::UploadEmptyBricks()
{
  vtkTextureObject* texture = this->EmptyTexture;
  if (texture->GetHandle())
  {
    return;
  }
  const glm::ivec3 size = this->BrickFold.GetSize();
  std::vector<unsigned char> reaches = this->BrickFold.Fold(this->EmptyBricks.GetReaches(), 1);
  texture->SetContext(this->Window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->Create3DFromRaw(size.x, size.y, size.z, 1, VTK_UNSIGNED_CHAR, reaches.data());
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::UpdateGrid(const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  const vtkMediumSignature extinction = vtkMediumSignature::OfExtinction(scene);
  const vtkMediumSignature cut =
    plan.CutCaches ? vtkMediumSignature::OfCut(scene) : vtkMediumSignature();
  // Where light rays are marched only the lattice counts, so the caches wait for a plan that reads them.
  if (extinction != this->GridSignature || (plan.CachedLights > 0 && cut != this->CutSignature))
  {
    this->Grid.Build(scene);
    if (plan.CutCaches)
    {
      this->Grid.CutAway(scene.Cut);
    }
    this->GridSignature = extinction;
    this->CutSignature = cut;
    this->Lights.clear();
  }
}

//------------------------------------------------------------------------------
bool vtkMediumAccelerator::UpdateCaches(const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  const double densityScale = scene.Content.DensityScale;
  const bool allNew = this->Lights.empty() || plan.CachedLights != this->CachedLights ||
    plan.CacheRoughness != this->CachedRoughness || densityScale != this->CachedDensityScale;
  this->Lights.resize(plan.CachedLights);
  this->CacheTextures.resize(plan.GetCacheTextures());
  this->CachedLights = plan.CachedLights;
  this->CachedRoughness = plan.CacheRoughness;
  this->CachedDensityScale = densityScale;
  for (int group = 0; group < plan.GetCacheTextures(); ++group)
  {
    bool changed =
      allNew || !this->CacheTextures[group] || !this->CacheTextures[group]->GetHandle();
    const glm::ivec2 lights = LightsOf(group, plan);
    for (int number = lights.x; number < lights.y; ++number)
    {
      std::unique_ptr<CachedLight>& light = this->Lights[number];
      const bool same =
        light && vtkMediumLightCache::HaveSamePose(light->Pose, scene.Lights[number]);
      if (!same || (light->Quick && !plan.QuickCaches))
      {
        light.reset(new CachedLight);
        light->Cache.SetSlabs(plan.QuickCaches);
        light->Quick = plan.QuickCaches;
        light->Cache.Build(this->Grid, scene.Lights[number]);
        light->Pose = scene.Lights[number];
        ++this->LightCacheBuilds;
        changed = true;
      }
    }
    if (changed && !this->UploadGroup(group, plan))
    {
      this->Lights.clear();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMediumAccelerator::UploadGroup(int group, const vtkMediumPlan& plan)
{
  const glm::ivec2 lights = LightsOf(group, plan);
  const int channels = CountChannels(lights, plan.CacheRoughness);
  std::vector<std::uint16_t> texels(this->CachedPart.GetNumberOfPoints() * channels);
  for (int number = lights.x; number < lights.y; ++number)
  {
    const int channel = (number - lights.x) * (plan.CacheRoughness ? 2 : 1);
    this->Lights[number]->Cache.Pack(this->CachedDensityScale, this->CachedPart,
      plan.CacheRoughness, texels.data() + channel, channels);
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
  texture->ResetFormatAndType(); // it may have had other channels
  texture->SetInternalFormat(formats[channels]);
  texture->SetDataType(GL_HALF_FLOAT);
  ++this->LightCacheUploads;
  const glm::ivec3 size = this->GridFold.GetSize();
  texels = this->GridFold.Fold(std::move(texels), channels);
  return texture->Create3DFromRaw(size.x, size.y, size.z, channels, VTK_FLOAT, texels.data()) &&
    vtkMediumIsAllocated(texture);
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::ProjectTiles(const vtkMediumScene& scene, const glm::ivec2& viewportSize)
{
  vtkMediumBricks::Tiles tiles = this->Bricks.ProjectToTiles(scene, viewportSize.x, viewportSize.y);
  this->Scissor = tiles.Scissor;
  this->BricksCutAway = tiles.CutAway;
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
  if (plan.UseTiles)
  {
    activate(this->TileTexture, "tiles");
    activate(this->EmptyTexture, "emptyBricks");
    const glm::dvec3& lower = this->Grid.GetLower();
    const glm::vec3 scale((this->Grid.GetUpper() - lower) / double(vtkMediumBricks::Edge));
    const glm::vec3 bias(lower / double(vtkMediumBricks::Edge));
    program->SetUniform3f("boxToBricksScale", &scale[0]);
    program->SetUniform3f("boxToBricksBias", &bias[0]);
    const glm::vec3 lastBrick(this->Bricks.GetCount() - 1);
    program->SetUniform3f("lastBrick", &lastBrick[0]);
    if (plan.Folded)
    {
      vtkMediumSetFoldUniforms(program, "emptyBricksFold", this->BrickFold);
    }
    program->SetUniformf("eyeLeapsFrom", plan.LeapEyeSteps ? 0.0f : 1e30f);
  }
  for (int group = 0; group < plan.GetCacheTextures(); ++group)
  {
    activate(this->CacheTextures[group], "lightCaches[" + std::to_string(group) + ']');
  }
  const glm::dvec3 first(this->CachedPart.Begin);
  vtkMediumSetLatticeUniforms(program, { "lightCacheScale", "lightCacheBias", "lightCacheFold" },
    this->GridFold, this->Grid.GetLower() - first, this->Grid.GetUpper() - first, plan.Folded);
  program->SetUniformi("lightLookUpEvery", plan.LightLookUpEvery);
  program->SetUniformf("pixelTolerance", static_cast<float>(plan.PixelTolerance));
  program->SetUniformf("lightTolerance", static_cast<float>(plan.LightTolerance));
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
void vtkMediumAccelerator::ReleaseUnread(const vtkMediumPlan& plan, bool dark)
{
  if (!plan.UseBricks)
  {
    this->ReleaseGraphicsResources(this->Window);
  }
  else if (plan.CachedLights == 0 && (plan.Lit || dark))
  {
    this->ReleaseCaches(this->Window);
  }
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::ReleaseCaches(vtkWindow* window)
{
  for (auto& texture : this->CacheTextures)
  {
    if (texture)
    {
      texture->ReleaseGraphicsResources(window);
    }
  }
  this->CacheTextures.clear();
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->ReleaseCaches(window);
  this->TileTexture->ReleaseGraphicsResources(window);
  this->EmptyTexture->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumAccelerator::GetBytes() const
{
  auto count = [](vtkTextureObject* texture, std::size_t bytes) {
    const vtkTypeInt64 texels = vtkTypeInt64(texture->GetWidth()) * texture->GetHeight() *
      std::max(texture->GetDepth(), 1u) * texture->GetComponents();
    return texture->GetHandle() ? texels * static_cast<vtkTypeInt64>(bytes) : 0;
  };
  vtkTypeInt64 bytes = count(this->TileTexture, sizeof(float)) + count(this->EmptyTexture, 1);
  for (const auto& texture : this->CacheTextures)
  {
    bytes += count(texture, sizeof(std::uint16_t));
  }
  return bytes;
}
