// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumProgram
 * @brief The shader programs of a window: assembled from files, compiled once for each structure.
 */
#ifndef vtkMediumProgram_h
#define vtkMediumProgram_h

#include "vtkMediumCompatibility.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END
class vtkMediumUserCode;

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumProgram
{
public:
  vtkMediumProgram();
  ~vtkMediumProgram();

  /// The text of a shader: VTK's tags, the definitions, then the files in order. A file is named
  /// without its prefix "vtkMedium" and its suffix; a name that does not exist is an empty text.
  static std::string Assemble(const std::vector<std::string>& files, const std::string& defines);

  /// Makes the program of these files and definitions current, compiling it if it is new. Null if it
  /// does not compile; then VTK has reported the compiler's words.
  /// With code of the user, if there is any, in its places.
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window, const std::vector<std::string>& files,
    const std::string& defines, const vtkMediumUserCode* code = nullptr);

  /// The same with a whole text.
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window, const std::string& text);

  /// Draws the full viewport with the program last made current.
  void Draw();

  /// Programs compiled since creation, and the milliseconds that this took since the last reset.
  int GetCompiles() const { return this->Compiles; }
  double GetCompileMilliseconds() const { return this->CompileMilliseconds; }

  void ResetCompileMilliseconds() { this->CompileMilliseconds = 0; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Makes the program of that key current; `assemble` writes the text of a new one.
  vtkShaderProgram* UseKey(vtkOpenGLRenderWindow* window, const std::string& key,
    const std::function<std::string()>& assemble);

  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Quads;
  vtkOpenGLQuadHelper* Current = nullptr;
  int Compiles = 0;
  double CompileMilliseconds = 0;
};

#endif
