// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumGaussLegendre.h
 * @brief Gauss-Legendre rules on [0,1], and adaptive integration of smooth functions with them.
 *
 * Private to the module. A rule of n points is exact for polynomials of degree 2n-1 (Abramowitz and
 * Stegun, Handbook of Mathematical Functions, 25.4.29).
 */
#ifndef vtkMediumGaussLegendre_h
#define vtkMediumGaussLegendre_h

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

template <int N>
struct vtkMediumGaussLegendre
{
  std::array<double, N> Nodes;
  std::array<double, N> Weights;

  vtkMediumGaussLegendre()
  {
    const double pi = 3.14159265358979323846;
    for (int i = 0; i < N; ++i)
    {
      // Newton's iteration for a root of the Legendre polynomial, from Tricomi's estimate.
      double x = -std::cos(pi * (i + 0.75) / (N + 0.5));
      double slope = 1;
      for (int iteration = 0; iteration < 8; ++iteration)
      {
        double previous = 1, value = x;
        for (int degree = 2; degree <= N; ++degree)
        {
          const double next = ((2 * degree - 1) * x * value - (degree - 1) * previous) / degree;
          previous = value;
          value = next;
        }
        slope = N * (x * value - previous) / (x * x - 1);
        x -= value / slope;
      }
      this->Nodes[i] = 0.5 + 0.5 * x;
      this->Weights[i] = 1 / ((1 - x * x) * slope * slope);
    }
  }

  static const vtkMediumGaussLegendre& Get()
  {
    static const vtkMediumGaussLegendre rule;
    return rule;
  }

  /// The integral of `function` from a to b by this rule.
  template <typename Function>
  static auto Integrate(double a, double b, const Function& function)
  {
    const vtkMediumGaussLegendre& rule = Get();
    auto sum = rule.Weights[0] * function(a + (b - a) * rule.Nodes[0]);
    for (int i = 1; i < N; ++i)
    {
      sum += rule.Weights[i] * function(a + (b - a) * rule.Nodes[i]);
    }
    return (b - a) * sum;
  }
};

inline double vtkMediumMagnitude(double value)
{
  return std::abs(value);
}
inline double vtkMediumMagnitude(const glm::dvec3& value)
{
  return std::max({ std::abs(value.x), std::abs(value.y), std::abs(value.z) });
}

/// When two rules agree: absolutely, or relatively to the piece that is integrated.
struct vtkMediumAgreement
{
  double Absolute = 0;
  double Relative = 1e-14; ///< what rounding leaves

  template <typename Value>
  bool Holds(const Value& coarse, const Value& fine, double strictness = 1) const
  {
    const double difference = vtkMediumMagnitude(fine - coarse);
    return difference * strictness <= this->Absolute ||
      difference <= this->Relative * vtkMediumMagnitude(fine);
  }
};

/// A first look with 3 against 4 points must agree this many times better than the final word, 6
/// against 8, for it may agree by chance where the integrand has a kink.
constexpr double vtkMediumFirstLookStrictness = 1000;

/// The integral of `function` from a to b: 3 against 4 points, else 6 against 8, else bisection. The
/// tolerance is not halved with the interval, as what needs the bisection sits in one half.
template <typename Function>
auto vtkMediumIntegrate(double a, double b, const Function& function,
  const vtkMediumAgreement& agreement, int bisections) -> decltype(function(a))
{
  const auto fourth = vtkMediumGaussLegendre<4>::Integrate(a, b, function);
  if (agreement.Holds(
        vtkMediumGaussLegendre<3>::Integrate(a, b, function), fourth, vtkMediumFirstLookStrictness))
  {
    return fourth;
  }
  const auto eighth = vtkMediumGaussLegendre<8>::Integrate(a, b, function);
  if (bisections == 0 ||
    agreement.Holds(vtkMediumGaussLegendre<6>::Integrate(a, b, function), eighth))
  {
    return eighth;
  }
  const double middle = 0.5 * (a + b);
  return vtkMediumIntegrate(a, middle, function, agreement, bisections - 1) +
    vtkMediumIntegrate(middle, b, function, agreement, bisections - 1);
}

#endif
