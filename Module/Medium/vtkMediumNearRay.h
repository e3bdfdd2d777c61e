// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumNearRay.h
 * @brief A part of a ray, counted from next to the volume however far away the ray begins.
 *
 * Private to the module. All in local units.
 */
#ifndef vtkMediumNearRay_h
#define vtkMediumNearRay_h

#include "vtkMediumScene.h"

struct vtkMediumNearRay
{
  glm::dvec3 Origin;    ///< as given, or the ray's nearest point to the volume's centre
  glm::dvec3 Direction; ///< unit
  double Begin, End;    ///< from Origin on; empty where the ray passes the volume by

  /// Of origin + t direction (unit) the part with t >= 0 and begin <= t <= end. An origin near the volume
  /// stays as it is. From one that is n of the volume's diagonals away a ray meets the volume within n
  /// roundings of a double, for its direction has no more digits.
  vtkMediumNearRay(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end);
};

#endif
