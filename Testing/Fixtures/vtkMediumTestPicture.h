// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumTestPicture.h
 * @brief Float pixels, and how two pictures differ.
 */
#ifndef vtkMediumTestPicture_h
#define vtkMediumTestPicture_h

#include "vtkImageData.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vtkMediumTest
{
struct Picture
{
  glm::ivec2 Size{ 0 };
  int Components = 0;
  std::vector<float> Values;

  Picture() = default;
  explicit Picture(vtkImageData* image)
    : Size(image->GetDimensions()[0], image->GetDimensions()[1])
    , Components(image->GetNumberOfScalarComponents())
  {
    if (image->GetScalarPointer())
    {
      const float* values = static_cast<const float*>(image->GetScalarPointer());
      this->Values.assign(
        values, values + std::size_t(this->Size.x) * this->Size.y * this->Components);
    }
  }

  /// One value; NaN, which no comparison accepts, where there is none.
  double At(int x, int y, int component = 0) const
  {
    const std::size_t i = std::size_t(y * this->Size.x + x) * this->Components + component;
    return i < this->Values.size() ? this->Values[i] : std::nan("");
  }

  /// The mean of one component over the picture.
  double Mean(int component = 0) const
  {
    double sum = 0;
    for (std::size_t i = component; i < this->Values.size(); i += this->Components)
    {
      sum += this->Values[i];
    }
    return sum / (double(this->Size.x) * this->Size.y);
  }

  /// Every value is finite and >= 0, and alpha is at most 1.
  bool IsLight() const
  {
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      const bool alpha = this->Components == 4 && i % 4 == 3;
      if (!std::isfinite(this->Values[i]) || this->Values[i] < 0 || (alpha && this->Values[i] > 1))
      {
        return false;
      }
    }
    return !this->Values.empty();
  }
};

/// The largest |a - b|, as a fraction of the largest |a|; huge where they cannot be compared.
inline double Difference(const Picture& a, const Picture& b)
{
  if (a.Values.size() != b.Values.size() || a.Values.empty())
  {
    return 1e300;
  }
  double difference = 0, largest = 0;
  for (std::size_t i = 0; i < a.Values.size(); ++i)
  {
    const double d = std::abs(double(a.Values[i]) - b.Values[i]);
    difference = d >= 0 ? std::max(difference, d) : 1e300; // NaN
    largest = std::max(largest, std::abs(double(a.Values[i])));
  }
  return largest > 0 ? difference / largest : difference;
}
}

#endif
