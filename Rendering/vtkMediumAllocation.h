// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumAllocation.h
 * @brief Whether the device gave a texture its memory, and how much that is.
 *
 * VTK says whether in some versions and builds and only reports it in others; OpenGL knows.
 */
#ifndef vtkMediumAllocation_h
#define vtkMediumAllocation_h

#include "vtkMediumOpenGL.h"

#include "vtkTextureObject.h"

#include <algorithm>

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

/// Of a texture whose channels have so many bytes each; 0 where it has none on the device.
inline vtkTypeInt64 vtkMediumBytesOf(vtkTextureObject* texture, std::size_t channelBytes)
{
  const vtkTypeInt64 channels = vtkTypeInt64(texture->GetWidth()) * texture->GetHeight() *
    std::max(texture->GetDepth(), 1u) * texture->GetComponents();
  return texture->GetHandle() ? channels * static_cast<vtkTypeInt64>(channelBytes) : 0;
}

#endif
