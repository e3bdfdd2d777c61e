// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumCellSums.h"

#include "vtkMediumTargetClones.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace
{
constexpr int BrickShift = 3; // bricks of 8 cells

//------------------------------------------------------------------------------
inline int Clamp(int value, int last)
{
  return value < 0 ? 0 : value > last ? last : value;
}
}

//------------------------------------------------------------------------------
vtkMediumCellSums::vtkMediumCellSums(const vtkMediumExtinctionGrid& grid)
  : Values(grid.GetValues().data())
  , Dimensions(grid.GetDimensions())
  , StrideY(grid.GetDimensions().x)
  , StrideZ(static_cast<std::ptrdiff_t>(grid.GetDimensions().x) * grid.GetDimensions().y)
  , Linear(grid.IsLinear())
  , Bricks((grid.GetDimensions() + 7) >> BrickShift)
{
  this->Occupied.assign(
    static_cast<std::size_t>(this->Bricks.x) * this->Bricks.y * this->Bricks.z, 0);
  vtkSMPTools::For(0, this->Bricks.z, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType z = begin; z < end; ++z)
    {
      this->MarkSlab(static_cast<int>(z));
    }
  });
}

//------------------------------------------------------------------------------
void vtkMediumCellSums::MarkSlab(int brickZ)
{
  const glm::ivec3 n = this->Dimensions;
  std::vector<unsigned char> inRow(this->Bricks.x);
  for (int z = 8 * brickZ; z <= std::min(8 * brickZ + 8, n.z - 1); ++z)
  {
    for (int y = 0; y < n.y; ++y)
    {
      const float* row = this->Values + y * this->StrideY + z * this->StrideZ;
      for (int bx = 0; bx < this->Bricks.x; ++bx)
      {
        const float* last = row + std::min(8 * bx + 8, n.x - 1);
        inRow[bx] = std::any_of(row + 8 * bx, last + 1, [](float value) { return value != 0; });
      }
      for (int by = y > 0 ? (y - 1) / 8 : 0; by <= y / 8; ++by)
      {
        unsigned char* bricks = this->Occupied.data() +
          this->Bricks.x * (by + this->Bricks.y * static_cast<std::size_t>(brickZ));
        for (int bx = 0; bx < this->Bricks.x; ++bx)
        {
          bricks[bx] |= inRow[bx];
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// The mean over a piece of a ray that goes from `from` by `way`, relative to its cell.
inline double vtkMediumCellSums::IntegrateCell(
  const int cell[3], const double from[3], const double way[3]) const
{
  const int x0 = Clamp(cell[0], this->Dimensions.x - 1);
  const std::ptrdiff_t y0 = Clamp(cell[1], this->Dimensions.y - 1) * this->StrideY;
  const std::ptrdiff_t z0 = Clamp(cell[2], this->Dimensions.z - 1) * this->StrideZ;
  if (!this->Linear)
  {
    return this->Values[x0 + y0 + z0];
  }
  const int x1 = Clamp(cell[0] + 1, this->Dimensions.x - 1);
  const std::ptrdiff_t y1 = Clamp(cell[1] + 1, this->Dimensions.y - 1) * this->StrideY;
  const std::ptrdiff_t z1 = Clamp(cell[2] + 1, this->Dimensions.z - 1) * this->StrideZ;
  const float* v = this->Values;
  const float a000 = v[x0 + y0 + z0], a100 = v[x1 + y0 + z0];
  const float a010 = v[x0 + y1 + z0], a110 = v[x1 + y1 + z0];
  const float a001 = v[x0 + y0 + z1], a101 = v[x1 + y0 + z1];
  const float a011 = v[x0 + y1 + z1], a111 = v[x1 + y1 + z1];
  float sum = 0;
  for (double node : { 0.21132486540518711775, 0.78867513459481288225 })
  {
    const float fx = static_cast<float>(from[0] + node * way[0]);
    const float fy = static_cast<float>(from[1] + node * way[1]);
    const float fz = static_cast<float>(from[2] + node * way[2]);
    const float a00 = a000 + fx * (a100 - a000), a10 = a010 + fx * (a110 - a010);
    const float a01 = a001 + fx * (a101 - a001), a11 = a011 + fx * (a111 - a011);
    const float a0 = a00 + fy * (a10 - a00), a1 = a01 + fy * (a11 - a01);
    sum += a0 + fz * (a1 - a0);
  }
  return 0.5 * sum;
}

//------------------------------------------------------------------------------
inline std::ptrdiff_t vtkMediumCellSums::BrickOf(const glm::dvec3& at) const
{
  // Truncation is right here: what is below 0 is clamped to 0 anyway.
  const double shift = this->Linear ? 0 : 0.5;
  const int bx = Clamp(static_cast<int>(at.x + shift), this->Dimensions.x - 1) >> BrickShift;
  const int by = Clamp(static_cast<int>(at.y + shift), this->Dimensions.y - 1) >> BrickShift;
  const int bz = Clamp(static_cast<int>(at.z + shift), this->Dimensions.z - 1) >> BrickShift;
  return bx + this->Bricks.x * (by + this->Bricks.y * static_cast<std::ptrdiff_t>(bz));
}

//------------------------------------------------------------------------------
bool vtkMediumCellSums::IsEmptyBetween(const glm::dvec3& a, const glm::dvec3& b) const
{
  const std::ptrdiff_t brick = this->BrickOf(a);
  return !this->Occupied[brick] && this->BrickOf(b) == brick;
}

//------------------------------------------------------------------------------
VTK_MEDIUM_TARGET_CLONES
double vtkMediumCellSums::Integrate(
  const glm::dvec3& origin, const glm::dvec3& step, double first, double last) const
{
  const double shift = this->Linear ? 0 : 0.5; // regions of the nearest value end halfway
  int cell[3], sign[3];
  double next[3], spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double at = origin[axis] + first * step[axis] + shift;
    cell[axis] = static_cast<int>(at); // std::floor is a call on plain x86-64
    cell[axis] -= at < cell[axis] ? 1 : 0;
    const double lower = cell[axis];
    sign[axis] = step[axis] < 0 ? -1 : 1;
    spacing[axis] = step[axis] != 0 ? sign[axis] / step[axis] : 1e300;
    next[axis] = step[axis] != 0
      ? first + (sign[axis] > 0 ? lower + 1 - at : at - lower) * spacing[axis]
      : 1e300;
  }
  double sum = 0;
  for (double t = first; t < last;)
  {
    const int axis =
      next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    const double end = std::min(next[axis], last);
    if (end > t)
    {
      const int bx = Clamp(cell[0], this->Dimensions.x - 1) >> BrickShift;
      const int by = Clamp(cell[1], this->Dimensions.y - 1) >> BrickShift;
      const int bz = Clamp(cell[2], this->Dimensions.z - 1) >> BrickShift;
      if (this
            ->Occupied[bx + this->Bricks.x * (by + this->Bricks.y * static_cast<std::size_t>(bz))])
      {
        const double length = end - t;
        const double from[3] = { origin.x + t * step.x - cell[0], origin.y + t * step.y - cell[1],
          origin.z + t * step.z - cell[2] };
        const double way[3] = { length * step.x, length * step.y, length * step.z };
        sum += length * this->IntegrateCell(cell, from, way);
      }
      t = end;
    }
    if (next[axis] > last)
    {
      break;
    }
    cell[axis] += sign[axis];
    next[axis] += spacing[axis];
  }
  return sum;
}
