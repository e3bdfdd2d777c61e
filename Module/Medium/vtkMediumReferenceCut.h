// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumReferenceCut.h
 * @brief What of a ray is left by clipping and cropping, and where the shadow of the rest has edges.
 *
 * Private to the module. All in local units.
 */
#ifndef vtkMediumReferenceCut_h
#define vtkMediumReferenceCut_h

#include "vtkMediumScene.h"

#include <glm/vec2.hpp>

#include <vector>

/// The parts of origin + t direction, begin <= t <= end, that are kept, in order.
std::vector<glm::dvec2> vtkMediumKeptParts(const vtkMediumCut& cut, const glm::dvec3& origin,
  const glm::dvec3& direction, double begin, double end);

/// Appends where along an eye ray its light ray sweeps over a line in which a plane of the cut meets another
/// one or a face of the box, for there the optical depth to the light bends.
void vtkMediumAppendCutEdges(const vtkMediumScene& scene, const vtkMediumScene::Light& light,
  const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
  std::vector<double>& cuts);

#endif
