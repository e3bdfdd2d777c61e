// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumPeel
 * @brief A volume's part in VTK's depth peeling: between which layers of translucent geometry it is wanted.
 *
 * Each time that the pass draws the volume it wants two pieces of each ray, one to blend over what lies behind
 * and one under what lies before; see Shaders/vtkMediumPeel.glsl.
 */
#ifndef vtkMediumPeel_h
#define vtkMediumPeel_h

#include "vtkMediumCompatibility.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <glm/vec2.hpp>

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkOpenGLRenderPass;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkVolume;
class vtkWindow;
VTK_ABI_NAMESPACE_END
class vtkMediumProgram;

class vtkMediumPeel
{
public:
  static constexpr int Pieces = 2;

  /// The pass that peels the volume at this moment, and for which mapper; null if none does.
  struct Caller
  {
    vtkOpenGLRenderPass* Pass = nullptr;
    vtkAbstractMapper* Mapper = nullptr;
    vtkVolume* Volume = nullptr;

    explicit operator bool() const { return this->Pass != nullptr; }
  };
  static Caller FindCaller(vtkAbstractMapper* mapper, vtkVolume* volume);

  /// Notes where the pieces of each pixel's ray begin and end. Returns an empty string, or what the device
  /// could not do.
  std::string Note(const Caller& caller, vtkOpenGLRenderWindow* window, vtkMediumProgram& programs,
    const glm::ivec2& size);
  /// What was noted, as the depths that end the rays of a frame.
  vtkTextureObject* GetEnds(int piece) { return this->Ends[piece]; }

  /// Gives the pass the radiance of the pieces. Returns as Note does.
  static std::string HandOver(const Caller& caller, vtkOpenGLRenderWindow* window,
    vtkMediumProgram& programs, const std::array<vtkTextureObject*, Pieces>& radiance);

  vtkTypeInt64 GetBytes() const;
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  static vtkShaderProgram* Use(const Caller& caller, vtkOpenGLRenderWindow* window,
    vtkMediumProgram& programs, const char* defines);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Ends[Pieces];
};

#endif
