// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightRays.h"

#include "vtkMediumLightPyramid.h"
#include "vtkMediumLightStencil.h"
#include "vtkMediumOccupiedRows.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
long long vtkMediumLightRays::Build(const vtkMediumExtinctionGrid& grid,
  const vtkMediumScene::Light& light, double density, double tolerance, int reach,
  std::vector<float>& tau)
{
  tau.assign(grid.GetValues().size(), vtkMediumLightStencil::Unknown);
  if (!(grid.GetMaximum() > 0))
  {
    std::fill(tau.begin(), tau.end(), 0.0f);
    return 0;
  }
  const vtkMediumOccupiedRows rows(grid, reach, false);
  const vtkMediumCellSums sums(grid);
  if (light.Type == vtkMediumScene::Light::Directional)
  {
    const glm::dvec3 direction = grid.GetLocalToLatticeAxes() * light.Direction;
    const glm::dvec3 size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    vtkMediumLightPyramid pyramid(grid, sums, axis, direction[axis] > 0 ? 1 : -1);
    pyramid.SetDirection(direction, density);
    pyramid.SetTolerance(tolerance);
    pyramid.March(rows, tau);
    return pyramid.GetMarches();
  }
  long long marches = 0;
  const glm::dvec3 apex = grid.LocalToLattice(light.Position);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int sign : { -1, 1 })
    {
      vtkMediumLightPyramid pyramid(grid, sums, axis, sign);
      if (pyramid.SetApex(apex, density))
      {
        if (light.Type == vtkMediumScene::Light::Spot)
        {
          pyramid.SetCone(light.Direction, light.CosCone);
        }
        pyramid.SetTolerance(tolerance);
        pyramid.March(rows, tau);
        marches += pyramid.GetMarches();
      }
    }
  }
  return marches;
}
