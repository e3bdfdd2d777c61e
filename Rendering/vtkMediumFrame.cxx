// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumFrame.h"

#include "vtkMediumAllocation.h"
#include "vtkMediumDrawState.h"
#include "vtkMediumUserCode.h"

#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <sstream>

//------------------------------------------------------------------------------
std::string vtkMediumFrame::Begin(
  vtkOpenGLRenderWindow* window, const Viewport& viewport, bool carry, bool copyDepth, bool finish)
{
  this->Window = window;
  this->View = viewport;
  this->UsedTargets = carry ? Targets : Targets - 1;
  this->UsedSets = carry || finish ? 2 : 1;
  this->Result = 0;
  const unsigned int width = viewport.GetRays().x, height = viewport.GetRays().y;
  const int filter = viewport.PixelEdge > 1 ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  this->Framebuffer->SetContext(window);
  this->ReleaseUnusedTargets();
  for (int set = 0; set < this->UsedSets; ++set)
  {
    for (int target = 0; target < this->UsedTargets; ++target)
    {
      vtkTextureObject* texture = this->Textures[set][target];
      if (!texture->GetHandle() || texture->GetWidth() != width || texture->GetHeight() != height)
      {
        texture->SetContext(window);
        texture->SetMinificationFilter(vtkTextureObject::Nearest);
        texture->SetMagnificationFilter(vtkTextureObject::Nearest);
        if (!texture->Create2D(width, height, 4, VTK_FLOAT, false) ||
          !vtkMediumIsAllocated(texture))
        {
          this->ReleaseGraphicsResources(window); // so that the next frame allocates anew
          std::ostringstream text;
          text << "The device could not allocate a float image of " << width << " x " << height
               << " pixels; make the window smaller or free device memory.";
          return text.str();
        }
      }
      texture->SetMagnificationFilter(filter);
    }
  }
  const std::string problem = this->CheckTargets();
  if (!problem.empty())
  {
    return problem;
  }
  copyDepth ? this->Depth.Capture(window, viewport.Origin, viewport.Size)
            : this->Depth.SetToFar(window, viewport.Size);
  this->Ends = this->Depth.GetTexture();
  return {};
}

//------------------------------------------------------------------------------
bool vtkMediumFrame::Integrate(const Resources& resources, const vtkMediumScene& scene,
  const vtkMediumPlan& plan, const Progress& progress)
{
  const glm::ivec2 rays = this->View.GetRays();
  vtkOpenGLState* state = this->Window->GetState();
  const vtkMediumDrawState plain(state, rays);
  this->Draws = 0;
  state->PushFramebufferBindings();
  for (int set = 0; set < this->UsedSets; ++set)
  {
    this->ClearTargets(set);
  }
  glm::ivec4 seen = vtkMediumPlan::FindScissor(scene.Eye, scene.Geometry, rays);
  if (plan.UseTiles)
  {
    resources.Accelerator.ProjectTiles(scene, rays);
    seen = resources.Accelerator.GetScissor();
  }
  bool compiled = true;
  this->Complete = true;
  if (seen.z > 0 && seen.w > 0)
  {
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(seen.x, seen.y, seen.z, seen.w);
    const double parts = plan.Rough ? 2 : 1;
    double done = 0;
    auto share = [&](double fraction) { return progress((done + fraction) / parts); };
    for (const vtkMediumPlan* part = &plan; part && compiled && this->Complete;
         part = part->Rough.get(), ++done)
    {
      compiled = this->DrawPlan(resources, scene, *part, progress ? share : Progress());
    }
  }
  this->Complete = this->Complete && compiled;
  state->PopFramebufferBindings();
  return compiled;
}

//------------------------------------------------------------------------------
// False where its program does not compile.
bool vtkMediumFrame::DrawPlan(const Resources& resources, const vtkMediumScene& scene,
  const vtkMediumPlan& plan, const Progress& progress)
{
  vtkShaderProgram* program =
    resources.Programs.Use(this->Window, plan.ShaderFiles, plan.ShaderDefines, plan.UserCode.get());
  if (!program)
  {
    return false;
  }
  resources.Textures.Activate(program, plan);
  resources.Accelerator.Activate(program, plan);
  resources.ShadowMap.Activate(program, plan);
  this->Ends->Activate();
  program->SetUniformi("opaqueDepth", this->Ends->GetTextureUnit());
  this->SetFrameUniforms(program, scene, plan);
  this->SetContentUniforms(program, scene, plan);
  this->Complete = this->DrawPasses(resources.Programs, program, plan, progress);
  this->Ends->Deactivate();
  resources.ShadowMap.Deactivate();
  resources.Accelerator.Deactivate();
  resources.Textures.Deactivate();
  return true;
}

