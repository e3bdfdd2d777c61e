// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumFunction
 * @brief A transfer function as the renderers see it: piecewise linear on equal intervals.
 *
 * VTK's transfer functions have colour spaces, logarithmic scales, midpoints and sharpness. They are
 * sampled once, by VTK itself, into this table; the GPU and the reference both read the table, so
 * that the two differ only in how they integrate. With the default 4096 intervals over the data's
 * range, a smooth function is met to about 1e-8 of its range and a step is resolved to 1/4096 of it.
 */
#ifndef vtkMediumFunction_h
#define vtkMediumFunction_h

#include "vtkParticipatingMediumModule.h" // for the export macro

#include <glm/vec4.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

class VTKPARTICIPATINGMEDIUM_EXPORT vtkMediumFunction
{
public:
  static constexpr int DefaultIntervals = 4096;

  /// Samples `function` at `intervals` + 1 equally spaced values of [minimum, maximum], whose width is
  /// finite.
  /// `knots` are the values in that range where the function is not smooth.
  void Sample(double minimum, double maximum, std::vector<double> knots,
    const std::function<glm::dvec4(double)>& function, int intervals = DefaultIntervals);

  /// Where sample `index` of a table of so many intervals over a range is: never outside of it.
  static double GetPlace(double minimum, double maximum, std::size_t index, std::size_t intervals)
  {
    const double part = static_cast<double>(index) / static_cast<double>(intervals);
    return std::min(minimum + part * (maximum - minimum), maximum);
  }

  /// Piecewise-linear interpolation of the samples; constant beyond the range. NaN is taken as the minimum.
  glm::dvec4 Evaluate(double value) const;

  double GetMinimum() const { return this->Minimum; }
  double GetMaximum() const { return this->Maximum; }
  const std::vector<glm::dvec4>& GetSamples() const { return this->Samples; }

  /// Sorted values strictly inside the range where an integrator should split.
  const std::vector<double>& GetKnots() const { return this->Knots; }

  bool operator==(const vtkMediumFunction& other) const
  {
    return this->Minimum == other.Minimum && this->Maximum == other.Maximum &&
      this->Samples == other.Samples;
  }

private:
  double Minimum = 0;
  double Maximum = 1;
  std::vector<glm::dvec4> Samples;
  std::vector<double> Knots;
};

#endif
