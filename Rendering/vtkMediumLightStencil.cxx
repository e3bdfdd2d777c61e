// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightStencil.h"

#include "vtkMediumOccupiedRows.h"
#include "vtkMediumTargetClones.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace
{
// Targets summed at once: what fits in the registers of AVX2, with 16 of 8 floats.
constexpr int BlockLength = vtkMediumOccupiedRows::Padding;

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

//------------------------------------------------------------------------------
struct Group // entries with the same y and z
{
  int Y, Z;
  int First, Last;
};

struct Term // a group that meets a target row
{
  const float* Row;
  int Begin, End; // of the row's extinction
  int First, Last;
  int Exits; // bits 1 and 2: the row is on the exit face of y, z
};

//------------------------------------------------------------------------------
VTK_MEDIUM_TARGET_CLONES
void SumBlock(const Term* terms, int count, const int* shifts, const float* weights,
  int numberOfEntries, int x, float* result)
{
  float sum[BlockLength] = {};
  for (int t = 0; t < count; ++t)
  {
    const Term& term = terms[t];
    const float* w = weights + term.Exits * numberOfEntries;
    for (int e = term.First; e < term.Last; ++e)
    {
      const int at = x + shifts[e];
      if (at >= term.End || at + BlockLength <= term.Begin)
      {
        continue;
      }
      const float* source = term.Row + at;
      const float weight = w[e];
      for (int i = 0; i < BlockLength; ++i)
      {
        sum[i] += weight * source[i];
      }
    }
  }
  for (int i = 0; i < BlockLength; ++i)
  {
    result[i] = sum[i];
  }
}
}

//------------------------------------------------------------------------------
void vtkMediumLightStencil::Build(
  const vtkMediumExtinctionGrid& grid, const glm::dvec3& direction)
{
  glm::dvec3 step = -(grid.GetLocalToLatticeAxes() * direction); // lattice steps a local unit
  const double largest =
    std::max({ std::abs(step.x), std::abs(step.y), std::abs(step.z) });
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
            basis[axis][exits] = Basis(
              beyond, grid.IsLinear(), grid.IsOnCells(), exits && step[axis] != 0);
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

//------------------------------------------------------------------------------
void vtkMediumLightStencil::Apply(
  const vtkMediumExtinctionGrid& grid, int reach, std::vector<float>& tau) const
{
  const glm::ivec3 n = grid.GetDimensions();
  const vtkMediumOccupiedRows rows(grid, reach, true);
  const int count = static_cast<int>(this->Entries.size());
  std::vector<Group> groups;
  std::vector<int> shifts(count);
  std::vector<float> weights(8 * static_cast<std::size_t>(count)); // [exits][entry]
  for (int e = 0; e < count; ++e)
  {
    const Entry& entry = this->Entries[e];
    if (groups.empty() || groups.back().Y != entry.Y || groups.back().Z != entry.Z)
    {
      groups.push_back({ entry.Y, entry.Z, e, e });
    }
    groups.back().Last = e + 1;
    shifts[e] = entry.X;
    for (int exits = 0; exits < 8; ++exits)
    {
      weights[exits * static_cast<std::size_t>(count) + e] = entry.Weights[exits];
    }
  }

  tau.assign(grid.GetValues().size(), 0.0f);
  const int exitX = this->ExitPlane[0];
  auto sumRow = [&](int j, int k, std::vector<Term>& terms) {
    const vtkMediumOccupiedRows::Interval needed = rows.GetNeeded(j, k);
    if (needed.Begin >= needed.End)
    {
      return;
    }
    terms.clear();
    for (const Group& group : groups)
    {
      const int y = j + group.Y, z = k + group.Z;
      if (y < 0 || y >= n.y || z < 0 || z >= n.z)
      {
        continue;
      }
      const vtkMediumOccupiedRows::Interval occupied = rows.GetOccupied(y, z);
      if (occupied.Begin < occupied.End)
      {
        const int exits = (y == this->ExitPlane[1] ? 2 : 0) + (z == this->ExitPlane[2] ? 4 : 0);
        terms.push_back({ rows.GetRow(y, z), occupied.Begin, occupied.End, group.First, group.Last,
          exits });
      }
    }
    float* target = tau.data() + grid.GetIndex(0, j, k);
    float block[BlockLength];
    for (int x = needed.Begin; x < needed.End; x += BlockLength)
    {
      SumBlock(terms.data(), static_cast<int>(terms.size()), shifts.data(), weights.data(), count, x,
        block);
      std::copy(block, block + std::min(BlockLength, needed.End - x), target + x);
    }
    for (const Term& term : terms) // the values on the exit face of x have lost a part
    {
      const float value = exitX >= 0 ? term.Row[exitX] : 0;
      const float* w = weights.data() + term.Exits * static_cast<std::size_t>(count);
      for (int e = term.First; e < term.Last && value != 0; ++e)
      {
        const int x = exitX - shifts[e];
        if (x >= needed.Begin && x < needed.End)
        {
          target[x] += value * (w[count + e] - w[e]);
        }
      }
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(n.y) * n.z, 8, [&](vtkIdType begin, vtkIdType end) {
    std::vector<Term> terms;
    for (vtkIdType row = begin; row < end; ++row)
    {
      sumRow(static_cast<int>(row % n.y), static_cast<int>(row / n.y), terms);
    }
  });
}
