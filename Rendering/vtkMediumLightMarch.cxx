// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightMarch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

//------------------------------------------------------------------------------
double vtkMediumExtendedOpticalDepth(
  const vtkMediumExtinctionGrid& grid, const glm::dvec3& from, const glm::dvec3& to)
{
  const glm::dvec3 step = to - from;
  const double planes = grid.IsLinear() && !grid.IsOnCells() ? 1 : 2; // per lattice unit
  std::vector<double> splits{ 0, 1 };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = from[axis] * planes;
    const double b = to[axis] * planes;
    for (double plane = std::ceil(std::min(a, b)); plane <= std::max(a, b) && step[axis] != 0;
         ++plane)
    {
      splits.push_back(std::min(std::max((plane / planes - from[axis]) / step[axis], 0.0), 1.0));
    }
  }
  std::sort(splits.begin(), splits.end());

  const double gauss = 0.57735026918962576451; // 1 / sqrt(3)
  double sum = 0;
  for (std::size_t i = 1; i < splits.size(); ++i)
  {
    const double middle = 0.5 * (splits[i - 1] + splits[i]);
    const double half = 0.5 * (splits[i] - splits[i - 1]);
    sum += half *
      (grid.Interpolate(from + (middle - half * gauss) * step) +
        grid.Interpolate(from + (middle + half * gauss) * step));
  }
  return sum * glm::length(grid.GetLatticeToLocalAxes() * step);
}

//------------------------------------------------------------------------------
double vtkMediumOpticalDepth(
  const vtkMediumExtinctionGrid& grid, const glm::dvec3& from, const glm::dvec3& to)
{
  const glm::dvec3 lower = grid.GetLower(), upper = grid.GetUpper(), step = to - from;
  double first = 0, last = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (step[axis] == 0)
    {
      if (from[axis] < lower[axis] || from[axis] > upper[axis])
      {
        return 0;
      }
      continue;
    }
    const double a = (lower[axis] - from[axis]) / step[axis];
    const double b = (upper[axis] - from[axis]) / step[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (!(first < last))
  {
    return 0;
  }
  return vtkMediumExtendedOpticalDepth(grid, from + first * step, from + last * step);
}

//------------------------------------------------------------------------------
double vtkMediumLightOpticalDepth(
  const vtkMediumExtinctionGrid& grid, const vtkMediumScene::Light& light, const glm::dvec3& at)
{
  if (light.Type == vtkMediumScene::Light::Directional)
  {
    // The diagonal of the box is 1 local unit: 2 units ahead every ray has left it.
    return vtkMediumOpticalDepth(
      grid, at, at - grid.GetLocalToLatticeAxes() * (2.0 * light.Direction));
  }
  return vtkMediumOpticalDepth(grid, at, grid.LocalToLattice(light.Position));
}
