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

//------------------------------------------------------------------------------
// Sums a stencil's entries over the rows of a grid.
class RowSums
{
public:
  RowSums(const std::vector<vtkMediumLightStencil::Entry>& entries, const int exitPlane[3],
    const vtkMediumOccupiedRows& rows, const glm::ivec3& n)
    : Count(static_cast<int>(entries.size()))
    , ExitPlane(exitPlane)
    , Rows(rows)
    , N(n)
    , Weights(8 * entries.size())
  {
    for (int e = 0; e < this->Count; ++e)
    {
      const vtkMediumLightStencil::Entry& entry = entries[e];
      if (this->Groups.empty() || this->Groups.back().Y != entry.Y ||
        this->Groups.back().Z != entry.Z)
      {
        this->Groups.push_back({ entry.Y, entry.Z, e, e });
      }
      this->Groups.back().Last = e + 1;
      this->Shifts.push_back(entry.X);
      for (int exits = 0; exits < 8; ++exits)
      {
        this->Weights[exits * static_cast<std::size_t>(this->Count) + e] = entry.Weights[exits];
      }
    }
  }

  /// Writes the sums for the row (j, k) where they are needed. `terms` is scratch.
  void Sum(int j, int k, std::vector<Term>& terms, float* target) const
  {
    const vtkMediumOccupiedRows::Interval needed = this->Rows.GetNeeded(j, k);
    if (needed.Begin >= needed.End)
    {
      return;
    }
    this->FindTerms(j, k, terms);
    float block[BlockLength];
    for (int x = needed.Begin; x < needed.End; x += BlockLength)
    {
      SumBlock(terms.data(), static_cast<int>(terms.size()), this->Shifts.data(),
        this->Weights.data(), this->Count, x, block);
      std::copy(block, block + std::min(BlockLength, needed.End - x), target + x);
    }
    for (const Term& term : terms) // the values on the exit face of x have lost a part
    {
      const int exit = this->ExitPlane[0];
      const float value = exit >= 0 ? term.Row[exit] : 0;
      const float* w = this->Weights.data() + term.Exits * static_cast<std::size_t>(this->Count);
      for (int e = term.First; e < term.Last && value != 0; ++e)
      {
        const int x = exit - this->Shifts[e];
        if (x >= needed.Begin && x < needed.End)
        {
          target[x] += value * (w[this->Count + e] - w[e]);
        }
      }
    }
  }

private:
  void FindTerms(int j, int k, std::vector<Term>& terms) const
  {
    terms.clear();
    for (const Group& group : this->Groups)
    {
      const int y = j + group.Y, z = k + group.Z;
      if (y < 0 || y >= this->N.y || z < 0 || z >= this->N.z)
      {
        continue;
      }
      const vtkMediumOccupiedRows::Interval occupied = this->Rows.GetOccupied(y, z);
      if (occupied.Begin < occupied.End)
      {
        const int exits =
          (y == this->ExitPlane[1] ? 2 : 0) + (z == this->ExitPlane[2] ? 4 : 0);
        terms.push_back({ this->Rows.GetRow(y, z), occupied.Begin, occupied.End, group.First,
          group.Last, exits });
      }
    }
  }

  int Count;
  const int* ExitPlane;
  const vtkMediumOccupiedRows& Rows;
  glm::ivec3 N;
  std::vector<Group> Groups;
  std::vector<int> Shifts;
  std::vector<float> Weights; // [exits][entry]
};

//------------------------------------------------------------------------------
// Four-point Lagrange weights for nodes -1, 0, 1, 2.
void LagrangeWeights(double t, float weights[4])
{
  weights[0] = static_cast<float>(-t * (t - 1) * (t - 2) / 6);
  weights[1] = static_cast<float>((t + 1) * (t - 1) * (t - 2) / 2);
  weights[2] = static_cast<float>(-(t + 1) * t * (t - 2) / 2);
  weights[3] = static_cast<float>((t + 1) * t * (t - 1) / 6);
}

//------------------------------------------------------------------------------
// Adds the optical depth where rays leave their slab, interpolated in the plane there.
class SlabEnds
{
public:
  SlabEnds(const vtkMediumExtinctionGrid& grid, int lateral, const glm::dvec2& offset)
    : N(grid.GetDimensions())
    , Lateral(lateral)
    , Stride(lateral == 1 ? N.x : static_cast<std::ptrdiff_t>(N.x) * N.y)
    , Offset(offset)
    , Lower(grid.GetLower())
    , Upper(grid.GetUpper())
    , Cell(glm::floor(offset))
  {
    LagrangeWeights(offset.x - this->Cell.x, this->WeightsX);
    LagrangeWeights(offset.y - this->Cell.y, this->WeightsL);
  }

