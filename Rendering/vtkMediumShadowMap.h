// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumShadowMap
 * @brief The depth of opaque geometry as each light sees it, over the volume, in one texture.
 *
 * VTK's props draw themselves into it, through a camera that stands at the light. Geometry between a light
 * and the volume is clamped to the nearest depth, so that depths resolve the volume alone. A view is drawn
 * anew when the geometry, its light's place or the volume's place changes, and not when the eye moves.
 */
#ifndef vtkMediumShadowMap_h
#define vtkMediumShadowMap_h

#include "vtkMediumCompatibility.h"
#include "vtkMediumPlan.h"
#include "vtkMediumShadowViews.h"
#include "vtkMediumSignature.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <glm/vec2.hpp>

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END

class vtkMediumShadowMap
{
public:
  /// Draws what changed, where the plan asks for shadows. Returns an empty string, or what the device could
  /// not do.
  std::string Update(
    vtkOpenGLRenderWindow* window, const vtkMediumScene& scene, const vtkMediumPlan& plan);
  /// False where the window's abort stopped the drawing; the next Update goes on.
  bool IsComplete() const { return this->Complete; }

  /// Binds the textures and tells the program where they are.
  void Activate(vtkShaderProgram* program, const vtkMediumPlan& plan);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Views drawn since creation.
  int GetBuilds() const { return this->Builds; }
  vtkTypeInt64 GetBytes() const;

private:
  using View = vtkMediumShadowViews::View;

  std::string Fit(std::size_t views, int pixels);
  bool Allocate(const glm::ivec2& tiles, int pixels);
  glm::ivec2 CornerOf(std::size_t view) const; ///< in the texture, texels
  void DrawChanged(const vtkMediumScene& scene, const std::vector<View>& views);
  void DrawView(const vtkMediumScene& scene, const View& view, const glm::ivec2& corner);
  bool UploadViews(const std::vector<View>& views, const std::vector<int>& faces);

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkNew<vtkTextureObject> Map;
  vtkNew<vtkTextureObject> ViewTable;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::vector<vtkMediumSignature> Drawn; ///< what each view of the texture shows
  std::vector<float> ViewTexels;         ///< as uploaded
  glm::ivec2 Tiles{ 0 };                 ///< views along each axis of the texture
  int Pixels = 0;                        ///< along the edge of a view
  bool Complete = true;
  bool Active = false;
  int Builds = 0;
};

#endif
