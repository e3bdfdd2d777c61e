// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosedForms.h
 * @brief The closed forms of Testing/Fixtures, and the rays along which a camera sees them.
 */
#ifndef ClosedForms_h
#define ClosedForms_h

#include "vtkMediumClosedForms.h"
#include "vtkMediumTestScene.h"

namespace vtkMediumTest
{
/// The ray through a pixel's centre.
inline Ray EyeRay(vtkCamera* camera, int pixels, int x, int y)
{
  glm::dvec3 eye, forward, up;
  camera->GetPosition(&eye[0]);
  camera->GetDirectionOfProjection(&forward[0]);
  camera->GetViewUp(&up[0]);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
  up = glm::cross(right, forward);
  const double u = (2 * x + 1.0) / pixels - 1, v = (2 * y + 1.0) / pixels - 1;
  const double nearest = camera->GetClippingRange()[0];
  if (camera->GetParallelProjection())
  {
    const double half = camera->GetParallelScale();
    return { eye + half * (u * right + v * up) + nearest * forward, forward, 0 };
  }
  const double half = std::tan(camera->GetViewAngle() * Pi / 360);
  const glm::dvec3 direction = forward + half * (u * right + v * up);
  return { eye, glm::normalize(direction), nearest * glm::length(direction) };
}

/// Calls visit(x, y, ray) for every pixel.
inline void ForEachPixel(Scene& scene, const std::function<void(int, int, const Ray&)>& visit)
{
  for (int y = 0; y < scene.Pixels; ++y)
  {
    for (int x = 0; x < scene.Pixels; ++x)
    {
      visit(x, y, EyeRay(scene.Camera, scene.Pixels, x, y));
    }
  }
}
}

#endif