  /// `plane`: optical depths at x = 0 and lateral 0. Adds to the row that starts from lateral `l`.
  void Add(const float* plane, int l, float* target) const
  {
    const double end = l + this->Offset.y;
    if (end < this->Lower[this->Lateral] || end > this->Upper[this->Lateral])
    {
      return; // left the box before
    }
    const int n = this->N.x;
    std::vector<float> line(n, 0.0f);
    for (int node = 0; node < 4; ++node)
    {
      const int at = std::min(
        std::max(l + this->Cell.y - 1 + node, 0), this->N[this->Lateral] - 1);
      const float* row = plane + at * this->Stride;
      const float weight = this->WeightsL[node];
      for (int x = 0; x < n; ++x)
      {
        line[x] += weight * row[x];
      }
    }
    const int first = std::max(static_cast<int>(std::ceil(this->Lower.x - this->Offset.x)), 0);
    const int last = std::min(static_cast<int>(std::floor(this->Upper.x - this->Offset.x)), n - 1);
    for (int x = first; x <= last; ++x)
    {
      float sum = 0;
      for (int node = 0; node < 4; ++node)
      {
        const int at = x + this->Cell.x - 1 + node;
        sum += this->WeightsX[node] * line[at < 0 ? 0 : at >= n ? n - 1 : at];
      }
      target[x] += std::max(sum, 0.0f);
    }
  }

private:
  glm::ivec3 N;
  int Lateral;
  std::ptrdiff_t Stride;
  glm::dvec2 Offset;
  glm::dvec3 Lower, Upper;
  glm::ivec2 Cell;
  float WeightsX[4], WeightsL[4];
};
}

//------------------------------------------------------------------------------
void vtkMediumLightStencil::Build(
  const vtkMediumExtinctionGrid& grid, const glm::dvec3& direction, bool slabs)
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

  this->SlabPlanes = 0;
  if (slabs)
  {
    this->ChooseSlab(step, n);
    last = this->SlabPlanes > 0
      ? std::min(last, this->SlabPlanes / std::abs(step[this->SlabAxis]))
      : last;
  }
  this->SumWeights(grid, step, last);
}

//------------------------------------------------------------------------------
// The thickness of slabs whose rays end nearest to lattice points, an odd end costing least where it
// is rare: least u(1-u) + v(1-v) a plane, for the fractions u and v of a lateral step.
void vtkMediumLightStencil::ChooseSlab(const glm::dvec3& step, const glm::ivec3& n)
{
  const int axis = std::abs(step.y) > std::abs(step.z) ? 1 : 2, lateral = 3 - axis;
  constexpr double LeastSlope = 0.25; // rays more along x than this cross few rows as it is
  constexpr int Thinnest = 8, Thickest = 24;
  if (std::abs(step[axis]) < LeastSlope * std::abs(step.x) || n[axis] < 2 * Thinnest)
  {
    return;
  }
  this->SlabAxis = axis;
  double least = 1e300;
  for (int planes = Thinnest; planes <= Thickest; ++planes)
  {
    const double x = planes * step.x / std::abs(step[axis]);
    const double l = planes * step[lateral] / std::abs(step[axis]);
    const double u = x - std::floor(x), v = l - std::floor(l);
    const double cost = (u * (1 - u) + v * (1 - v) + 0.01) / planes;
    if (cost < least)
    {
      least = cost;
      this->SlabPlanes = planes;
      this->SlabOffset = glm::dvec2(x, l);
    }
  }
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
  // Slabs build upon each other, so all points of their planes are needed.
  const vtkMediumOccupiedRows rows(grid, this->SlabPlanes > 0 ? -1 : reach, true);
  const RowSums sums(this->Entries, this->ExitPlane, rows, n);
  tau.assign(grid.GetValues().size(), 0.0f);
  if (this->SlabPlanes == 0)
  {
    vtkSMPTools::For(0, static_cast<vtkIdType>(n.y) * n.z, 8, [&](vtkIdType begin, vtkIdType end) {
      std::vector<Term> terms;
      for (vtkIdType row = begin; row < end; ++row)
      {
        const int j = static_cast<int>(row % n.y), k = static_cast<int>(row / n.y);
        sums.Sum(j, k, terms, tau.data() + grid.GetIndex(0, j, k));
      }
    });
    return;
  }

  const int axis = this->SlabAxis, lateral = 3 - axis;
  const bool upwards = this->ExitPlane[axis] > 0; // rays leave through the last plane
  const SlabEnds ends(grid, lateral, this->SlabOffset);
  for (int done = 0; done < n[axis]; done += this->SlabPlanes)
  {
    const int count = std::min(this->SlabPlanes, n[axis] - done);
    const vtkIdType jobs = static_cast<vtkIdType>(count) * n[lateral];
    vtkSMPTools::For(0, jobs, 8, [&](vtkIdType begin, vtkIdType end) {
      std::vector<Term> terms;
      for (vtkIdType job = begin; job < end; ++job)
      {
        const int plane = done + static_cast<int>(job / n[lateral]);
        glm::ivec3 at(0);
        at[axis] = upwards ? n[axis] - 1 - plane : plane;
        at[lateral] = static_cast<int>(job % n[lateral]);
        float* target = tau.data() + grid.GetIndex(0, at.y, at.z);
        sums.Sum(at.y, at.z, terms, target);
        if (plane >= this->SlabPlanes)
        {
          at[axis] += upwards ? this->SlabPlanes : -this->SlabPlanes;
          ends.Add(tau.data() + grid.GetIndex(0, axis == 1 ? at.y : 0, axis == 2 ? at.z : 0),
            at[lateral], target);
        }
      }
    });
  }
}
