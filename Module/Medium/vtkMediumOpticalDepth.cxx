// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumOpticalDepth.h"

#include "vtkMediumNearRay.h"
#include "vtkMediumReferenceCut.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
// The nodes of the two-point Gauss-Legendre rule on [0,1]: exact for the cubic of a cell.
constexpr double LowerNode = 0.21132486540518711775;
constexpr double UpperNode = 0.78867513459481288225;

// Of the tolerance for a whole ray, the least share that a piece of it gets.
constexpr double LeastShare = 1e-3;

constexpr int MaximumBisections = 40;
}

//------------------------------------------------------------------------------
vtkMediumOpticalDepth::vtkMediumOpticalDepth(
  const vtkMediumScene& scene, const vtkMediumReferenceContent& content, double tolerance)
  : Content(content)
  , Box(scene.Geometry)
  , Cut(scene.Cut)
  , Tolerance(LeastShare * tolerance)
{
  const vtkMediumScene::Medium& medium = content.GetMedium();
  if (!medium.ExtinctionIsAbsorption && !medium.Extinction.IsConstant() && medium.Masks.empty())
  {
    this->Component = content.GetGreyComponent(medium.Extinction);
    if (medium.Extinction.Source != vtkMediumScene::Coefficient::Field)
    {
      this->Function = &content.GetFunction(medium.Extinction.FunctionIndex);
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumOpticalDepth::Evaluate(
  const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end) const
{
  const vtkMediumNearRay near(origin, direction, begin, end);
  const vtkMediumBoxRay ray(this->Box, near.Origin, direction);
  begin = near.Begin;
  end = near.End;
  if (!ray.Clip(begin, end))
  {
    return glm::dvec3(0);
  }
  if (this->Cut.IsNone())
  {
    return this->SumOfPart(ray, begin, end);
  }
  glm::dvec3 sum(0);
  for (const glm::dvec2& part : vtkMediumKeptParts(this->Cut, near.Origin, direction, begin, end))
  {
    sum += this->SumOfPart(ray, part.x, part.y);
  }
  return sum;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumOpticalDepth::EvaluateBetween(const glm::dvec3& a, const glm::dvec3& b) const
{
  const bool swap = glm::dot(a, a) > glm::dot(b, b);
  const glm::dvec3& from = swap ? b : a;
  const glm::dvec3 way = (swap ? a : b) - from;
  const double length = glm::length(way);
  return length > 0 ? this->Evaluate(from, way / length, 0, length) : glm::dvec3(0);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumOpticalDepth::SumOfPart(
  const vtkMediumBoxRay& ray, double begin, double end) const
{
  if (this->Component < 0)
  {
    return this->SumOfAny(ray, begin, end);
  }
  const vtkMediumScene::Medium& medium = this->Content.GetMedium();
  const double sum =
    this->Function ? this->SumOfFunction(ray, begin, end) : this->SumOfField(ray, begin, end);
  // In this order each product is one that vtkMediumCheckRange has seen.
  return sum * medium.Extinction.Scale * medium.DensityScale * this->Box.Length;
}

//------------------------------------------------------------------------------
double vtkMediumOpticalDepth::SumOfField(const vtkMediumBoxRay& ray, double begin, double end) const
{
  const vtkMediumLatticeValues& values =
    this->Content.GetValues(this->Content.GetMedium().Extinction.FieldIndex);
  const bool linear = values.GetLattice().Linear;
  vtkMediumCellWalk walk(values.GetLattice(), ray.Origin, ray.Direction, begin);
  const glm::dvec3& slope = walk.GetSlope();
  double corners[8];
  double sum = 0;
  for (double t = begin; t < end;)
  {
    walk.Advance(t);
    const double next = std::min(walk.GetExit(), end);
    values.GetCorners(walk.GetCell(), this->Component, corners);
    if (linear)
    {
      const glm::dvec3 start = walk.GetFraction() + t * slope;
      const glm::dvec3 step = (next - t) * slope;
      sum += 0.5 * (next - t) *
        (vtkMediumTrilinear(corners, start + LowerNode * step) +
          vtkMediumTrilinear(corners, start + UpperNode * step));
    }
    else
    {
      sum += (next - t) * corners[0];
    }
    t = next;
  }
  return sum;
}

//------------------------------------------------------------------------------
double vtkMediumOpticalDepth::SumOfFunction(
  const vtkMediumBoxRay& ray, double begin, double end) const
{
  const vtkMediumLatticeValues& values =
    this->Content.GetValues(this->Content.GetMedium().Extinction.FieldIndex);
  const bool linear = values.GetLattice().Linear;
  vtkMediumCellWalk walk(values.GetLattice(), ray.Origin, ray.Direction, begin);
  const glm::dvec3& slope = walk.GetSlope();
  double corners[8];
  std::vector<double> cuts;
  double sum = 0;
  for (double t = begin; t < end;)
  {
    walk.Advance(t);
    const double next = std::min(walk.GetExit(), end);
    values.GetCorners(walk.GetCell(), this->Component, corners);
    if (!linear)
    {
      sum += (next - t) * this->Function->EvaluateAlpha(corners[0]);
    }
    else
    {
      const auto range = std::minmax_element(corners, corners + 8);
      if (this->Function->IsAffine(*range.first, *range.second))
      {
        const glm::dvec3 start = walk.GetFraction() + t * slope;
        const glm::dvec3 step = (next - t) * slope;
        const double lower = vtkMediumTrilinear(corners, start + LowerNode * step);
        const double upper = vtkMediumTrilinear(corners, start + UpperNode * step);
        sum += 0.5 * (next - t) *
          (this->Function->EvaluateAlpha(lower) + this->Function->EvaluateAlpha(upper));
      }
      else
      {
        sum += this->IntegrateFunction(corners, walk.GetFraction(), slope, t, next, cuts);
      }
    }
    t = next;
  }
  return sum;
}

//------------------------------------------------------------------------------
double vtkMediumOpticalDepth::IntegrateFunction(const double corners[8], const glm::dvec3& fraction,
  const glm::dvec3& slope, double a, double b, std::vector<double>& cuts) const
{
  const double third = (b - a) / 3;
  const vtkMediumCubic cubic({ vtkMediumTrilinear(corners, fraction + a * slope),
    vtkMediumTrilinear(corners, fraction + (a + third) * slope),
    vtkMediumTrilinear(corners, fraction + (b - third) * slope),
    vtkMediumTrilinear(corners, fraction + b * slope) });
  cuts.clear();
  cuts.push_back(0);
  cubic.AppendCrossings(this->Function->GetKinks(), 0, 1, cuts);
  cuts.push_back(1);
  std::sort(cuts.begin(), cuts.end());
  const vtkMediumScene::Medium& medium = this->Content.GetMedium();
  const double scale =
    (b - a) * this->Box.Length * medium.DensityScale * vtkMediumMagnitude(medium.Extinction.Scale);
  const vtkMediumAgreement agreement{ scale > 0 ? this->Tolerance / scale : 1,
    std::max(this->Function->GetFacetError(), 1e-14) };
  double sum = 0;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    if (cuts[i + 1] > cuts[i])
    {
      sum += vtkMediumIntegrate(
        cuts[i], cuts[i + 1],
        [&](double u) { return this->Function->EvaluateAlpha(cubic.Evaluate(u)); }, agreement,
        MaximumBisections);
    }
  }
  return (b - a) * sum;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumOpticalDepth::SumOfAny(
  const vtkMediumBoxRay& ray, double begin, double end) const
{
  glm::dvec3 sum(0);
  std::vector<double> cuts;
  vtkMediumRayCells cells(
    this->Content, this->Content.GetNumberOfExtinctionFields(), ray, begin, end);
  while (cells.Next())
  {
    cuts.assign({ cells.GetBegin(), cells.GetEnd() });
    cells.AppendKinks(cuts);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    {
      if (cuts[i + 1] > cuts[i])
      {
        sum += this->EvaluateInCell(cells, cuts[i], 0, cuts[i + 1] - cuts[i]);
      }
    }
  }
  return sum;
}
