// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumDrawState
 * @brief OpenGL's state for a draw that writes every pixel of its targets as it is; the state before
 * comes back with its end.
 */
#ifndef vtkMediumDrawState_h
#define vtkMediumDrawState_h

#include "vtkMediumOpenGL.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"

#include <glm/vec2.hpp>

class vtkMediumDrawState
{
public:
  vtkMediumDrawState(vtkOpenGLState* state, const glm::ivec2& size)
    : DepthTest(state, GL_DEPTH_TEST)
    , Blend(state, GL_BLEND)
    , ScissorTest(state, GL_SCISSOR_TEST)
    , Cull(state, GL_CULL_FACE)
    , DepthMask(state)
    , ColorMask(state)
    , Viewport(state)
    , Scissor(state)
    , ActiveTexture(state)
  {
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglViewport(0, 0, size.x, size.y);
  }

private:
  vtkOpenGLState::ScopedglEnableDisable DepthTest, Blend, ScissorTest, Cull;
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglColorMask ColorMask;
  vtkOpenGLState::ScopedglViewport Viewport;
  vtkOpenGLState::ScopedglScissor Scissor;
  vtkOpenGLState::ScopedglActiveTexture ActiveTexture;
};

/// Draws go into so many first attachments of a framebuffer that is bound. VTK remembers the draw buffers of
/// the framebuffer that was bound before, and sets none where that had as many, as within a pass.
inline void vtkMediumActivateDrawBuffers(vtkOpenGLFramebufferObject* framebuffer, int count)
{
  framebuffer->ActivateDrawBuffers(static_cast<unsigned int>(count));
  const GLenum attachments[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2 };
  glDrawBuffers(count, attachments);
}

#endif
