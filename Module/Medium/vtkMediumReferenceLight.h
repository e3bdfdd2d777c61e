// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumReferenceLight.h
 * @brief What a light of the scene sends to a point, and where along a ray that is not smooth.
 *
 * Private to the module. All in local units.
 */
#ifndef vtkMediumReferenceLight_h
#define vtkMediumReferenceLight_h

#include "vtkMediumScene.h"

#include <vector>

/// The light that arrives at a point through an empty medium.
struct vtkMediumIncidentLight
{
  glm::dvec3 Irradiance{ 0 };
  glm::dvec3 Direction{ 0 }; ///< unit; the way the light travels
  double Distance = 0;       ///< from the light; infinite for a directional one
};

vtkMediumIncidentLight vtkMediumReferenceLight(
  const vtkMediumScene::Light& light, const glm::dvec3& position);

/// The most that it sends to any point.
glm::dvec3 vtkMediumBrightest(const vtkMediumScene::Light& light);

/// Appends where along origin + t direction (unit) the light is nearest, which is where its
/// intensity and its angle change fastest, and where the ray enters and leaves a spot light's cone.
void vtkMediumAppendLightCuts(const vtkMediumScene::Light& light, const glm::dvec3& origin,
  const glm::dvec3& direction, std::vector<double>& cuts);

#endif
