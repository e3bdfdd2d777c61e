// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumAccelerator
 * @brief What lets a frame skip work: bricks and their tiles, and a cache of each light's shadow.
 *
 * Bricks say which part of an eye ray can meet anything; light caches turn a light ray into one look-up.
 * Both are built on the CPU, from the extinction grid, and kept by signature: a camera move rebuilds
 * neither, a light's colour rebuilds neither, a light's pose rebuilds its own cache only.
 *
 * While a light is dragged its cache is built over a lattice of half the points along each axis, which costs
 * a sixteenth; what the other lights have on the fine one is kept for when there is time.
 */
#ifndef vtkMediumAccelerator_h
#define vtkMediumAccelerator_h

#include "vtkMediumBricks.h"
#include "vtkMediumCompatibility.h"
#include "vtkMediumEmptyBricks.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFold.h"
#include "vtkMediumLightCaches.h"
#include "vtkMediumPlan.h"
#include "vtkMediumSignature.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END

class vtkMediumAccelerator
{
public:
  /// Builds and uploads what the plan asks for and what changed. Returns an empty string, or what the
  /// device could not hold.
  std::string Update(
    vtkOpenGLRenderWindow* window, const vtkMediumScene& scene, const vtkMediumPlan& plan);

  /// Projects the bricks to the tiles of a viewport; the scissor is empty if none is in view.
  void ProjectTiles(const vtkMediumScene& scene, const glm::ivec2& viewportSize);
  const glm::ivec4& GetScissor() const { return this->Scissor; }
  /// Bricks that are not empty but were cut away, when they were projected.
  std::size_t GetBricksCutAway() const { return this->BricksCutAway; }

  /// Binds the textures and tells the program where they are.
  void Activate(vtkShaderProgram* program, const vtkMediumPlan& plan);
  void Deactivate();
  /// Gives back the textures of an integrator that is not in use, and light caches that no frame of the plan's
  /// scene can use; `dark`: there are no lights. What they were made from is kept.
  void ReleaseUnread(const vtkMediumPlan& plan, bool dark);
  void ReleaseGraphicsResources(vtkWindow* window);

  /// Since creation.
  int GetBrickBuilds() const { return this->BrickBuilds; }
  int GetLightCacheBuilds() const { return this->Fine.GetBuilds() + this->Coarse.GetBuilds(); }
  int GetLightCacheUploads() const { return this->Fine.GetUploads() + this->Coarse.GetUploads(); }
  const vtkMediumBricks& GetBricks() const { return this->Bricks; }
  vtkTypeInt64 GetBytes() const;

private:
  void UpdateGrid(const vtkMediumScene& scene, const vtkMediumPlan& plan);
  void UploadEmptyBricks();
  std::string UpdateCaches(const vtkMediumScene& scene, const vtkMediumPlan& plan);

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkMediumSignature GridSignature;
  vtkMediumSignature CutSignature; ///< of what was cut away from the grid
  vtkMediumSignature BrickSignature;
  vtkMediumExtinctionGrid Grid;
  vtkMediumBricks Bricks;
  vtkMediumEmptyBricks EmptyBricks;
  vtkMediumFold BrickFold; ///< how the reaches of empty bricks lie in their texture
  vtkMediumLightCaches Fine;
  vtkMediumLightCaches Coarse;        ///< while lights are dragged
  vtkMediumExtinctionGrid CoarseGrid; ///< of Coarse
  bool CoarseGridIsCurrent = false;
  bool UsesCoarse = false; ///< as updated last
  vtkNew<vtkTextureObject> TileTexture;
  vtkNew<vtkTextureObject> EmptyTexture;
  glm::ivec4 Scissor{ 0 };
  std::size_t BricksCutAway = 0;
  std::vector<vtkTextureObject*> Active;
  int BrickBuilds = 0;
};

#endif
