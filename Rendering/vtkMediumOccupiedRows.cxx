// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumOccupiedRows.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
using Interval = vtkMediumOccupiedRows::Interval;

//------------------------------------------------------------------------------
Interval Union(const Interval& a, const Interval& b)
{
  if (a.Begin >= a.End || b.Begin >= b.End)
  {
    return a.Begin >= a.End ? b : a;
  }
  return { std::min(a.Begin, b.Begin), std::max(a.End, b.End) };
}
}

//------------------------------------------------------------------------------
vtkMediumOccupiedRows::vtkMediumOccupiedRows(
  const vtkMediumExtinctionGrid& grid, int reach, bool withValues)
  : RowsOfSlice(grid.GetDimensions().y)
{
  const glm::ivec3 n = grid.GetDimensions();
  const vtkIdType rows = static_cast<vtkIdType>(n.y) * n.z;
  const float* values = grid.GetValues().data();
  this->Occupied.resize(rows);
  vtkSMPTools::For(0, rows, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType r = begin; r < end; ++r)
    {
      const glm::ivec2 occupied = vtkMediumExtinctionGrid::FindOccupied(values + r * n.x, n.x);
      this->Occupied[r] = { occupied.x, occupied.y };
    }
  });
  if (withValues)
  {
    this->CopyRows(grid);
  }
  this->FindNeeded(n, reach);
}

//------------------------------------------------------------------------------
void vtkMediumOccupiedRows::CopyRows(const vtkMediumExtinctionGrid& grid)
{
  const glm::ivec3 n = grid.GetDimensions();
  const vtkIdType rows = static_cast<vtkIdType>(n.y) * n.z;
  const float* values = grid.GetValues().data();
  this->Starts.resize(rows);
  std::size_t next = Padding;
  for (vtkIdType r = 0; r < rows; ++r)
  {
    this->Starts[r] = next;
    next += this->Occupied[r].Begin < this->Occupied[r].End ? n.x + Padding : 0;
  }
  this->Values.assign(next, 0.0f);
  vtkSMPTools::For(0, rows, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType r = begin; r < end; ++r)
    {
      const float* row = values + r * n.x;
      const Interval& interval = this->Occupied[r];
      std::copy(row + interval.Begin, row + interval.End,
        this->Values.begin() + this->Starts[r] + interval.Begin);
    }
  });
}

//------------------------------------------------------------------------------
void vtkMediumOccupiedRows::FindNeeded(const glm::ivec3& n, int reach)
{
  if (reach < 0)
  {
    this->Needed.assign(this->Occupied.size(), { 0, n.x });
    return;
  }
  std::vector<Interval> alongY(this->Occupied.size());
  for (int k = 0; k < n.z; ++k)
  {
    for (int j = 0; j < n.y; ++j)
    {
      for (int y = std::max(j - reach, 0); y <= std::min(j + reach, n.y - 1); ++y)
      {
        Interval& interval = alongY[this->RowIndex(j, k)];
        interval = Union(interval, this->Occupied[this->RowIndex(y, k)]);
      }
    }
  }
  this->Needed.assign(this->Occupied.size(), {});
  for (int k = 0; k < n.z; ++k)
  {
    for (int j = 0; j < n.y; ++j)
    {
      Interval& interval = this->Needed[this->RowIndex(j, k)];
      for (int z = std::max(k - reach, 0); z <= std::min(k + reach, n.z - 1); ++z)
      {
        interval = Union(interval, alongY[this->RowIndex(j, z)]);
      }
      if (interval.Begin < interval.End)
      {
        interval.Begin = std::max(interval.Begin - reach, 0);
        interval.End = std::min(interval.End + reach, n.x);
      }
    }
  }
}
