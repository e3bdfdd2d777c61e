// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumLightRays
 * @brief Optical depth from any light at every lattice point, in O(N^3), along light-aligned rays.
 *
 * The lattice points are shared out between up to six pyramids with their apex at the light, one for
 * each axis and sign, by the axis along which the point is furthest from the light. A pyramid is
 * crossed by a regular grid of rays in slope space. Each ray carries its optical depth from lattice
 * plane to lattice plane, exactly for trilinear values (two-point Gauss-Legendre sums between all
 * crossings), so that lateral interpolation within a plane, by four-point Lagrange polynomials, is
 * the only error and does not add up along the ray. Third differences of the optical depths tell
 * where that error may matter: behind edges that the light grazes, and in faces that it grazes. A
 * directional light has one pyramid, its rays parallel.
 *
 * Interpolation uses rays that are inside the box, or left it just before; they carry on through the
 * values on its faces, held constant outwards. Where a ray around a point has not entered the box yet,
 * the point gets a ray of its own too.
 */
#ifndef vtkMediumLightRays_h
#define vtkMediumLightRays_h

#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumLightRays
{
public:
  /// Writes the optical depths from `light` at the lattice points of `grid`. `density` is the number
  /// of rays a lattice step along each lateral axis, where the pyramid is widest. `reach` is as in
  /// vtkMediumLightStencil::Apply; points that a spot light does not reach are not promised either.
  /// Where the estimated error of exp(-tau) exceeds `tolerance`, the point gets a ray of its own,
  /// O(N) each; 0 does so everywhere. Returns the number of these.
  static long long Build(const vtkMediumExtinctionGrid& grid, const vtkMediumScene::Light& light,
    double density, double tolerance, int reach, std::vector<float>& tau);
};

#endif
