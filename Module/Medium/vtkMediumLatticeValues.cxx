// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLatticeValues.h"

#include "vtkSMPTools.h"

//------------------------------------------------------------------------------
void vtkMediumLatticeValues::Update(const vtkMediumField& field)
{
  const vtkMediumLattice lattice(field);
  const vtkMTimeType time = field.Array->GetMTime();
  if (this->Array == field.Array && this->ArrayTime == time && this->Lattice == lattice &&
    this->FirstComponent == field.FirstComponent && this->Components == field.Components &&
    this->Minimum == field.Minimum && this->Maximum == field.Maximum)
  {
    return;
  }
  this->Array = field.Array;
  this->ArrayTime = time;
  this->Lattice = lattice;
  this->FirstComponent = field.FirstComponent;
  this->Components = field.Components;
  this->Minimum = field.Minimum;
  this->Maximum = field.Maximum;

  const glm::ivec3 size = field.Dimensions;
  const std::size_t slice = static_cast<std::size_t>(size.x) * size.y * field.Components;
  const bool exactInFloat =
    field.Array->GetDataType() == VTK_FLOAT || field.Array->GetDataTypeSize() <= 2;
  this->Floats.assign(exactInFloat ? slice * size.z : 0, 0);
  this->Doubles.assign(exactInFloat ? 0 : slice * size.z, 0);
  vtkSMPTools::For(0, size.z, [&](vtkIdType first, vtkIdType last) {
    std::size_t index = slice * first;
    for (int k = static_cast<int>(first); k < last; ++k)
    {
      for (int j = 0; j < size.y; ++j)
      {
        for (int i = 0; i < size.x; ++i)
        {
          for (int c = 0; c < field.Components; ++c, ++index)
          {
            const double value = field.GetValue(i, j, k, c);
            exactInFloat ? void(this->Floats[index] = static_cast<float>(value))
                         : void(this->Doubles[index] = value);
          }
        }
      }
    }
  });
}

//------------------------------------------------------------------------------
void vtkMediumLatticeValues::GetCorners(
  const glm::ivec3& cell, int component, double corners[8]) const
{
  const glm::ivec3 last = this->Lattice.Dimensions - 1;
  const glm::ivec3 lower = glm::clamp(cell, glm::ivec3(0), last);
  const std::size_t strideX = this->Components;
  const std::size_t strideY = strideX * this->Lattice.Dimensions.x;
  const std::size_t strideZ = strideY * this->Lattice.Dimensions.y;
  const std::size_t base = component + lower.x * strideX + lower.y * strideY + lower.z * strideZ;
  if (!this->Lattice.Linear)
  {
    corners[0] = this->Get(base);
    return;
  }
  const glm::ivec3 upper = glm::clamp(cell + 1, glm::ivec3(0), last);
  const std::size_t x = (upper.x - lower.x) * strideX;
  const std::size_t y = (upper.y - lower.y) * strideY;
  const std::size_t z = (upper.z - lower.z) * strideZ;
  const auto load = [&](const auto* values) {
    corners[0] = values[0];
    corners[1] = values[x];
    corners[2] = values[y];
    corners[3] = values[x + y];
    corners[4] = values[z];
    corners[5] = values[z + x];
    corners[6] = values[z + y];
    corners[7] = values[z + x + y];
  };
  this->Floats.empty() ? load(this->Doubles.data() + base) : load(this->Floats.data() + base);
}
