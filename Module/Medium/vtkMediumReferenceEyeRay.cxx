// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumReferenceEyeRay.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
// The volume lies within half a unit of its centre.
constexpr double NextToVolume = 1;
}

//------------------------------------------------------------------------------
vtkMediumReferenceEyeRay vtkMediumReferenceEyeRayOf(
  const vtkMediumScene::View& eye, const int size[2], int i, int j)
{
  const double x = 2 * (i + 0.5) / size[0] - 1;
  const double y = 2 * (j + 0.5) / size[1] - 1;
  vtkMediumReferenceEyeRay ray;
  ray.Origin = eye.Origin + x * eye.OriginX + y * eye.OriginY;
  ray.Direction = glm::normalize(eye.Direction + x * eye.DirectionX + y * eye.DirectionY);
  // The near plane is where clip z = -w.
  const glm::dvec4 nearPlane = eye.ClipZ + eye.ClipW;
  const double height = glm::dot(nearPlane, glm::dvec4(ray.Origin, 1));
  const double slope = glm::dot(glm::dvec3(nearPlane), ray.Direction);
  ray.Begin = slope > 0 ? -height / slope : 0;
  if (eye.Parallel)
  {
    // The origin is the point of the line that is nearest to the volume's centre; let the ray start at
    // the near plane, or next to the volume.
    ray.Origin += std::max(ray.Begin, -NextToVolume) * ray.Direction;
    ray.Begin = 0;
  }
  ray.Begin = std::max(ray.Begin, 0.0);
  return ray;
}
