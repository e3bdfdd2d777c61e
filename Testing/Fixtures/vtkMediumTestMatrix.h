// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumTestMatrix.h
 * @brief Places a volume by its user matrix.
 */
#ifndef vtkMediumTestMatrix_h
#define vtkMediumTestMatrix_h

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkVolume.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace vtkMediumTest
{
inline void SetUserMatrix(vtkVolume* volume, const glm::dmat3& axes, const glm::dvec3& shift)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, axes[column][row]);
    }
    matrix->SetElement(row, 3, shift[row]);
  }
  volume->SetUserMatrix(matrix);
}
}

#endif
