// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumFunction.h"

#include <glm/common.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
void vtkMediumFunction::Sample(double minimum, double maximum, std::vector<double> knots,
  const std::function<glm::dvec4(double)>& function, int intervals)
{
  this->Minimum = minimum;
  this->Maximum = maximum;
  this->Samples.resize(intervals + 1);
  for (int i = 0; i <= intervals; ++i)
  {
    this->Samples[i] = function(GetPlace(minimum, maximum, i, intervals));
  }
  std::sort(knots.begin(), knots.end());
  knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
  this->Knots.clear();
  for (double knot : knots)
  {
    if (knot > minimum && knot < maximum)
    {
      this->Knots.push_back(knot);
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec4 vtkMediumFunction::Evaluate(double value) const
{
  if (!(this->Maximum > this->Minimum))
  {
    return this->Samples.front();
  }
  const int last = static_cast<int>(this->Samples.size()) - 1;
  const double part = (value - this->Minimum) / (this->Maximum - this->Minimum);
  const double position = std::min(std::max(0.0, part) * last, double(last)); // 0 of NaN
  const int index = std::min(static_cast<int>(position), last - 1);
  return glm::mix(this->Samples[index], this->Samples[index + 1], position - index);
}
