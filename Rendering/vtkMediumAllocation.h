// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumAllocation.h
 * @brief Whether the device gave a texture its memory.
 *
 * VTK says so in some versions and builds and only reports it in others; OpenGL knows.
 */
#ifndef vtkMediumAllocation_h
#define vtkMediumAllocation_h

#include "vtkMediumOpenGL.h"

#include "vtkTextureObject.h"

/// Of a texture that was just created.
inline bool vtkMediumIsAllocated(vtkTextureObject* texture)
{
  GLint width = 0;
  texture->Activate();
  glGetTexLevelParameteriv(texture->GetTarget(), 0, GL_TEXTURE_WIDTH, &width);
  texture->Deactivate();
  const bool allocated = width > 0 && static_cast<unsigned int>(width) == texture->GetWidth();
  while (!allocated && glGetError() != GL_NO_ERROR) // the caller reports it
  {
  }
  return allocated;
}

#endif
