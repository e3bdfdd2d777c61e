// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLFault.h
 * @brief Makes one OpenGL call fail as long as it exists: what a device may do, on a device that does not.
 *
 * The loader's pointers are replaced. glew has none for OpenGL 1.1, glTexImage2D and glGetIntegerv: these
 * are called directly there, and are replaced by this program's own symbols, see RowsFaults.cxx.
 */
#ifndef GLFault_h
#define GLFault_h

#include "vtkMediumOpenGL.h"

namespace vtkMediumStress
{
class GLFault
{
public:
  enum Kinds
  {
    None,
    ShaderDoesNotCompile, ///< every shader's source is replaced by what no compiler takes
    NoFloatTargets,       ///< a framebuffer with a float attachment is unsupported
    NoMemoryFor3D,        ///< a 3D texture cannot be allocated
    NoMemoryFor2D,        ///< a 2D texture of floats cannot be allocated
    NoMemoryForDepth,     ///< nor one of float depths
    NoTextures3D,         ///< the largest 3D texture has no texels
    SmallTextures3D,      ///< it has Limit3D along each axis
  };

  explicit GLFault(Kinds kind)
    : ShaderSource(glShaderSource)
    , CheckFramebufferStatus(glCheckFramebufferStatus)
    , TexImage3D(glTexImage3D)
  {
    Current() = this;
    Active() = kind;
#if VTK_MODULE_ENABLE_VTK_glad
    glTexImage2D = TexImage2DOrNot;
    glGetIntegerv = GetIntegervOrLess;
#endif
    switch (kind)
    {
      case ShaderDoesNotCompile:
        glShaderSource = BreakSource;
        break;
      case NoFloatTargets:
        glCheckFramebufferStatus = DenyFloat;
        break;
      case NoMemoryFor3D:
        glTexImage3D = Deny3D;
        break;
      default:
        break;
    }
  }

  ~GLFault()
  {
    glShaderSource = this->ShaderSource;
    glCheckFramebufferStatus = this->CheckFramebufferStatus;
    glTexImage3D = this->TexImage3D;
#if VTK_MODULE_ENABLE_VTK_glad
    glTexImage2D = this->TexImage2D;
    glGetIntegerv = this->GetIntegerv;
#endif
    Active() = None;
    Current() = nullptr;
    while (glGetError() != GL_NO_ERROR) // that were provoked
    {
    }
  }

  static Kinds& Active()
  {
    static Kinds kind = None;
    return kind;
  }

  /// Whether a 2D texture of this format cannot be allocated.
  static bool Denies2D(GLint format)
  {
    return (Active() == NoMemoryFor2D && format == GL_RGBA32F) ||
      (Active() == NoMemoryForDepth && format == GL_DEPTH_COMPONENT32F);
  }

  static constexpr GLint Limit3D = 16;

  /// Changes the answer to glGetIntegerv.
  static void Answer(GLenum name, GLint* value)
  {
    if (name == GL_MAX_3D_TEXTURE_SIZE)
    {
      *value = Active() == NoTextures3D ? 0 : Active() == SmallTextures3D ? Limit3D : *value;
    }
  }

private:
  GLFault(const GLFault&) = delete;
  void operator=(const GLFault&) = delete;

  static GLFault*& Current()
  {
    static GLFault* current = nullptr;
    return current;
  }

  static void GLAPIENTRY BreakSource(GLuint shader, GLsizei, const GLchar* const*, const GLint*)
  {
    const GLchar* text = "#error this compiler is broken on purpose\n";
    Current()->ShaderSource(shader, 1, &text, nullptr);
  }

  static GLenum GLAPIENTRY DenyFloat(GLenum target)
  {
    GLint type = GL_NONE;
    glGetFramebufferAttachmentParameteriv(
      target, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type == GL_TEXTURE)
    {
      glGetFramebufferAttachmentParameteriv(
        target, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, &type);
    }
    return type == GL_FLOAT ? GL_FRAMEBUFFER_UNSUPPORTED
                            : Current()->CheckFramebufferStatus(target);
  }

  /// An error is raised the only way that OpenGL offers: by a call that is wrong.
  static void GLAPIENTRY Deny3D(GLenum, GLint level, GLint format, GLsizei w, GLsizei h, GLsizei d,
    GLint border, GLenum pixels, GLenum type, const void* data)
  {
    Current()->TexImage3D(GL_NONE, level, format, w, h, d, border, pixels, type, data);
  }

#if VTK_MODULE_ENABLE_VTK_glad
  static void GLAPIENTRY TexImage2DOrNot(GLenum target, GLint level, GLint format, GLsizei w,
    GLsizei h, GLint border, GLenum pixels, GLenum type, const void* data)
  {
    Current()->TexImage2D(
      Denies2D(format) ? GLenum(GL_NONE) : target, level, format, w, h, border, pixels, type, data);
  }

  static void GLAPIENTRY GetIntegervOrLess(GLenum name, GLint* value)
  {
    Current()->GetIntegerv(name, value);
    Answer(name, value);
  }

  decltype(glTexImage2D) TexImage2D = glTexImage2D;
  decltype(glGetIntegerv) GetIntegerv = glGetIntegerv;
#endif
  decltype(glShaderSource) ShaderSource;
  decltype(glCheckFramebufferStatus) CheckFramebufferStatus;
  decltype(glTexImage3D) TexImage3D;
};
}

#endif
