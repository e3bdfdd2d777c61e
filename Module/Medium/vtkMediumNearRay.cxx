// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumNearRay.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
// The volume lies within half a unit of the local origin.
constexpr double Near = 2;
constexpr double Reach = 0.5 + 1e-9;

// The direction's last digit leaves a foot point that is off by 1e-16 of the way to it. What the second
// foot point leaves along the ray is nothing, and what both leave across it is the ray's own.
constexpr int FootPoints = 2;
}

//------------------------------------------------------------------------------
vtkMediumNearRay::vtkMediumNearRay(
  const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end)
  : Origin(origin)
  , Direction(direction)
  , Begin(std::max(begin, 0.0))
  , End(end)
{
  if (glm::dot(origin, origin) <= Near * Near)
  {
    return;
  }
  for (int i = 0; i < FootPoints; ++i)
  {
    const double foot = -glm::dot(this->Origin, direction);
    this->Origin += foot * direction;
    this->Begin -= foot;
    this->End -= foot;
  }
  if (glm::length(this->Origin) > Reach)
  {
    this->End = this->Begin;
  }
}
