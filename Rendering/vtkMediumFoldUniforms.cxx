// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumFoldUniforms.h"

#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
void vtkMediumSetLatticeUniforms(vtkShaderProgram* program, const vtkMediumLatticeUniforms& names,
  const vtkMediumFold& fold, const glm::dvec3& first, const glm::dvec3& last, bool folded)
{
  // To lattice coordinates, or to those of the texture, whose texel centres lie half a texel inside.
  const glm::dvec3 size(folded ? glm::ivec3(1) : fold.GetDimensions());
  const glm::vec3 scale((last - first) / size);
  const glm::vec3 bias((first + (folded ? 0.0 : 0.5)) / size);
  program->SetUniform3f(names.Scale.c_str(), &scale[0]);
  program->SetUniform3f(names.Bias.c_str(), &bias[0]);
  if (folded)
  {
    vtkMediumSetFoldUniforms(program, names.Fold, fold);
  }
}

//------------------------------------------------------------------------------
void vtkMediumSetFoldUniforms(
  vtkShaderProgram* program, const std::string& name, const vtkMediumFold& fold)
{
  auto set = [&](const char* member, const glm::ivec3& numbers) {
    const glm::vec3 values(numbers);
    program->SetUniform3f((name + member).c_str(), &values[0]);
  };
  set(".last", fold.GetDimensions() - 1);
  set(".blocks", fold.GetBlocks());
  set(".stride", glm::max(fold.GetStride(), 1));
  set(".extent", fold.GetExtent());
  set(".beside", fold.GetBeside());
}