//------------------------------------------------------------------------------
// False where it was stopped between two draws.
bool vtkMediumFrame::DrawPasses(vtkMediumProgram& programs, vtkShaderProgram* program,
  const vtkMediumPlan& plan, const Progress& progress)
{
  const std::size_t passes = plan.Passes.size();
  for (std::size_t i = 0; i < passes; ++i)
  {
    vtkMediumPlan::Pass draw = plan.Passes[i];
    for (bool over = false; !over;)
    {
      this->DrawPass(programs, program, draw);
      ++draw.FirstStep; // a march that goes on in the next draw began in the first
      over = plan.IterationBudget == 0 || this->IsOver();
      const bool last = over && i + 1 == passes;
      if (progress)
      {
        last ? glFlush() : glFinish(); // a draw that is only queued cannot be stopped
        if (!progress((i + over) / static_cast<double>(passes)) && !last)
        {
          return false;
        }
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// Whether every pixel's march is.
bool vtkMediumFrame::IsOver()
{
  const std::vector<float> hits = this->Read(1);
  for (std::size_t i = 3; i < hits.size(); i += 4)
  {
    if (hits[i] == Unfinished)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkMediumFrame::DrawPass(
  vtkMediumProgram& programs, vtkShaderProgram* program, const vtkMediumPlan::Pass& pass)
{
  const int set = this->UsedSets - 1 - this->Result;
  const char* names[Targets] = { "carriedRadiance", "carriedHits", "carriedMarch" };
  const int carried = this->UsedTargets == Targets ? Targets : 0;
  this->BindTargets(set);
  for (int target = 0; target < carried; ++target)
  {
    vtkTextureObject* texture = this->Textures[1 - set][target];
    texture->Activate();
    program->SetUniformi(names[target], texture->GetTextureUnit());
  }
  program->SetUniformi("firstLight", pass.FirstLight);
  program->SetUniformi("lastLight", pass.LastLight);
  program->SetUniformi("firstStep", pass.FirstStep);
  program->SetUniformi("lastStep", pass.LastStep);
  programs.Draw();
  for (int target = 0; target < carried; ++target)
  {
    this->Textures[1 - set][target]->Deactivate();
  }
  this->Result = set;
  ++this->Draws;
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumFrame::Download(int target)
{
  return this->Complete ? this->Read(target) : std::vector<float>();
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumFrame::DownloadBounds()
{
  const std::vector<float> marches =
    this->UsedTargets == Targets ? this->Download(2) : std::vector<float>();
  std::vector<float> bounds(marches.size() / 4);
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    bounds[i] = marches[4 * i + 3];
  }
  return bounds;
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumFrame::Read(int target)
{
  vtkTextureObject* texture = this->Textures[this->Result][target];
  if (!texture->GetHandle())
  {
    return {};
  }
  unsigned int size[2] = { texture->GetWidth(), texture->GetHeight() };
  std::vector<float> pixels(4 * static_cast<std::size_t>(size[0]) * size[1]);
  vtkIdType increments[2] = { 0, 0 };
  vtkPixelBufferObject* buffer = texture->Download();
  buffer->Download2D(VTK_FLOAT, pixels.data(), size, 4, increments);
  buffer->Delete();
  return pixels;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumFrame::GetBytes() const
{
  vtkTypeInt64 bytes = this->Depth.GetBytes();
  for (const auto& set : this->Textures)
  {
    for (const auto& texture : set)
    {
      bytes += vtkMediumBytesOf(texture, sizeof(float));
    }
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkMediumFrame::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& set : this->Textures)
  {
    for (auto& texture : set)
    {
      texture->ReleaseGraphicsResources(window);
    }
  }
  this->Depth.ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Result = 0;
}
