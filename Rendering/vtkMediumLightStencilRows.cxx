// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMediumLightStencil::Apply.
#include "vtkMediumLightStencil.h"

#include "vtkMediumOccupiedRows.h"
#include "vtkMediumTargetClones.h"

#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Targets summed at once: what fits in the registers of AVX2, with 16 of 8 floats.
constexpr int BlockLength = vtkMediumOccupiedRows::Padding;

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
        const int exits = (y == this->ExitPlane[1] ? 2 : 0) + (z == this->ExitPlane[2] ? 4 : 0);
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
      const int at = std::min(std::max(l + this->Cell.y - 1 + node, 0), this->N[this->Lateral] - 1);
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

//------------------------------------------------------------------------------
// The rows (y, z) from `begin` to before `end`, along one ray after another. Rows on a ray sum the same
// sources, and those of the next ray mostly the same again: at 256^3 about 1 MB, which the processor's
// cache keeps. In the order of the lattice each slice reads half of the lattice anew.
std::vector<glm::ivec2> RowsAlongRays(
  const glm::ivec2& begin, const glm::ivec2& end, const glm::dvec2& step)
{
  const int along = std::abs(step.x) > std::abs(step.y) ? 0 : 1, across = 1 - along;
  const double slope = step[along] != 0 ? step[across] / step[along] : 0;
  const int length = end[along] - begin[along], width = end[across] - begin[across];
  const int drift = static_cast<int>(std::floor(slope * (length - 1)));
  std::vector<glm::ivec2> rows;
  rows.reserve(static_cast<std::size_t>(length) * width);
  for (int ray = std::min(-drift, 0); ray < width + std::max(-drift, 0); ++ray)
  {
    for (int i = 0; i < length; ++i)
    {
      const int at = ray + static_cast<int>(std::floor(slope * i));
      if (at >= 0 && at < width)
      {
        glm::ivec2 row;
        row[along] = begin[along] + i;
        row[across] = begin[across] + at;
        rows.push_back(row);
      }
    }
  }
  return rows;
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
  tau.assign(grid.GetValues().size(), this->SlabPlanes > 0 ? 0.0f : Unknown);

  const int axis = this->SlabAxis, lateral = 3 - axis;
  const bool upwards = this->ExitPlane[axis] > 0; // rays leave through the last plane
  const SlabEnds ends(grid, lateral, this->SlabOffset);
  const int thickness = this->SlabPlanes > 0 ? this->SlabPlanes : n[axis];
  for (int done = 0; done < n[axis]; done += thickness)
  {
    glm::ivec3 begin(0), end(n);
    const int last = std::min(done + thickness, n[axis]);
    begin[axis] = upwards ? n[axis] - last : done;
    end[axis] = upwards ? n[axis] - done : last;
    const std::vector<glm::ivec2> order =
      RowsAlongRays({ begin.y, begin.z }, { end.y, end.z }, this->StepYZ);
    const vtkIdType jobs = static_cast<vtkIdType>(order.size());
    vtkSMPTools::For(0, jobs, 8, [&](vtkIdType first, vtkIdType past) {
      std::vector<Term> terms;
      for (vtkIdType job = first; job < past; ++job)
      {
        glm::ivec3 at(0, order[job]);
        float* target = tau.data() + grid.GetIndex(0, at.y, at.z);
        sums.Sum(at.y, at.z, terms, target);
        if (done > 0)
        {
          at[axis] += upwards ? thickness : -thickness;
          ends.Add(tau.data() + grid.GetIndex(0, axis == 1 ? at.y : 0, axis == 2 ? at.z : 0),
            at[lateral], target);
        }
      }
    });
  }
}
