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
// All rows (y, z), along one ray after another. Rows on a ray sum the same sources, and those of the next ray
// mostly the same again: at 256^3 about 1 MB, which the processor's cache keeps. In the order of the lattice
// each slice reads half of the lattice anew.
std::vector<glm::ivec2> RowsAlongRays(const glm::ivec2& count, const glm::dvec2& step)
{
  const int along = std::abs(step.x) > std::abs(step.y) ? 0 : 1, across = 1 - along;
  const double slope = step[along] != 0 ? step[across] / step[along] : 0;
  const int drift = static_cast<int>(std::floor(slope * (count[along] - 1)));
  std::vector<glm::ivec2> rows;
  rows.reserve(static_cast<std::size_t>(count.x) * count.y);
  for (int ray = std::min(-drift, 0); ray < count[across] + std::max(-drift, 0); ++ray)
  {
    for (int i = 0; i < count[along]; ++i)
    {
      const int at = ray + static_cast<int>(std::floor(slope * i));
      if (at >= 0 && at < count[across])
      {
        glm::ivec2 row;
        row[along] = i;
        row[across] = at;
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
  const vtkMediumOccupiedRows rows(grid, reach, true);
  const RowSums sums(this->Entries, this->ExitPlane, rows, n);
  tau.assign(grid.GetValues().size(), Unknown);
  const std::vector<glm::ivec2> order = RowsAlongRays({ n.y, n.z }, this->StepYZ);
  vtkSMPTools::For(0, static_cast<vtkIdType>(order.size()), 8, [&](vtkIdType begin, vtkIdType end) {
    std::vector<Term> terms;
    for (vtkIdType i = begin; i < end; ++i)
    {
      const glm::ivec2& row = order[i];
      sums.Sum(row.x, row.y, terms, tau.data() + grid.GetIndex(0, row.x, row.y));
    }
  });
}
