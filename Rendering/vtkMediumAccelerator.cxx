// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumAccelerator.h"

#include "vtkMediumAllocation.h"
#include "vtkMediumFoldUniforms.h"
#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

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
  this->BrickFold = vtkMediumFold(this->Bricks.GetCount(), plan.LargestTexture);
  this->UploadEmptyBricks();
  return plan.CachedLights > 0 ? this->UpdateCaches(scene, plan) : std::string();
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
    this->CoarseGridIsCurrent = false;
    this->Fine.Forget();
    this->Coarse.Forget();
  }
}

//------------------------------------------------------------------------------
std::string vtkMediumAccelerator::UpdateCaches(
  const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  this->UsesCoarse = plan.QuickCaches && !this->Fine.AreBuilt(scene, plan);
  if (!this->UsesCoarse)
  {
    this->Coarse.ReleaseTextures(this->Window);
    return this->Fine.Update(this->Window, this->Grid, scene, plan);
  }
  if (!this->CoarseGridIsCurrent)
  {
    this->CoarseGrid.BuildCoarser(this->Grid);
    this->CoarseGridIsCurrent = true;
  }
  return this->Coarse.Update(this->Window, this->CoarseGrid, scene, plan);
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
  if (plan.CachedLights > 0)
  {
    const vtkMediumLightCaches& caches = this->UsesCoarse ? this->Coarse : this->Fine;
    caches.Activate(program, this->UsesCoarse ? this->CoarseGrid : this->Grid, plan, this->Active);
  }
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
    this->Fine.ReleaseTextures(this->Window);
    this->Coarse.ReleaseTextures(this->Window);
  }
}

//------------------------------------------------------------------------------
void vtkMediumAccelerator::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Fine.ReleaseTextures(window);
  this->Coarse.ReleaseTextures(window);
  this->TileTexture->ReleaseGraphicsResources(window);
  this->EmptyTexture->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumAccelerator::GetBytes() const
{
  return vtkMediumBytesOf(this->TileTexture, sizeof(float)) +
    vtkMediumBytesOf(this->EmptyTexture, 1) + this->Fine.GetBytes() + this->Coarse.GetBytes();
}
