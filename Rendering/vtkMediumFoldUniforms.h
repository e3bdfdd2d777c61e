// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumFoldUniforms.h
 * @brief How a lattice lies in its texture, as shaders read it.
 *
 * Private to the module.
 */
#ifndef vtkMediumFoldUniforms_h
#define vtkMediumFoldUniforms_h

#include "vtkMediumCompatibility.h"
#include "vtkMediumFold.h"

#include <glm/vec3.hpp>

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

/// The names of the uniforms of a lattice.
struct vtkMediumLatticeUniforms
{
  std::string Scale, Bias; ///< box to what foldPlace takes
  std::string Fold;
};

/// Sets them; `first` and `last` are the box's corners in lattice coordinates. `folded`: the program is
/// for folded lattices, whether this one is or not.
void vtkMediumSetLatticeUniforms(vtkShaderProgram* program, const vtkMediumLatticeUniforms& names,
  const vtkMediumFold& fold, const glm::dvec3& first, const glm::dvec3& last, bool folded);

/// Those of the fold alone.
VTKPARTICIPATINGMEDIARENDERING_EXPORT void vtkMediumSetFoldUniforms(
  vtkShaderProgram* program, const std::string& name, const vtkMediumFold& fold);

#endif
