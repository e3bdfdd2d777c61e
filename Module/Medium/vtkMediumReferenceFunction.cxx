// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumReferenceFunction.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkMediumReferenceFunction::vtkMediumReferenceFunction(const vtkMediumFunction& function)
  : Minimum(function.GetMinimum())
  , Samples(function.GetSamples())
{
  const double range = function.GetMaximum() - function.GetMinimum();
  const std::size_t intervals = this->Samples.size() - 1;
  this->PerUnit = range > 0 && intervals > 0 ? intervals / range : 0;
  for (const glm::dvec4& sample : this->Samples)
  {
    this->Alpha.push_back(sample.w);
  }
  this->FindKinks(function);
  this->FindBends();
}

//------------------------------------------------------------------------------
void vtkMediumReferenceFunction::FindKinks(const vtkMediumFunction& function)
{
  if (this->PerUnit == 0)
  {
    return;
  }
  std::vector<double> samples;
  for (double knot : function.GetKnots())
  {
    const double position = (knot - this->Minimum) * this->PerUnit;
    const double nearest = std::round(position);
    // Rounding leaves about 1e-12 samples; 1e-9 of one bends the table by nothing that matters.
    if (std::abs(position - nearest) < 1e-9)
    {
      samples.push_back(nearest);
    }
    else
    {
      samples.push_back(std::floor(position));
      samples.push_back(std::floor(position) + 1);
    }
  }
  // The function is constant beyond its range.
  samples.push_back(0);
  samples.push_back(static_cast<double>(this->Samples.size() - 1));
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  for (double sample : samples)
  {
    this->Kinks.push_back(this->Minimum + sample / this->PerUnit);
  }
}

//------------------------------------------------------------------------------
void vtkMediumReferenceFunction::FindBends()
{
  const int last = static_cast<int>(this->Samples.size()) - 1;
  glm::dvec4 largest(0);
  for (const glm::dvec4& sample : this->Samples)
  {
    largest = glm::max(largest, glm::abs(sample));
  }
  const auto bend = [&](int i) {
    const glm::dvec4 second = this->Samples[i - 1] - 2.0 * this->Samples[i] + this->Samples[i + 1];
    double result = 0;
    for (int c = 0; c < 4; ++c)
    {
      result = largest[c] > 0 ? std::max(result, std::abs(second[c]) / largest[c]) : result;
    }
    return result;
  };

  this->AffineUntil.assign(last + 1, last);
  std::vector<double> bends;
  for (int i = last - 1; i >= 0; --i)
  {
    const double next = i + 1 < last ? bend(i + 1) : 1;
    // A straight table of 4096 samples in double bends by less than 1e-13 at each.
    this->AffineUntil[i] = next < 1e-12 ? this->AffineUntil[i + 1] : i + 1;
    if (i + 1 < last && next >= 1e-12)
    {
      bends.push_back(next);
    }
  }
  if (!bends.empty())
  {
    // The error of linear interpolation is 1/8 of the second difference. The few strongest bends
    // are kinks, which a quadrature resolves; 95 of 100 are the facets of a smooth curve.
    const auto rank = bends.begin() + bends.size() * 95 / 100;
    std::nth_element(bends.begin(), rank, bends.end());
    this->FacetError = std::min(*rank / 8, 1e-6);
  }
}

//------------------------------------------------------------------------------
double vtkMediumReferenceFunction::GetPosition(double value) const
{
  const double last = static_cast<double>(this->Samples.size() - 1);
  return std::min(std::max((value - this->Minimum) * this->PerUnit, 0.0), last);
}

//------------------------------------------------------------------------------
glm::dvec4 vtkMediumReferenceFunction::Evaluate(double value) const
{
  const double position = this->GetPosition(value);
  const std::size_t index = static_cast<std::size_t>(position);
  const std::size_t next = std::min(index + 1, this->Samples.size() - 1);
  return this->Samples[index] + (position - index) * (this->Samples[next] - this->Samples[index]);
}

//------------------------------------------------------------------------------
double vtkMediumReferenceFunction::EvaluateAlpha(double value) const
{
  const double position = this->GetPosition(value);
  const std::size_t index = static_cast<std::size_t>(position);
  const std::size_t next = std::min(index + 1, this->Alpha.size() - 1);
  return this->Alpha[index] + (position - index) * (this->Alpha[next] - this->Alpha[index]);
}

//------------------------------------------------------------------------------
bool vtkMediumReferenceFunction::IsAffine(double low, double high) const
{
  if (this->PerUnit == 0)
  {
    return true;
  }
  const double last = static_cast<double>(this->Samples.size() - 1);
  const double from = (low - this->Minimum) * this->PerUnit;
  const double to = (high - this->Minimum) * this->PerUnit;
  if (to <= 0 || from >= last || low == high)
  {
    return true;
  }
  // One rounding error beyond the ends of the table is not a bend.
  return from > -1e-6 && to < last + 1e-6 &&
    this->AffineUntil[static_cast<std::size_t>(std::max(from, 0.0))] + 1e-6 >= to;
}
