// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumOpaqueDepth
 * @brief The depth of the opaque geometry that is drawn already, as a texture: rays end there.
 *
 * A blit resolves multisampled framebuffers, and needs a target of the source's own depth format.
 */
#ifndef vtkMediumOpaqueDepth_h
#define vtkMediumOpaqueDepth_h

#include "vtkMediumCompatibility.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"
#include "vtkType.h"

#include <glm/vec2.hpp>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkWindow;
VTK_ABI_NAMESPACE_END

class vtkMediumOpaqueDepth
{
public:
  /// Takes the depth of a part of the framebuffer that is bound for drawing.
  void Capture(vtkOpenGLRenderWindow* window, const glm::ivec2& origin, const glm::ivec2& size);
  /// Takes it that nothing opaque is drawn.
  void SetToFar(vtkOpenGLRenderWindow* window, const glm::ivec2& size);

  vtkTextureObject* GetTexture() { return this->Texture; }
  vtkTypeInt64 GetBytes() const;
  /// How often Capture copied a depth buffer, since creation.
  int GetCopies() const { return this->Copies; }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// One of vtkTextureObject's depth formats, or one of these.
  enum Formats
  {
    None = -1,
    Far = -2,
    DepthStencil = -3,
  };

  static int FindFormat();
  bool Fits(int format, const glm::ivec2& size);
  void Allocate(vtkOpenGLRenderWindow* window, int format, const glm::ivec2& size);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Texture;
  int Format = None;
  int Copies = 0;
};

#endif
