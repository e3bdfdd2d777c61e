// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What vtkMediumFrame does with an integrated frame: finishes it and shows it.
#include "vtkMediumFrame.h"

#include "vtkMediumDrawState.h"
#include "vtkMediumOpenGL.h"
#include "vtkMediumUserCode.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
bool vtkMediumFrame::Finish(
  vtkMediumProgram& programs, const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  if (this->Draws == 0)
  {
    return true; // out of view
  }
  vtkShaderProgram* program = programs.Use(this->Window, { "Finish" }, "", plan.UserCode.get());
  this->Complete = program != nullptr;
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = this->Window->GetState();
  const vtkMediumDrawState plain(state, this->View.GetRays());
  state->PushFramebufferBindings();
  vtkTextureObject* radiance = this->Textures[this->Result][0];
  vtkTextureObject* hits = this->Textures[this->Result][1];
  this->Result = 1 - this->Result;
  this->BindTargets(this->Result);
  radiance->Activate();
  hits->Activate();
  program->SetUniformi("radiance", radiance->GetTextureUnit());
  program->SetUniformi("hits", hits->GetTextureUnit());
  program->SetUniformf("worldLength", static_cast<float>(scene.Geometry.Length));
  programs.Draw();
  hits->Deactivate();
  radiance->Deactivate();
  state->PopFramebufferBindings();
  return true;
}

//------------------------------------------------------------------------------
bool vtkMediumFrame::Show(vtkMediumProgram& programs, const Shown& shown, vtkMediumFrame& coarser)
{
  vtkOpenGLState* state = this->Window->GetState();
  vtkShaderProgram* program = programs.Use(this->Window, { "Display" }, "");
  if (!program)
  {
    return false;
  }
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDepthMask(GL_FALSE);

  vtkTextureObject* radiance = this->Textures[this->Result][0];
  vtkTextureObject* hits = this->Textures[this->Result][1];
  vtkTextureObject* other =
    shown.Content == Shown::Error ? coarser.Textures[coarser.Result][0].Get() : radiance;
  radiance->Activate();
  hits->Activate();
  other->Activate();
  program->SetUniformi("coarserRadiance", other->GetTextureUnit());
  program->SetUniformi("radiance", radiance->GetTextureUnit());
  program->SetUniformi("hits", hits->GetTextureUnit());
  program->SetUniformi("shown", shown.Content);
  program->SetUniformf("nearest", static_cast<float>(shown.Nearest));
  program->SetUniformf("scale", static_cast<float>(shown.Scale));
  programs.Draw();
  if (other != radiance)
  {
    other->Deactivate();
  }
  hits->Deactivate();
  radiance->Deactivate();
  return true;
}
