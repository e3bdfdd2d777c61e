// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumAccelerator
 * @brief What lets a frame skip work: bricks and their tiles, and a cache of each light's shadow.
 *
 * Bricks say which part of an eye ray can meet anything; light caches turn a light ray into one look-up.
 * Both are built on the CPU, from the extinction grid, and kept by signature: a camera move rebuilds
 * neither, a light's colour rebuilds neither, a light's pose rebuilds its own cache only.
 */
#ifndef vtkMediumAccelerator_h
#define vtkMediumAccelerator_h

#include "vtkMediumBricks.h"
#include "vtkMediumCompatibility.h"
#include "vtkMediumEmptyBricks.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFold.h"
#include "vtkMediumLightCache.h"
#include "vtkMediumPlan.h"
#include "vtkMediumSignature.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <memory>
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
  int GetLightCacheBuilds() const { return this->LightCacheBuilds; }
  int GetLightCacheUploads() const { return this->LightCacheUploads; }
  const vtkMediumBricks& GetBricks() const { return this->Bricks; }
  vtkTypeInt64 GetBytes() const;

private:
  struct CachedLight
  {
    vtkMediumLightCache Cache;
    vtkMediumScene::Light Pose;
    bool Quick = false; ///< built by slabs, to be built anew when there is time
  };

  void UpdateGrid(const vtkMediumScene& scene, const vtkMediumPlan& plan);
  void UploadEmptyBricks();
  bool UpdateCaches(const vtkMediumScene& scene, const vtkMediumPlan& plan);
  bool UploadGroup(int group, const vtkMediumPlan& plan);
  void ReleaseCaches(vtkWindow* window);

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkMediumSignature GridSignature;
  vtkMediumSignature CutSignature; ///< of what was cut away from the grid
  vtkMediumSignature BrickSignature;
  vtkMediumExtinctionGrid Grid;
  vtkMediumBricks Bricks;
  vtkMediumEmptyBricks EmptyBricks;
  vtkMediumLatticePart CachedPart; ///< of the lattice; beyond it nothing is looked up
  vtkMediumFold GridFold;          ///< how light caches lie in their textures
  vtkMediumFold BrickFold;         ///< and the reaches of empty bricks
  std::vector<std::unique_ptr<CachedLight>> Lights;
  std::vector<vtkSmartPointer<vtkTextureObject>> CacheTextures;
  int CachedLights = 0;           ///< as uploaded
  bool CachedRoughness = false;   ///< as uploaded
  double CachedDensityScale = -1; ///< as uploaded
  vtkNew<vtkTextureObject> TileTexture;
  vtkNew<vtkTextureObject> EmptyTexture;
  glm::ivec4 Scissor{ 0 };
  std::size_t BricksCutAway = 0;
  std::vector<vtkTextureObject*> Active;
  int BrickBuilds = 0;
  int LightCacheBuilds = 0;
  int LightCacheUploads = 0;
};

#endif
