// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMediumLightPyramid: from the rays to the lattice points of one plane.
#include "vtkMediumLightPyramid.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
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
inline double vtkMediumLightPyramid::RayIndex(const Lateral& lateral, int point, double depth) const
{
  const double place =
    this->Directional ? point - lateral.Drift * depth : (point - lateral.Apex) / depth;
  return (place - lateral.FirstRay) / lateral.Spacing;
}

//------------------------------------------------------------------------------
// The lattice points of a row that belong to this pyramid and are needed, in order from x to y.
glm::ivec2 vtkMediumLightPyramid::PointsOfRow(
  int v, int plane, const vtkMediumOccupiedRows& rows) const
{
  const double depth = this->DepthOf(plane);
  const int w = this->IndexOf(plane);
  glm::ivec2 range(0, this->U.Points - 1);
  if (this->U.Axis == 0)
  {
    const vtkMediumOccupiedRows::Interval needed =
      this->AxisW == 2 ? rows.GetNeeded(v, w) : rows.GetNeeded(w, v);
    range = glm::ivec2(needed.Begin, needed.End - 1);
  }
  if (!this->Directional)
  {
    // Points on the border between pyramids are in the one with the lower axis.
    const double reach = std::abs(v - this->V.Apex);
    const bool lowerV = this->V.Axis < this->AxisW, lowerU = this->U.Axis < this->AxisW;
    if (lowerV ? reach >= depth : reach > depth)
    {
      return { 0, -1 };
    }
    const double from = this->U.Apex - depth, to = this->U.Apex + depth;
    range.x = std::max(range.x, static_cast<int>(lowerU ? std::floor(from) + 1 : std::ceil(from)));
    range.y = std::min(range.y, static_cast<int>(lowerU ? std::ceil(to) - 1 : std::floor(to)));
  }
  return range;
}

namespace
{
//------------------------------------------------------------------------------
// Interpolates six rows of rays, `stride` apart, to one at a fraction between the third and the fourth,
// and says how rough it is there: half, for each of the two nodes around a point.
void CombineRows(const float* rows, int stride, float fraction, std::vector<float>& line,
  std::vector<float>& roughness)
{
  const int count = static_cast<int>(line.size());
  std::vector<float> kinks(count, 0.0f), bends(count, 0.0f);
  float weights[4];
  LagrangeWeights(fraction, weights);
  for (int r = 0; r < 6; ++r)
  {
    const float* depths = rows + static_cast<std::size_t>(r) * stride;
    const float weight = r > 0 && r < 5 ? weights[r - 1] : 0;
    const float kink = KinkDifference[r] * KinkWeight(fraction);
    const float bend = BendDifference[r] * BendWeight(fraction);
    for (int a = 0; a < count; ++a)
    {
      line[a] += weight * depths[a];
      kinks[a] += kink * depths[a];
      bends[a] += bend * depths[a];
    }
  }
  for (int a = 0; a < count; ++a)
  {
    roughness[a] = 0.5f * (std::abs(kinks[a]) + std::abs(bends[a]));
  }
}
}

//------------------------------------------------------------------------------
void vtkMediumLightPyramid::InterpolateRow(
  int v, int plane, const vtkMediumOccupiedRows& rows, std::vector<float>& tau) const
{
  const double depth = this->DepthOf(plane);
  const int w = this->IndexOf(plane);
  const glm::ivec2 range = this->PointsOfRow(v, plane, rows);
  const int first = range.x, last = range.y;
  if (first > last)
  {
    return;
  }

  const int count = static_cast<int>(this->U.Origins.size());
  const double row = this->RayIndex(this->V, v, depth);
  const int row0 = static_cast<int>(std::floor(row));
  const float fractionV = static_cast<float>(row - row0);
  const int begin = static_cast<int>(std::floor(this->RayIndex(this->U, first, depth))) - 2;
  const int end = static_cast<int>(std::floor(this->RayIndex(this->U, last, depth))) + 4;
  std::vector<float> line(end - begin, 0.0f), roughness(end - begin, 0.0f);
  CombineRows(this->Depths.data() + static_cast<std::size_t>(row0 - 2) * count + begin, count,
    fractionV, line, roughness);
  float weights[4];
  float* target = tau.data() + w * this->StrideW + v * this->V.Stride;
  for (int u = first; u <= last; ++u)
  {
    if (this->U.Axis != 0)
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
