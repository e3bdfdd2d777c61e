// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumTextures
 * @brief The scene's fields, functions, lights and random numbers on the device.
 *
 * Each texture keeps a signature of what its content depends on and is uploaded only when that
 * changes.
 */
#ifndef vtkMediumTextures_h
#define vtkMediumTextures_h

#include "vtkMediumCompatibility.h"
#include "vtkMediumPlan.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END

class vtkMediumTextures
{
public:
  /// Uploads what changed. Returns an empty string, or what the device could not hold.
  std::string Update(
    vtkOpenGLRenderWindow* window, const vtkMediumScene& scene, const vtkMediumPlan& plan);

  /// Binds the textures and tells the program where they are.
  void Activate(vtkShaderProgram* program, const vtkMediumPlan& plan);
  void Deactivate();

  /// Gives back the fields that the plan does not read, and the table of no lights.
  void ReleaseUnread(const vtkMediumPlan& plan);
  void ReleaseGraphicsResources(vtkWindow* window);

  int GetUploads() const { return this->Uploads; }
  vtkTypeInt64 GetBytes() const;
  /// Voxels that were NaN or infinite in the fields uploaded by the last Update.
  vtkTypeInt64 GetNonFinite() const { return this->NonFinite; }

private:
  struct FieldTexture
  {
    vtkDataArray* Array = nullptr;
    vtkMTimeType Time = 0;
    int FirstComponent = 0;
    int Components = 0;
    vtkMediumFold Fold;
    vtkTypeInt64 Bytes = 0;
    vtkNew<vtkTextureObject> Texture;
  };

  bool UpdateField(FieldTexture& texture, const vtkMediumField& field, const vtkMediumFold& fold);
  bool UploadField(
    vtkTextureObject* texture, const vtkMediumField& field, const vtkMediumFold& fold);
  void UpdateFunctions(const std::vector<vtkMediumFunction>& functions, bool integrals);
  void UpdateLights(const std::vector<vtkMediumScene::Light>& lights);
  void UpdatePhase(const std::vector<double>& table);
  void UpdateJitter();
  /// A texture of RGBA32F or R32F texels.
  void UploadTable(vtkTextureObject* texture, int width, int height, int components,
    const std::vector<float>& texels, bool linear);

  std::vector<std::unique_ptr<FieldTexture>> Fields;
  std::vector<vtkMediumFunction> Functions; ///< as uploaded
  std::vector<float> LightTexels;           ///< as uploaded
  std::vector<float> PhaseTexels;           ///< as uploaded
  vtkNew<vtkTextureObject> FunctionTable;
  vtkNew<vtkTextureObject> PrimitiveTable; ///< the functions' integrals
  vtkNew<vtkTextureObject> LightTable;
  vtkNew<vtkTextureObject> PhaseTable;
  vtkNew<vtkTextureObject> JitterTable;
  std::vector<vtkTextureObject*> Active;
  vtkOpenGLRenderWindow* Window = nullptr;
  int Uploads = 0;
  bool TableFailed = false; ///< whether a table could not be allocated in the last Update
  vtkTypeInt64 NonFinite = 0;
};

#endif
