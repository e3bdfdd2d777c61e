// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightPyramid.h"

#include "vtkSMPTools.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Rays that have left the box carry on within this many spacings of it, for interpolation at its
// border; three take part directly, the fourth covers rounding.
constexpr int Margin = 4;

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
  const vtkMediumExtinctionGrid& grid, const vtkMediumCellSums& sums, int axis, int sign)
  : Grid(grid)
  , Sums(sums)
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
  const int count = static_cast<int>(std::ceil((last - first) / lateral.Spacing)) + 2 * Margin;
  lateral.FirstRay = first - (Margin - 1) * lateral.Spacing;
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
      first = std::max(first, lateral.Entries[a]);
    }
    if (first <= last)
    {
      lateral.FirstPlanes[a] = static_cast<int>(std::ceil(first - this->FirstDepth));
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
    this->PlaceRays(*lateral, -std::max(way, 0.0), lateral->Points - 1 - std::min(way, 0.0));
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
bool vtkMediumLightPyramid::IsLit(const glm::dvec3& step) const
{
  if (this->ConeCosine < -1)
  {
    return true;
  }
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
  const double angle =
    std::acos(std::min(std::max(glm::dot(local, this->ConeDirection) / length, -1.0), 1.0));
  return angle - std::acos(std::max(this->ConeCosine, -1.0)) <= std::atan(margin / length) * 2;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumLightPyramid::StepOf(int a, int b) const
{
  glm::dvec3 step;
  step[this->U.Axis] = this->U.Slopes[a];
  step[this->V.Axis] = this->V.Slopes[b];
  step[this->AxisW] = this->Sign;
  return step;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumLightPyramid::RayAt(int a, int b, int plane) const
{
  const double depth = this->DepthOf(plane);
  glm::dvec3 at;
  at[this->U.Axis] = this->U.Origins[a] + this->U.Slopes[a] * depth;
  at[this->V.Axis] = this->V.Origins[b] + this->V.Slopes[b] * depth;
  at[this->AxisW] = this->IndexOf(plane);
  return at;
}

//------------------------------------------------------------------------------
// The sum along a ray from where it enters the box to the first plane after that.
double vtkMediumLightPyramid::EnterRay(int a, int b, int plane) const
{
  double entry = std::max({ this->EntryW, this->U.Entries[a], this->V.Entries[b] });
  entry = this->Directional ? entry : std::max(entry, 0.0);
  return this->Sums.Integrate(
    this->RayAt(a, b, plane), -this->StepOf(a, b), 0, this->DepthOf(plane) - entry);
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
      depths[a] = static_cast<float>(lengths[a] * this->EnterRay(a, b, plane));
      continue;
    }
    const glm::dvec3 from = this->RayAt(a, b, plane - 1), step = this->StepOf(a, b);
    if (!this->Sums.IsEmptyBetween(from, from + step))
    {
      depths[a] += static_cast<float>(lengths[a] * this->Sums.Integrate(from, step, 0, 1));
    }
  }
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::March(const vtkMediumOccupiedRows& rows, std::vector<float>& tau)
{
  const int countU = static_cast<int>(this->U.Origins.size());
  const int countV = static_cast<int>(this->V.Origins.size());
  this->Depths.assign(
    static_cast<std::size_t>(countU) * countV, std::numeric_limits<float>::quiet_NaN());
  this->Lengths.resize(this->Depths.size());
  vtkSMPTools::For(0, countV, [&](vtkIdType begin, vtkIdType end) {
    for (int b = static_cast<int>(begin); b < end; ++b)
    {
      for (int a = 0; a < countU; ++a)
      {
        const glm::dvec3 step = this->StepOf(a, b);
        const double length = glm::length(this->Grid.GetLatticeToLocalAxes() * step);
        this->Lengths[b * static_cast<std::size_t>(countU) + a] =
          this->IsLit(step) ? static_cast<float>(length) : -1.0f;
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
