// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumCoefficientBounds.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using Coefficient = vtkMediumScene::Coefficient;

//------------------------------------------------------------------------------
glm::dvec2 Join(const glm::dvec2& a, const glm::dvec2& b)
{
  return { std::min(a.x, b.x), std::max(a.y, b.y) };
}

//------------------------------------------------------------------------------
glm::dvec2 Extremes(const glm::dvec3& rgb)
{
  return { std::min({ rgb.x, rgb.y, rgb.z }), std::max({ rgb.x, rgb.y, rgb.z }) };
}
}

//------------------------------------------------------------------------------
void vtkMediumCoefficientBounds::Build(
  const vtkMediumScene::Medium& medium, const Coefficient& coefficient)
{
  this->FieldIndex = coefficient.IsConstant() ? -1 : coefficient.FieldIndex;
  this->FirstComponent = this->LastComponent = 0;
  this->Scales = Extremes(coefficient.Scale);
  this->Levels.clear();
  if (coefficient.IsConstant())
  {
    return;
  }
  if (coefficient.Source == Coefficient::Field)
  {
    const bool colour =
      coefficient.Component < 0 && medium.Fields[coefficient.FieldIndex].Components >= 3;
    this->FirstComponent = std::max(coefficient.Component, 0);
    this->LastComponent = colour ? 2 : this->FirstComponent;
    return;
  }

  const vtkMediumFunction& function = medium.Functions[coefficient.FunctionIndex];
  this->Minimum = function.GetMinimum();
  this->Maximum = function.GetMaximum();
  this->Levels.emplace_back();
  for (const glm::dvec4& sample : function.GetSamples())
  {
    const bool alpha = coefficient.Source == Coefficient::FunctionAlpha;
    this->Levels[0].push_back(
      Extremes(coefficient.Scale * (alpha ? glm::dvec3(sample.w) : glm::dvec3(sample))));
  }
  const std::size_t count = this->Levels[0].size();
  for (std::size_t width = 2; width <= count; width *= 2)
  {
    const std::vector<glm::dvec2>& finer = this->Levels.back();
    std::vector<glm::dvec2> level(count - width + 1);
    for (std::size_t i = 0; i < level.size(); ++i)
    {
      level[i] = Join(finer[i], finer[i + width / 2]);
    }
    this->Levels.push_back(std::move(level));
  }
}

//------------------------------------------------------------------------------
glm::dvec2 vtkMediumCoefficientBounds::EvaluateSamples(double position) const
{
  const std::vector<glm::dvec2>& samples = this->Levels[0];
  const int last = static_cast<int>(samples.size()) - 1;
  const int index = std::min(static_cast<int>(position), std::max(last - 1, 0));
  return glm::mix(samples[index], samples[std::min(index + 1, last)], position - index);
}

//------------------------------------------------------------------------------
glm::dvec2 vtkMediumCoefficientBounds::Evaluate(const glm::dvec2& range) const
{
  if (this->FieldIndex < 0)
  {
    return this->Scales;
  }
  if (this->Levels.empty())
  {
    const double a = this->Scales.x * range.x, b = this->Scales.x * range.y;
    const double c = this->Scales.y * range.x, d = this->Scales.y * range.y;
    return { std::min({ a, b, c, d }), std::max({ a, b, c, d }) };
  }
  if (!(this->Maximum > this->Minimum))
  {
    return this->Levels[0][0];
  }
  const double last = static_cast<double>(this->Levels[0].size() - 1);
  const glm::dvec2 position =
    glm::clamp((range - this->Minimum) / (this->Maximum - this->Minimum) * last, 0.0, last);
  glm::dvec2 result = Join(this->EvaluateSamples(position.x), this->EvaluateSamples(position.y));
  const int first = static_cast<int>(std::ceil(position.x));
  const int end = static_cast<int>(std::floor(position.y)) + 1;
  if (first < end)
  {
    int level = 0;
    while ((2 << level) <= end - first)
    {
      ++level;
    }
    const std::vector<glm::dvec2>& table = this->Levels[level];
    result = Join(result, Join(table[first], table[end - (1 << level)]));
  }
  return result;
}
