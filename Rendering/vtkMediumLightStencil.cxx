// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightStencil.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace
{
//------------------------------------------------------------------------------
// The basis function of the lattice value at 0 along one axis, at a distance `beyond` along the ray.
// Where that value is on the exit face, only what lies inside the box counts.
double Basis(double beyond, bool linear, bool onCells, bool atExit)
{
  if (atExit && beyond > 0)
  {
    return onCells && beyond < 0.5 ? 1 : 0;
  }
  return linear ? std::max(1 - std::abs(beyond), 0.0) : std::abs(beyond) < 0.5 ? 1 : 0;
}

//------------------------------------------------------------------------------
// Ray parameters, in order, where the ray from the origin along `step` crosses lattice planes (and
// the planes halfway between, for two planes a unit), up to `last`.
std::vector<double> Crossings(const glm::dvec3& step, int planes, double last)
{
  std::vector<double> crossings{ 0, last };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = step[axis] != 0 ? 1 / (planes * std::abs(step[axis])) : last;
    for (int i = 1; i * spacing < last; ++i)
    {
      crossings.push_back(i * spacing);
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}
}

//------------------------------------------------------------------------------
void vtkMediumLightStencil::Build(const vtkMediumExtinctionGrid& grid, const glm::dvec3& direction)
{
  glm::dvec3 step = -(grid.GetLocalToLatticeAxes() * direction); // lattice steps a local unit
  const double largest = std::max({ std::abs(step.x), std::abs(step.y), std::abs(step.z) });
  const glm::ivec3 n = grid.GetDimensions();
  double last = 1e300;
  for (int axis = 0; axis < 3; ++axis)
  {
    // A ray that drifts by less than 1e-9 of a cell in a cell is parallel; otherwise the points on
    // one face would see the light and those on the other not, by the rounding of a cosine.
    step[axis] = std::abs(step[axis]) < 1e-9 * largest ? 0 : step[axis];
    this->ExitPlane[axis] = step[axis] > 0 ? n[axis] - 1 : step[axis] < 0 ? 0 : -1;
    if (step[axis] != 0)
    {
      last = std::min(last, (n[axis] - (grid.IsOnCells() ? 0.5 : 1)) / std::abs(step[axis]));
    }
  }
  this->StepYZ = glm::dvec2(step.y, step.z);

  this->SumWeights(grid, step, last);
}

//------------------------------------------------------------------------------
void vtkMediumLightStencil::SumWeights(
  const vtkMediumExtinctionGrid& grid, const glm::dvec3& step, double last)
{
  const glm::ivec3 n = grid.GetDimensions();
  const int planes = grid.IsLinear() && !grid.IsOnCells() ? 1 : 2;
  const std::vector<double> crossings = Crossings(step, planes, last);
  std::map<std::array<int, 3>, std::array<double, 8>> weights; // by z, y, x
  for (std::size_t i = 1; i < crossings.size(); ++i)
  {
    const double middle = 0.5 * (crossings[i - 1] + crossings[i]);
    const double half = 0.5 * (crossings[i] - crossings[i - 1]);
    const glm::ivec3 cell(glm::floor(step * middle));
    for (double node : { -0.57735026918962576451, 0.57735026918962576451 })
    {
      const glm::dvec3 at = step * (middle + half * node);
      for (int corner = 0; corner < 8 && half > 0; ++corner)
      {
        const glm::ivec3 offset = cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        double basis[3][2];
        for (int axis = 0; axis < 3; ++axis)
        {
          const double beyond = (at[axis] - offset[axis]) * (step[axis] < 0 ? -1 : 1);
          for (int exits = 0; exits < 2; ++exits)
          {
            basis[axis][exits] =
              Basis(beyond, grid.IsLinear(), grid.IsOnCells(), exits && step[axis] != 0);
          }
        }
        std::array<double, 8>& sums = weights[{ offset.z, offset.y, offset.x }];
        for (int exits = 0; exits < 8; ++exits)
        {
          sums[exits] +=
            half * basis[0][exits & 1] * basis[1][exits >> 1 & 1] * basis[2][exits >> 2 & 1];
        }
      }
    }
  }

  this->Entries.clear();
  for (const auto& weight : weights)
  {
    Entry entry{ weight.first[2], weight.first[1], weight.first[0] };
    bool any = false;
    for (int exits = 0; exits < 8; ++exits)
    {
      entry.Weights[exits] = static_cast<float>(weight.second[exits]);
      any = any || entry.Weights[exits] != 0;
    }
    if (any && std::abs(entry.X) < n.x && std::abs(entry.Y) < n.y && std::abs(entry.Z) < n.z)
    {
      this->Entries.push_back(entry);
    }
  }
}
