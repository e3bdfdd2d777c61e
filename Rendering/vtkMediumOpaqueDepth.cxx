// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumOpaqueDepth.h"

#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <vector>

//------------------------------------------------------------------------------
// The format of the depth that is bound for drawing, told by its sizes, for a texture and a
// renderbuffer answer alike.
int vtkMediumOpaqueDepth::FindFormat()
{
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  const GLenum depth = framebuffer ? GL_DEPTH_ATTACHMENT : GL_DEPTH;
  auto ask = [](GLenum attachment, GLenum what) {
    GLint answer = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &answer);
    return answer;
  };
  if (ask(depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE)
  {
    return Far;
  }
  const int bits = ask(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  if (bits == 24 && ask(depth, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0)
  {
    return DepthStencil;
  }
  if (ask(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return vtkTextureObject::Float32;
  }
  return bits == 16 ? vtkTextureObject::Fixed16
    : bits == 24    ? vtkTextureObject::Fixed24
                    : vtkTextureObject::Fixed32;
}

//------------------------------------------------------------------------------
bool vtkMediumOpaqueDepth::Fits(int format, const glm::ivec2& size)
{
  return this->Texture->GetHandle() && this->Format == format &&
    static_cast<int>(this->Texture->GetWidth()) == size.x &&
    static_cast<int>(this->Texture->GetHeight()) == size.y;
}

//------------------------------------------------------------------------------
void vtkMediumOpaqueDepth::Allocate(
  vtkOpenGLRenderWindow* window, int format, const glm::ivec2& size)
{
  vtkTextureObject* texture = this->Texture;
  if (format != this->Format)
  {
    this->ReleaseGraphicsResources(window);
  }
  // Otherwise the texture keeps its name, and with it its place in the framebuffer.
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (format == Far)
  {
    std::vector<float> far(static_cast<std::size_t>(size.x) * size.y, 1.0f);
    texture->CreateDepthFromRaw(size.x, size.y, vtkTextureObject::Float32, VTK_FLOAT, far.data());
  }
  else if (format == DepthStencil)
  {
    texture->AllocateDepthStencil(size.x, size.y);
  }
  else
  {
    texture->AllocateDepth(size.x, size.y, format);
  }
  this->Format = format;
}

//------------------------------------------------------------------------------
void vtkMediumOpaqueDepth::SetToFar(vtkOpenGLRenderWindow* window, const glm::ivec2& size)
{
  if (!this->Fits(Far, size))
  {
    this->Allocate(window, Far, size);
  }
}

//------------------------------------------------------------------------------
void vtkMediumOpaqueDepth::Capture(
  vtkOpenGLRenderWindow* window, const glm::ivec2& origin, const glm::ivec2& size)
{
  const int format = FindFormat();
  if (format == Far) // a framebuffer without depth
  {
    this->SetToFar(window, size);
    return;
  }
  if (!this->Fits(format, size))
  {
    this->Allocate(window, format, size);
  }
  vtkOpenGLState* state = window->GetState();
  GLint source = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST); // it would cut the blit
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->PushFramebufferBindings();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, source);
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->Framebuffer->AddDepthAttachment(this->Texture);
  state->vtkglBlitFramebuffer(origin.x, origin.y, origin.x + size.x, origin.y + size.y, 0, 0,
    size.x, size.y, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->PopFramebufferBindings();
  ++this->Copies;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumOpaqueDepth::GetBytes() const
{
  const vtkTypeInt64 bytes = 4; // a pixel, in each format but the rare one of 16 bits
  return this->Format == None ? 0 : bytes * this->Texture->GetWidth() * this->Texture->GetHeight();
}

//------------------------------------------------------------------------------
void vtkMediumOpaqueDepth::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Format = None;
}
