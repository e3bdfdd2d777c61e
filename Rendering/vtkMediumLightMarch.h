// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumLightMarch.h
 * @brief Exact optical depths in an extinction grid, one ray at a time.
 *
 * The ray is split where it crosses lattice planes (halfway between them too, where values are
 * nearest or the box ends there). Within a piece trilinear extinction is a cubic in the ray's
 * parameter, for which two-point Gauss-Legendre quadrature is exact, so the result errs by rounding
 * in double only. Slow, O(N) a call: what the caches are measured against.
 */
#ifndef vtkMediumLightMarch_h
#define vtkMediumLightMarch_h

#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

/// Optical depth between two lattice coordinates, counting only what lies inside the box.
VTKPARTICIPATINGMEDIARENDERING_EXPORT double vtkMediumOpticalDepth(
  const vtkMediumExtinctionGrid& grid, const glm::dvec3& from, const glm::dvec3& to);

/// The same without the box: the values on its faces hold outside of it.
VTKPARTICIPATINGMEDIARENDERING_EXPORT double vtkMediumExtendedOpticalDepth(
  const vtkMediumExtinctionGrid& grid, const glm::dvec3& from, const glm::dvec3& to);

/// Optical depth from a light to a lattice coordinate inside the box, for a DensityScale of 1.
VTKPARTICIPATINGMEDIARENDERING_EXPORT double vtkMediumLightOpticalDepth(
  const vtkMediumExtinctionGrid& grid, const vtkMediumScene::Light& light, const glm::dvec3& at);

#endif
