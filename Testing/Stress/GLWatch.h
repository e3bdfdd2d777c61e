// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLWatch.h
 * @brief Hears each OpenGL error and each report of undefined behaviour of a window's context.
 *
 * KHR_debug's messages where the context has them, which also name the call; glGetError in any case.
 */
#ifndef GLWatch_h
#define GLWatch_h

#include "vtkMediumOpenGL.h"

#include "vtkOpenGLRenderWindow.h"

#include <sstream>
#include <string>
#include <vector>

namespace vtkMediumStress
{
class GLWatch
{
public:
  /// Makes the window's context, if there is none yet, and listens to it.
  void Start(vtkRenderWindow* window)
  {
    static_cast<vtkOpenGLRenderWindow*>(window)->Initialize();
    window->MakeCurrent();
    while (glGetError() != GL_NO_ERROR)
    {
    }
    if (glDebugMessageCallback)
    {
      glEnable(GL_DEBUG_OUTPUT);
      glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
      glDebugMessageCallback(Hear, this);
    }
  }

  /// Stops listening; the window's context must be there still.
  void Stop(vtkRenderWindow* window)
  {
    window->MakeCurrent();
    if (glDebugMessageCallback)
    {
      glDebugMessageCallback(nullptr, nullptr);
    }
  }

  /// Looks for errors that no callback reported, and gives all that were heard.
  const std::vector<std::string>& Look()
  {
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
    {
      std::ostringstream text;
      text << "glGetError says 0x" << std::hex << error;
      this->Messages.push_back(text.str());
    }
    return this->Messages;
  }

  /// Forgets what was provoked.
  void Forget()
  {
    this->Look();
    this->Messages.clear();
  }

private:
  static void GLAPIENTRY Hear(
    GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* watch)
  {
    if (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
    {
      static_cast<GLWatch*>(const_cast<void*>(watch))->Messages.emplace_back(message);
    }
  }

  std::vector<std::string> Messages;
};
}

#endif
