// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumLightCaches
 * @brief The caches of a scene's lights over one lattice, and the textures that hold them.
 *
 * A light whose pose changed gets a cache anew; the others keep theirs.
 */
#ifndef vtkMediumLightCaches_h
#define vtkMediumLightCaches_h

#include "vtkMediumCompatibility.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFold.h"
#include "vtkMediumLatticePart.h"
#include "vtkMediumLightCache.h"
#include "vtkMediumPlan.h"

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

class vtkMediumLightCaches
{
public:
  /// Whether every light that the plan caches has a cache of its pose.
  bool AreBuilt(const vtkMediumScene& scene, const vtkMediumPlan& plan) const;

  /// Builds and uploads what changed. Returns an empty string, or what the device could not hold.
  std::string Update(vtkOpenGLRenderWindow* window, const vtkMediumExtinctionGrid& grid,
    const vtkMediumScene& scene, const vtkMediumPlan& plan);

  /// Forgets all caches, of another lattice or other values.
  void Forget() { this->Lights.clear(); }

  /// Binds the textures and tells the program where they are; adds them to those that are active.
  void Activate(vtkShaderProgram* program, const vtkMediumExtinctionGrid& grid,
    const vtkMediumPlan& plan, std::vector<vtkTextureObject*>& active) const;

  /// Gives the textures back; what they were made from is kept.
  void ReleaseTextures(vtkWindow* window);

  /// Since creation.
  int GetBuilds() const { return this->Builds; }
  int GetUploads() const { return this->Uploads; }
  vtkTypeInt64 GetBytes() const;

private:
  struct CachedLight
  {
    vtkMediumLightCache Cache;
    vtkMediumScene::Light Pose;
  };

  bool HasCache(int number, const vtkMediumScene::Light& pose) const;
  bool BuildLight(
    int number, const vtkMediumExtinctionGrid& grid, const vtkMediumScene::Light& pose);
  bool UploadGroup(vtkOpenGLRenderWindow* window, int group, const vtkMediumPlan& plan);

  std::vector<std::unique_ptr<CachedLight>> Lights;
  std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
  vtkMediumLatticePart Part; ///< of the lattice; beyond it nothing is looked up
  vtkMediumFold Fold;        ///< how it lies in the textures
  ///@{
  /// As uploaded.
  int CachedLights = 0;
  bool Roughness = false;
  double DensityScale = -1;
  ///@}
  int Builds = 0;
  int Uploads = 0;
};

#endif
