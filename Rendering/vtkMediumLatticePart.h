// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumLatticePart.h
 * @brief A box of lattice points.
 */
#ifndef vtkMediumLatticePart_h
#define vtkMediumLatticePart_h

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <cstddef>

/// The points [Begin, End) along each axis.
struct vtkMediumLatticePart
{
  glm::ivec3 Begin{ 0 };
  glm::ivec3 End{ 0 };

  glm::ivec3 GetSize() const { return this->End - this->Begin; }
  bool IsEmpty() const
  {
    const glm::ivec3 size = this->GetSize();
    return size.x <= 0 || size.y <= 0 || size.z <= 0;
  }
  std::size_t GetNumberOfPoints() const
  {
    const glm::ivec3 size = this->GetSize();
    return this->IsEmpty() ? 0 : static_cast<std::size_t>(size.x) * size.y * size.z;
  }

  /// With so many points more on every side, as far as a lattice has them.
  vtkMediumLatticePart Grow(int points, const glm::ivec3& dimensions) const
  {
    return { glm::max(this->Begin - points, 0), glm::min(this->End + points, dimensions) };
  }
};

#endif
