// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightPyramid.h"

#include "vtkMediumLightMarch.h"

#include "vtkSMPTools.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Rays within this many spacings of the box take part in interpolation at its border; two do so
// directly, the third covers rounding.
constexpr double Margin = 3;

constexpr int BrickShift = 3; // bricks of 8 cells

//------------------------------------------------------------------------------
// Four-point Lagrange weights for nodes -1, 0, 1, 2.
void LagrangeWeights(float t, float weights[4])
{
  weights[0] = -t * (t - 1) * (t - 2) * (1.0f / 6);
  weights[1] = (t + 1) * (t - 1) * (t - 2) * 0.5f;
  weights[2] = -(t + 1) * t * (t - 2) * 0.5f;
  weights[3] = (t + 1) * t * (t - 1) * (1.0f / 6);
}

//------------------------------------------------------------------------------
// Narrows [first, last] to where a D <= b.
void Restrict(double a, double b, double& first, double& last)
{
  if (a > 0)
  {
    last = std::min(last, b / a);
  }
  else if (a < 0)
  {
    first = std::max(first, b / a);
  }
  else if (b < 0)
  {
    last = first - 1;
  }
}
}

//------------------------------------------------------------------------------
vtkMediumLightPyramid::vtkMediumLightPyramid(
  const vtkMediumExtinctionGrid& grid, int axis, int sign)
  : Grid(grid)
  , AxisW(axis)
  , Sign(sign)
{
  const glm::ivec3 n = grid.GetDimensions();
  const std::ptrdiff_t strides[3] = { 1, n.x, static_cast<std::ptrdiff_t>(n.x) * n.y };
  this->U.Axis = axis == 0 ? 1 : 0;
  this->V.Axis = axis == 2 ? 1 : 2;
  for (Lateral* lateral : { &this->U, &this->V })
  {
    lateral->Points = n[lateral->Axis];
    lateral->Stride = strides[lateral->Axis];
    lateral->Lower = grid.GetLower()[lateral->Axis];
    lateral->Upper = grid.GetUpper()[lateral->Axis];
  }
  this->PointsW = n[axis];
  this->StrideW = strides[axis];
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::PlaceRays(Lateral& lateral, double first, double last)
{
  const double before = 2; // one for the interpolation, one for rounding
  const int count = static_cast<int>(std::ceil((last - first) / lateral.Spacing)) + 6;
  lateral.FirstRay = first - before * lateral.Spacing;
  lateral.Origins.resize(count);
  lateral.Slopes.resize(count);
  for (int a = 0; a < count; ++a)
  {
    const double value = lateral.FirstRay + a * lateral.Spacing;
    lateral.Origins[a] = this->Directional ? value : lateral.Apex;
    lateral.Slopes[a] = this->Directional ? lateral.Drift : value;
  }
  this->FindLives(lateral);
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::FindLives(Lateral& lateral) const
{
  const std::size_t count = lateral.Origins.size();
  const double fixed = this->Directional ? Margin * lateral.Spacing : 0;
  const double growing = this->Directional ? 0 : Margin * lateral.Spacing;
  lateral.Entries.assign(count, -1);
  lateral.FirstPlanes.assign(count, 0);
  lateral.LastPlanes.assign(count, -1);
  for (std::size_t a = 0; a < count; ++a)
  {
    const double origin = lateral.Origins[a], slope = lateral.Slopes[a];
    double first = this->FirstDepth, last = this->DepthOf(this->Planes - 1);
    Restrict(slope - growing, lateral.Upper + fixed - origin, first, last);
    Restrict(-slope - growing, origin + fixed - lateral.Lower, first, last);
    const bool below = this->Directional ? slope > 0 : origin < lateral.Lower;
    const bool above = this->Directional ? slope < 0 : origin > lateral.Upper;
    if (below || above)
    {
      const double way = (below ? lateral.Lower : lateral.Upper) - origin;
      if (!this->Directional && !(way * slope > 0))
      {
        continue; // leads away from the box
      }
      lateral.Entries[a] = way / slope;
    }
    if (first <= last)
    {
      lateral.FirstPlanes[a] = static_cast<int>(std::ceil(first - this->FirstDepth - 1e-9));
      lateral.LastPlanes[a] = static_cast<int>(std::floor(last - this->FirstDepth + 1e-9));
    }
  }
}

//------------------------------------------------------------------------------
bool vtkMediumLightPyramid::SetApex(const glm::dvec3& apex, double density)
{
  this->Directional = false;
  this->ApexW = apex[this->AxisW];
  const double last = this->PointsW - 1;
  const double lower = this->Grid.GetLower()[this->AxisW];
  const double upper = this->Grid.GetUpper()[this->AxisW];
  this->FirstIndex = static_cast<int>(this->Sign > 0
      ? std::floor(std::min(std::max(this->ApexW, -1.0), last)) + 1
      : std::ceil(std::min(std::max(this->ApexW, 0.0), last + 1)) - 1);
  this->Planes = this->Sign > 0 ? this->PointsW - this->FirstIndex : this->FirstIndex + 1;
  if (this->Planes <= 0)
  {
    return false;
  }
  this->FirstDepth = this->Sign * (this->FirstIndex - this->ApexW);
  const double face = this->Sign > 0 ? lower - this->ApexW : this->ApexW - upper;
  this->EntryW = face > 0 ? face : -1;
  const double nearest = this->FirstDepth, farthest = this->DepthOf(this->Planes - 1);
  for (Lateral* lateral : { &this->U, &this->V })
  {
    lateral->Apex = apex[lateral->Axis];
    lateral->Spacing = 1 / (density * farthest);
    const double a = -lateral->Apex, b = lateral->Points - 1 - lateral->Apex;
    const double low = std::max(std::min(a / nearest, a / farthest), -1.0);
    const double high = std::min(std::max(b / nearest, b / farthest), 1.0);
    if (low > high)
    {
      return false;
    }
    this->PlaceRays(*lateral, low, high);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::SetDirection(const glm::dvec3& direction, double density)
{
  this->Directional = true;
  this->FirstIndex = this->Sign > 0 ? 0 : this->PointsW - 1;
  this->Planes = this->PointsW;
  this->FirstDepth = this->Grid.IsOnCells() ? 0.5 : 0;
  this->EntryW = 0;
  for (Lateral* lateral : { &this->U, &this->V })
  {
    const double drift = direction[lateral->Axis] / std::abs(direction[this->AxisW]);
    lateral->Drift = std::abs(drift) < 1e-9 ? 0 : drift; // as in vtkMediumLightStencil
    lateral->Spacing = 1 / density;
    const double way = lateral->Drift * this->DepthOf(this->Planes - 1);
    this->PlaceRays(
      *lateral, -std::max(way, 0.0), lateral->Points - 1 - std::min(way, 0.0));
  }
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::SetCone(const glm::dvec3& direction, double cosine)
{
  this->ConeDirection = direction;
  this->ConeCosine = cosine;
}

//------------------------------------------------------------------------------
// Whether a ray, or one within a few spacings of it, is inside the cone.
bool vtkMediumLightPyramid::IsLit(double slopeU, double slopeV) const
{
  if (this->ConeCosine < -1)
  {
    return true;
  }
  glm::dvec3 step(0);
  step[this->AxisW] = this->Sign;
  step[this->U.Axis] = slopeU;
  step[this->V.Axis] = slopeV;
  const glm::dmat3& axes = this->Grid.GetLatticeToLocalAxes();
  const glm::dvec3 local = axes * step;
  // Two lattice points beside a lit one are looked up with it, and rays around those.
  double margin = 0;
  for (const Lateral* lateral : { &this->U, &this->V })
  {
    const double steps = 2 / this->FirstDepth;
    margin += glm::length(axes[lateral->Axis]) * (steps + Margin * lateral->Spacing);
  }
  margin += 2 / this->FirstDepth * glm::length(axes[this->AxisW]);
  const double length = glm::length(local);
  const double angle = std::acos(
    std::min(std::max(glm::dot(local, this->ConeDirection) / length, -1.0), 1.0));
  return angle - std::acos(std::max(this->ConeCosine, -1.0)) <= std::atan(margin / length) * 2;
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::FindOccupied()
{
  const glm::ivec3 n = this->Grid.GetDimensions();
  this->Bricks = (n + 7) >> BrickShift;
  this->Occupied.assign(
    static_cast<std::size_t>(this->Bricks.x) * this->Bricks.y * this->Bricks.z, 0);
  const float* values = this->Grid.GetValues().data();
  vtkSMPTools::For(0, this->Bricks.z, [&](vtkIdType begin, vtkIdType end) {
    for (int bz = static_cast<int>(begin); bz < end; ++bz)
    {
      for (int z = 8 * bz; z <= std::min(8 * bz + 8, n.z - 1); ++z)
      {
        for (int y = 0; y < n.y; ++y)
        {
          const float* row = values + this->Grid.GetIndex(0, y, z);
          for (int x = 0; x < n.x; ++x)
          {
            if (row[x] == 0)
            {
              continue;
            }
            for (int by = y % 8 == 0 && y > 0 ? y / 8 - 1 : y / 8; by <= y / 8; ++by)
            {
              for (int bx = x % 8 == 0 && x > 0 ? x / 8 - 1 : x / 8; bx <= x / 8; ++bx)
              {
                this->Occupied[bx + this->Bricks.x * (by + this->Bricks.y * std::size_t(bz))] = 1;
              }
            }
          }
        }
      }
    }
  });
}

//------------------------------------------------------------------------------
inline bool vtkMediumLightPyramid::IsOccupied(int u, int v, int w) const
{
  int at[3];
  at[this->U.Axis] = u >> BrickShift;
  at[this->V.Axis] = v >> BrickShift;
  at[this->AxisW] = w >> BrickShift;
  return this->Occupied[at[0] +
           this->Bricks.x * (at[1] + this->Bricks.y * static_cast<std::size_t>(at[2]))] != 0;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumLightPyramid::RayAt(int a, int b, double depth) const
{
  glm::dvec3 at;
  at[this->U.Axis] = this->U.Origins[a] + this->U.Slopes[a] * depth;
  at[this->V.Axis] = this->V.Origins[b] + this->V.Slopes[b] * depth;
  at[this->AxisW] = this->FirstIndex + this->Sign * (depth - this->FirstDepth);
  return at;
}

//------------------------------------------------------------------------------
// The optical depth of a ray at the first plane where it is near the box.
double vtkMediumLightPyramid::EnterRay(int a, int b, int plane) const
{
  double entry = std::max({ this->EntryW, this->U.Entries[a], this->V.Entries[b] });
  entry = this->Directional ? entry : std::max(entry, 0.0);
  const double depth = this->DepthOf(plane);
  if (entry >= this->DepthOf(this->Planes - 1) + 1)
  {
    return 0; // nowhere near the box
  }
  const double tau = vtkMediumExtendedOpticalDepth(
    this->Grid, this->RayAt(a, b, entry), this->RayAt(a, b, depth));
  return entry <= depth ? tau : -tau;
}

//------------------------------------------------------------------------------
// The optical depth of a ray from the plane before to this one.
float vtkMediumLightPyramid::CrossSlab(int a, int b, int plane) const
{
  const double depth = this->DepthOf(plane - 1);
  const int w = this->IndexOf(plane - 1);
  const float* values = this->Grid.GetValues().data() + w * this->StrideW;
  const std::ptrdiff_t next = this->Sign * this->StrideW;
  const double x = this->U.Origins[a] + this->U.Slopes[a] * depth, dx = this->U.Slopes[a];
  const double y = this->V.Origins[b] + this->V.Slopes[b] * depth, dy = this->V.Slopes[b];
  // Cells, or the regions where one value is nearest, which end halfway between lattice points.
  const double shift = this->Grid.IsLinear() ? 0 : 0.5;
  const double floorX = std::floor(x + shift), floorY = std::floor(y + shift);
  int cellX = static_cast<int>(floorX), cellY = static_cast<int>(floorY);
  const double never = 2;
  double nextX = dx != 0 ? ((dx > 0 ? floorX + 1 : floorX) - shift - x) / dx : never;
  double nextY = dy != 0 ? ((dy > 0 ? floorY + 1 : floorY) - shift - y) / dy : never;
  double nextW = this->Grid.IsLinear() ? never : 0.5;
  const int lastX = this->U.Points - 1, lastY = this->V.Points - 1;
  const int lowW = std::min(w, w + this->Sign);
  float sum = 0;
  for (double t = 0; t < 1;)
  {
    const double end = std::min({ nextX, nextY, nextW, 1.0 });
    const int x0 = std::min(std::max(cellX, 0), lastX);
    const int y0 = std::min(std::max(cellY, 0), lastY);
    if (end > t && this->IsOccupied(std::min(x0, std::max(lastX - 1, 0)),
                     std::min(y0, std::max(lastY - 1, 0)), lowW))
    {
      const float half = static_cast<float>(0.5 * (end - t)), middle = static_cast<float>(t) + half;
      if (!this->Grid.IsLinear())
      {
        const std::ptrdiff_t corner = x0 * this->U.Stride + y0 * this->V.Stride;
        sum += 2 * half * values[corner + (middle < 0.5f ? 0 : next)];
      }
      else
      {
        const int x1 = std::min(std::max(cellX + 1, 0), lastX);
        const int y1 = std::min(std::max(cellY + 1, 0), lastY);
        const float* near00 = values + x0 * this->U.Stride;
        const float* near10 = values + x1 * this->U.Stride;
        const std::ptrdiff_t row0 = y0 * this->V.Stride, row1 = y1 * this->V.Stride;
        const float a00 = near00[row0], a10 = near10[row0], a01 = near00[row1], a11 = near10[row1];
        const float b00 = near00[row0 + next], b10 = near10[row0 + next];
        const float b01 = near00[row1 + next], b11 = near10[row1 + next];
        const float fx = static_cast<float>(x - cellX), fy = static_cast<float>(y - cellY);
        const float sx = static_cast<float>(dx), sy = static_cast<float>(dy);
        for (float node : { -0.57735027f, 0.57735027f })
        {
          const float s = middle + node * half, u = fx + s * sx, v = fy + s * sy;
          const float c00 = a00 + s * (b00 - a00), c10 = a10 + s * (b10 - a10);
          const float c01 = a01 + s * (b01 - a01), c11 = a11 + s * (b11 - a11);
          const float c0 = c00 + u * (c10 - c00), c1 = c01 + u * (c11 - c01);
          sum += half * (c0 + v * (c1 - c0));
        }
      }
    }
    t = std::max(t, end);
    if (end >= 1)
    {
      break;
    }
    if (end == nextX)
    {
      cellX += dx > 0 ? 1 : -1;
      nextX += 1 / std::abs(dx);
    }
    else if (end == nextY)
    {
      cellY += dy > 0 ? 1 : -1;
      nextY += 1 / std::abs(dy);
    }
    else
    {
      nextW = never;
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::AdvanceRow(int b, int plane)
{
  const int count = static_cast<int>(this->U.Origins.size());
  const int firstV = this->V.FirstPlanes[b];
  if (plane < firstV || plane > this->V.LastPlanes[b])
  {
    return;
  }
  float* depths = this->Depths.data() + static_cast<std::size_t>(b) * count;
  const float* lengths = this->Lengths.data() + static_cast<std::size_t>(b) * count;
  for (int a = 0; a < count; ++a)
  {
    const int first = std::max(firstV, this->U.FirstPlanes[a]);
    if (plane < first || plane > this->U.LastPlanes[a] || lengths[a] < 0)
    {
      continue;
    }
    if (plane == first)
    {
      depths[a] = static_cast<float>(this->EnterRay(a, b, plane));
    }
    else
    {
      depths[a] += lengths[a] * this->CrossSlab(a, b, plane);
    }
  }
}

//------------------------------------------------------------------------------
inline double vtkMediumLightPyramid::RayIndex(
  const Lateral& lateral, int point, double depth) const
{
  const double place =
    this->Directional ? point - lateral.Drift * depth : (point - lateral.Apex) / depth;
  return (place - lateral.FirstRay) / lateral.Spacing;
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::InterpolateRow(
  int v, int plane, const vtkMediumOccupiedRows& rows, std::vector<float>& tau) const
{
  const double depth = this->DepthOf(plane);
  const int w = this->IndexOf(plane);
  const bool alongX = this->U.Axis == 0;
  int first = 0, last = this->U.Points - 1;
  if (alongX)
  {
    const bool planeIsZ = this->AxisW == 2;
    const vtkMediumOccupiedRows::Interval needed =
      planeIsZ ? rows.GetNeeded(v, w) : rows.GetNeeded(w, v);
    first = needed.Begin;
    last = needed.End - 1;
  }
  if (!this->Directional)
  {
    // Points on the border between pyramids are in the one with the lower axis.
    const double reach = std::abs(v - this->V.Apex);
    const bool lowerV = this->V.Axis < this->AxisW, lowerU = this->U.Axis < this->AxisW;
    if (lowerV ? reach >= depth : reach > depth)
    {
      return;
    }
    const double from = this->U.Apex - depth, to = this->U.Apex + depth;
    first = std::max(first, static_cast<int>(lowerU ? std::floor(from) + 1 : std::ceil(from)));
    last = std::min(last, static_cast<int>(lowerU ? std::ceil(to) - 1 : std::floor(to)));
  }
  if (first > last)
  {
    return;
  }

  const int count = static_cast<int>(this->U.Origins.size());
  const double row = this->RayIndex(this->V, v, depth);
  const int row0 = static_cast<int>(std::floor(row));
  float weights[4];
  LagrangeWeights(static_cast<float>(row - row0), weights);
  const int begin = static_cast<int>(std::floor(this->RayIndex(this->U, first, depth))) - 1;
  const int end = static_cast<int>(std::floor(this->RayIndex(this->U, last, depth))) + 3;
  std::vector<float> line(end - begin, 0.0f);
  for (int r = 0; r < 4; ++r)
  {
    const float* depths =
      this->Depths.data() + static_cast<std::size_t>(row0 - 1 + r) * count + begin;
    for (int a = 0; a < end - begin; ++a)
    {
      line[a] += weights[r] * depths[a];
    }
  }
  float* target = tau.data() + w * this->StrideW + v * this->V.Stride;
  for (int u = first; u <= last; ++u)
  {
    if (!alongX)
    {
      const vtkMediumOccupiedRows::Interval needed = rows.GetNeeded(u, v);
      if (w < needed.Begin || w >= needed.End)
      {
        continue;
      }
    }
    const double place = this->RayIndex(this->U, u, depth);
    const int at = static_cast<int>(std::floor(place));
    LagrangeWeights(static_cast<float>(place - at), weights);
    const float* node = line.data() + at - 1 - begin;
    const float value = weights[0] * node[0] + weights[1] * node[1] + weights[2] * node[2] +
      weights[3] * node[3];
    target[u * this->U.Stride] = std::max(value, 0.0f);
  }
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::March(const vtkMediumOccupiedRows& rows, std::vector<float>& tau)
{
  const int countU = static_cast<int>(this->U.Origins.size());
  const int countV = static_cast<int>(this->V.Origins.size());
  this->FindOccupied();
  this->Depths.assign(static_cast<std::size_t>(countU) * countV, 0.0f);
  this->Lengths.resize(this->Depths.size());
  vtkSMPTools::For(0, countV, [&](vtkIdType begin, vtkIdType end) {
    for (int b = static_cast<int>(begin); b < end; ++b)
    {
      for (int a = 0; a < countU; ++a)
      {
        const double slopeU = this->U.Slopes[a], slopeV = this->V.Slopes[b];
        glm::dvec3 step(0);
        step[this->AxisW] = this->Sign;
        step[this->U.Axis] = slopeU;
        step[this->V.Axis] = slopeV;
        const double length = glm::length(this->Grid.GetLatticeToLocalAxes() * step);
        this->Lengths[b * static_cast<std::size_t>(countU) + a] =
          this->IsLit(slopeU, slopeV) ? static_cast<float>(length) : -1.0f;
      }
    }
  });
  for (int plane = 0; plane < this->Planes; ++plane)
  {
    vtkSMPTools::For(0, countV, 4, [&](vtkIdType begin, vtkIdType end) {
      for (int b = static_cast<int>(begin); b < end; ++b)
      {
        this->AdvanceRow(b, plane);
      }
    });
    vtkSMPTools::For(0, this->V.Points, 8, [&](vtkIdType begin, vtkIdType end) {
      for (int v = static_cast<int>(begin); v < end; ++v)
      {
        this->InterpolateRow(v, plane, rows, tau);
      }
    });
  }
}
