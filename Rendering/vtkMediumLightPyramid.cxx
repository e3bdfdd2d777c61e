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
// Four-point Lagrange weights for nodes -1, 0, 1, 2.
void LagrangeWeights(float t, float weights[4])
{
  weights[0] = -t * (t - 1) * (t - 2) * (1.0f / 6);
  weights[1] = (t + 1) * (t - 1) * (t - 2) * 0.5f;
  weights[2] = -(t + 1) * t * (t - 2) * 0.5f;
  weights[3] = (t + 1) * t * (t - 1) * (1.0f / 6);
}

//------------------------------------------------------------------------------
// The error of the cubic through nodes -1…2 at t in 0…1 is estimated from six nodes -2…3, by two
// differences that vanish for parabolas. The inner second differences less the outer ones have the
// whole jump of the slope for a kink between the nodes 0 and 1, 3/16 of which is the error at t = 1/2;
// third differences see a kink in the next interval, which counts for 1/16.
float KinkWeight(float t)
{
  return 0.75f * t * (1 - t);
}

float BendWeight(float t)
{
  return 0.25f * t * (1 - t);
}

const float KinkDifference[6] = { -1, 3, -2, -2, 3, -1 };
const float BendDifference[6] = { 0, -1, 3, -3, 1, 0 };

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
  const double angle = std::acos(
    std::min(std::max(glm::dot(local, this->ConeDirection) / length, -1.0), 1.0));
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
// The optical depth of a lattice point along its own ray, where interpolation may be too far off.
float vtkMediumLightPyramid::MarchPoint(const glm::ivec3& point) const
{
  this->Marches.fetch_add(1, std::memory_order_relaxed);
  const glm::dvec3 at(point), lower = this->Grid.GetLower(), upper = this->Grid.GetUpper();
  glm::dvec3 step;
  step[this->AxisW] = -this->Sign;
  for (const Lateral* lateral : { &this->U, &this->V })
  {
    const int axis = lateral->Axis;
    step[axis] = this->Directional
      ? -lateral->Drift
      : (lateral->Apex - at[axis]) / std::abs(at[this->AxisW] - this->ApexW);
  }
  double last = this->Directional ? 1e300 : std::abs(at[this->AxisW] - this->ApexW);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (step[axis] != 0)
    {
      const double face = step[axis] > 0 ? upper[axis] : lower[axis];
      last = std::min(last, (face - at[axis]) / step[axis]);
    }
  }
  const double length = glm::length(this->Grid.GetLatticeToLocalAxes() * step);
  return static_cast<float>(length * this->Sums.Integrate(at, step, 0, last));
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
  const float fractionV = static_cast<float>(row - row0);
  float weights[4];
  LagrangeWeights(fractionV, weights);
  const int begin = static_cast<int>(std::floor(this->RayIndex(this->U, first, depth))) - 2;
  const int end = static_cast<int>(std::floor(this->RayIndex(this->U, last, depth))) + 4;
  std::vector<float> line(end - begin, 0.0f), kinks(end - begin, 0.0f), bends(end - begin, 0.0f);
  for (int r = 0; r < 6; ++r)
  {
    const float* depths =
      this->Depths.data() + static_cast<std::size_t>(row0 - 2 + r) * count + begin;
    const float weight = r > 0 && r < 5 ? weights[r - 1] : 0;
    const float kink = KinkDifference[r] * KinkWeight(fractionV);
    const float bend = BendDifference[r] * BendWeight(fractionV);
    for (int a = 0; a < end - begin; ++a)
    {
      line[a] += weight * depths[a];
      kinks[a] += kink * depths[a];
      bends[a] += bend * depths[a];
    }
  }
  std::vector<float>& roughness = kinks; // half, for each of the two nodes around a point
  for (int a = 0; a < end - begin; ++a)
  {
    roughness[a] = 0.5f * (std::abs(kinks[a]) + std::abs(bends[a]));
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
    const float fraction = static_cast<float>(place - at);
    LagrangeWeights(fraction, weights);
    const float* node = line.data() + at - 2 - begin;
    float value = 0, kink = 0, bend = 0;
    for (int a = 0; a < 6; ++a)
    {
      value += a > 0 && a < 5 ? weights[a - 1] * node[a] : 0;
      kink += KinkDifference[a] * node[a];
      bend += BendDifference[a] * node[a];
    }
    const float error = KinkWeight(fraction) * std::abs(kink) +
      BendWeight(fraction) * std::abs(bend) + roughness[at - begin] + roughness[at + 1 - begin];
    if (!(error * std::exp(-std::max(value - error, 0.0f)) < this->Tolerance)) // or not a number
    {
      glm::ivec3 point;
      point[this->U.Axis] = u;
      point[this->V.Axis] = v;
      point[this->AxisW] = w;
      value = this->MarchPoint(point);
    }
    target[u * this->U.Stride] = std::max(value, 0.0f);
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
