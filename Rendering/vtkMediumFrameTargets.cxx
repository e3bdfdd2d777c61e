// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The float images that vtkMediumFrame integrates into, as a framebuffer.
#include "vtkMediumFrame.h"

#include "vtkMediumDrawState.h"
#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <sstream>

//------------------------------------------------------------------------------
std::string vtkMediumFrame::CheckTargets()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  unsigned int status = GL_FRAMEBUFFER_COMPLETE;
  for (int set = 0; set < this->UsedSets && status == GL_FRAMEBUFFER_COMPLETE; ++set)
  {
    this->BindTargets(set);
    status = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER);
  }
  state->PopFramebufferBindings();
  if (status == GL_FRAMEBUFFER_COMPLETE)
  {
    return {};
  }
  std::ostringstream text;
  text << "The device cannot draw into a float image of " << this->View.Size.x << " x "
       << this->View.Size.y << " pixels (framebuffer status 0x" << std::hex << status
       << "); use a device that can (OpenGL 3.2 with GL_RGBA32F), make the window smaller or free "
          "device memory.";
  this->ReleaseGraphicsResources(this->Window); // so that the next frame allocates anew
  return text.str();
}

//------------------------------------------------------------------------------
void vtkMediumFrame::BindTargets(int set)
{
  this->Framebuffer->Bind();
  for (int target = 0; target < this->UsedTargets; ++target)
  {
    this->Framebuffer->AddColorAttachment(target, this->Textures[set][target]);
  }
  // One that an earlier frame left there, and that may be smaller, would clip this one.
  for (int target = this->UsedTargets; target < Targets; ++target)
  {
    this->Framebuffer->RemoveColorAttachment(target);
  }
  vtkMediumActivateDrawBuffers(this->Framebuffer, this->UsedTargets);
}

//------------------------------------------------------------------------------
void vtkMediumFrame::ClearTargets(int set)
{
  const float clear[Targets][4] = { { 0, 0, 0, 0 }, { NoHit, NoHit, 0, 0 }, { 0, 0, 0, 0 } };
  this->BindTargets(set);
  for (int target = 0; target < this->UsedTargets; ++target)
  {
    glClearBufferfv(GL_COLOR, target, clear[target]);
  }
}

//------------------------------------------------------------------------------
// Those that carry a march from draw to draw are as large as the rest together.
void vtkMediumFrame::ReleaseUnusedTargets()
{
  for (int set = 0; set < 2; ++set)
  {
    for (int target = 0; target < Targets; ++target)
    {
      if (set >= this->UsedSets || target >= this->UsedTargets)
      {
        this->Textures[set][target]->ReleaseGraphicsResources(this->Window);
      }
    }
  }
}
