// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumField.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
bool vtkMediumField::FindRange()
{
  this->Minimum = std::numeric_limits<double>::infinity();
  this->Maximum = -this->Minimum;
  for (int c = 0; c < this->Components; ++c)
  {
    double range[2] = { 1, 0 };
    this->Array->GetFiniteRange(range, this->FirstComponent + c);
    if (range[0] <= range[1])
    {
      this->Minimum = std::min(this->Minimum, range[0]);
      this->Maximum = std::max(this->Maximum, range[1]);
    }
  }
  return this->Minimum <= this->Maximum;
}

//------------------------------------------------------------------------------
double vtkMediumField::GetUnit() const
{
  const double largest = std::max(std::abs(this->Minimum), std::abs(this->Maximum));
  return largest > 0 ? largest : 1;
}

//------------------------------------------------------------------------------
double vtkMediumField::GetValue(int i, int j, int k, int component) const
{
  const vtkIdType tuple =
    i + this->Dimensions.x * (j + static_cast<vtkIdType>(this->Dimensions.y) * k);
  const double value = this->Array->GetComponent(tuple, this->FirstComponent + component);
  if (std::isfinite(value))
  {
    return value;
  }
  return value > 0 ? this->Maximum : this->Minimum;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumField::BoxToLattice(const glm::dvec3& box) const
{
  return this->OnCells ? box * glm::dvec3(this->Dimensions) - 0.5
                       : box * glm::dvec3(this->Dimensions - 1);
}

//------------------------------------------------------------------------------
glm::dvec4 vtkMediumField::Interpolate(const glm::dvec3& box) const
{
  const glm::dvec3 last(this->Dimensions - 1);
  const glm::dvec3 lattice = glm::clamp(this->BoxToLattice(box), glm::dvec3(0), last);
  glm::dvec4 result(0);
  if (!this->Linear)
  {
    const glm::ivec3 nearest(glm::floor(lattice + 0.5));
    for (int c = 0; c < this->Components; ++c)
    {
      result[c] = this->GetValue(nearest.x, nearest.y, nearest.z, c);
    }
    return result;
  }
  const glm::ivec3 lower = glm::min(glm::ivec3(lattice), glm::max(this->Dimensions - 2, 0));
  const glm::dvec3 fraction = lattice - glm::dvec3(lower);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 bit(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const glm::ivec3 at = glm::min(lower + bit, this->Dimensions - 1);
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      weight *= bit[axis] ? fraction[axis] : 1 - fraction[axis];
    }
    for (int c = 0; c < this->Components; ++c)
    {
      result[c] += weight * this->GetValue(at.x, at.y, at.z, c);
    }
  }
  return result;
}
