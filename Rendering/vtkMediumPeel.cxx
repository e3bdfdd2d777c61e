// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumPeel.h"

#include "vtkMediumAllocation.h"
#include "vtkMediumDrawState.h"
#include "vtkMediumProgram.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

namespace
{
const char* const CompilerFault = "The shader that takes part in depth peeling did not compile on "
                                  "this device; the compiler's words are "
                                  "above.";
}

//------------------------------------------------------------------------------
vtkMediumPeel::Caller vtkMediumPeel::FindCaller(vtkAbstractMapper* mapper, vtkVolume* volume)
{
  vtkInformation* keys = volume->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; keys && keys->Has(passes) && i < passes->Length(keys); ++i)
  {
    vtkObjectBase* pass = passes->Get(keys, i);
    if (pass && pass->IsA("vtkDualDepthPeelingPass"))
    {
      return { static_cast<vtkOpenGLRenderPass*>(pass), mapper, volume };
    }
  }
  return {};
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkMediumPeel::Use(const Caller& caller, vtkOpenGLRenderWindow* window,
  vtkMediumProgram& programs, const char* defines)
{
  std::string vertex, geometry, fragment = vtkMediumProgram::Assemble({ "Peel" }, defines);
  caller.Pass->PreReplaceShaderValues(vertex, geometry, fragment, caller.Mapper, caller.Volume);
  vtkShaderProgram* program = programs.Use(window, fragment);
  if (program)
  {
    caller.Pass->SetShaderParameters(program, caller.Mapper, caller.Volume, nullptr);
  }
  return program;
}

//------------------------------------------------------------------------------
std::string vtkMediumPeel::Note(const Caller& caller, vtkOpenGLRenderWindow* window,
  vtkMediumProgram& programs, const glm::ivec2& size)
{
  const unsigned int width = size.x, height = size.y;
  this->Framebuffer->SetContext(window);
  for (vtkTextureObject* texture : this->Ends)
  {
    if (!texture->GetHandle() || texture->GetWidth() != width || texture->GetHeight() != height)
    {
      texture->SetContext(window);
      texture->SetMinificationFilter(vtkTextureObject::Nearest);
      texture->SetMagnificationFilter(vtkTextureObject::Nearest);
      if (!texture->Create2D(width, height, 4, VTK_FLOAT, false) || !vtkMediumIsAllocated(texture))
      {
        this->ReleaseGraphicsResources(window); // so that the next frame allocates anew
        return "The device could not allocate the depths of depth peeling; make the window "
               "smaller, or "
               "switch it off for volumes (UseDepthPeelingForVolumesOff).";
      }
    }
  }
  vtkOpenGLState* state = window->GetState();
  const vtkMediumDrawState plain(state, size);
  state->PushFramebufferBindings();
  this->Framebuffer->Bind();
  for (int piece = 0; piece < Pieces; ++piece)
  {
    this->Framebuffer->AddColorAttachment(piece, this->Ends[piece]);
  }
  vtkMediumActivateDrawBuffers(this->Framebuffer, Pieces);
  const float empty[4] = { 0, 0, 0, 1 };
  for (int piece = 0; piece < Pieces; ++piece)
  {
    glClearBufferfv(GL_COLOR, piece, empty); // where the pass discards
  }
  const bool compiled = vtkMediumPeel::Use(caller, window, programs, "#define PEEL_NOTES\n");
  if (compiled)
  {
    programs.Draw();
  }
  state->PopFramebufferBindings();
  return compiled ? std::string() : CompilerFault;
}

//------------------------------------------------------------------------------
std::string vtkMediumPeel::HandOver(const Caller& caller, vtkOpenGLRenderWindow* window,
  vtkMediumProgram& programs, const std::array<vtkTextureObject*, Pieces>& radiance)
{
  vtkShaderProgram* program = vtkMediumPeel::Use(caller, window, programs, "");
  if (!program)
  {
    return CompilerFault;
  }
  // The pass has set all else, blending above all.
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  const char* const names[Pieces] = { "firstPiece", "secondPiece" };
  for (int piece = 0; piece < Pieces; ++piece)
  {
    radiance[piece]->Activate();
    program->SetUniformi(names[piece], radiance[piece]->GetTextureUnit());
  }
  programs.Draw();
  for (vtkTextureObject* texture : radiance)
  {
    texture->Deactivate();
  }
  return {};
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumPeel::GetBytes() const
{
  vtkTypeInt64 pixels = 0;
  for (vtkTextureObject* texture : this->Ends)
  {
    pixels += texture->GetHandle() ? vtkTypeInt64(texture->GetWidth()) * texture->GetHeight() : 0;
  }
  return pixels * 4 * static_cast<vtkTypeInt64>(sizeof(float));
}

//------------------------------------------------------------------------------
void vtkMediumPeel::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkTextureObject* texture : this->Ends)
  {
    texture->ReleaseGraphicsResources(window);
  }
  this->Framebuffer->ReleaseGraphicsResources(window);
}
