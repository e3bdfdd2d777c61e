// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumUserCode
 * @brief GLSL and uniforms that a user gives to a volume by its vtkShaderProperty.
 *
 * Code replaces a tag at one of a few points of the shaders, see Module/Documentation/shaders.md. All
 * else that a vtkShaderProperty can hold is refused.
 */
#ifndef vtkMediumUserCode_h
#define vtkMediumUserCode_h

#include "vtkMediumCompatibility.h"

#include <map>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLUniforms;
class vtkShaderProgram;
class vtkShaderProperty;
class vtkVolume;
VTK_ABI_NAMESPACE_END

class vtkMediumUserCode
{
public:
  /// The points, by the tags that mark them in the shaders.
  static constexpr const char* Declarations = "//VTK::Medium::Dec";
  static constexpr const char* Coefficients = "//VTK::Medium::Coefficients::Impl";
  static constexpr const char* InScatter = "//VTK::Medium::InScatter::Impl";
  static constexpr const char* Color = "//VTK::Medium::Color::Impl";

  vtkMediumUserCode() = default;
  explicit vtkMediumUserCode(vtkVolume* volume);

  /// Empty, or what the property holds that cannot be honoured.
  std::string Refusal;

  bool IsEmpty() const { return this->Replacements.empty(); }
  /// Whether there is code for a point.
  bool Has(const char* point) const { return this->Replacements.count(point) > 0; }
  /// Of a program of these files: same text, same program. Values of uniforms are not in it.
  std::string GetKey(const std::vector<std::string>& files) const;
  /// Same values, same picture.
  std::vector<double> GetSignature() const;

  /// Puts the code, and the declarations of the uniforms, in the place of their tags.
  void Insert(std::string& shader) const;
  void SetUniforms(vtkShaderProgram* program) const;

private:
  void Gather(vtkShaderProperty* property);
  static std::string CheckUnused(vtkShaderProperty* property);

  std::map<std::string, std::string> Replacements; ///< code by tag
  std::string Uniforms;                            ///< their declarations
  vtkOpenGLUniforms* Values = nullptr;             ///< the volume's
};

#endif
