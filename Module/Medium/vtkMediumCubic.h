// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumCubic.h
 * @brief The trilinear interpolant of a cell along a straight line: a cubic.
 *
 * Private to the module.
 */
#ifndef vtkMediumCubic_h
#define vtkMediumCubic_h

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/// Trilinear interpolation of eight corners, whose bits are x, y, z.
inline double vtkMediumTrilinear(const double corners[8], const glm::dvec3& at)
{
  const double x00 = corners[0] + at.x * (corners[1] - corners[0]);
  const double x10 = corners[2] + at.x * (corners[3] - corners[2]);
  const double x01 = corners[4] + at.x * (corners[5] - corners[4]);
  const double x11 = corners[6] + at.x * (corners[7] - corners[6]);
  const double y0 = x00 + at.y * (x10 - x00);
  const double y1 = x01 + at.y * (x11 - x01);
  return y0 + at.z * (y1 - y0);
}

/// A cubic in u, 0 <= u <= 1.
class vtkMediumCubic
{
public:
  /// Takes the cubic from its values at u = 0, 1/3, 2/3 and 1.
  explicit vtkMediumCubic(const std::array<double, 4>& values)
  {
    // Newton's divided differences on thirds, written out in powers of u.
    const double first = values[1] - values[0];
    const double second = values[2] - 2 * values[1] + values[0];
    const double third = values[3] - 3 * values[2] + 3 * values[1] - values[0];
    this->C0 = values[0];
    this->C1 = 3 * first - 1.5 * second + third;
    this->C2 = 4.5 * (second - third);
    this->C3 = 4.5 * third;
  }

  double Evaluate(double u) const
  {
    return this->C0 + u * (this->C1 + u * (this->C2 + u * this->C3));
  }

  /// Appends begin + u length for every u in (0,1) at which the cubic passes a value of `levels`
  /// (sorted) or turns.
  void AppendCrossings(
    const std::vector<double>& levels, double begin, double length, std::vector<double>& cuts) const
  {
    std::array<double, 4> bounds;
    const int count = this->FindMonotonePieces(bounds);
    for (int piece = 0; piece + 1 < count; ++piece)
    {
      const double u0 = bounds[piece], u1 = bounds[piece + 1];
      const double s0 = this->Evaluate(u0), s1 = this->Evaluate(u1);
      const auto from = std::upper_bound(levels.begin(), levels.end(), std::min(s0, s1));
      const auto to = std::lower_bound(from, levels.end(), std::max(s0, s1));
      for (auto level = from; level != to; ++level)
      {
        cuts.push_back(begin + length * this->Solve(*level, u0, u1));
      }
      if (piece > 0)
      {
        cuts.push_back(begin + length * u0);
      }
    }
  }

private:
  // 0, the turning points inside, 1.
  int FindMonotonePieces(std::array<double, 4>& bounds) const
  {
    int count = 0;
    bounds[count++] = 0;
    const double largest =
      std::max({ 3 * std::abs(this->C3), 2 * std::abs(this->C2), std::abs(this->C1) });
    const double unit = largest > 0 ? largest : 1; // whose square may be beyond a double
    const double a = 3 * this->C3 / unit, b = 2 * this->C2 / unit, c = this->C1 / unit;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant > 0)
    {
      // The form without cancellation; a root at infinity fails the test below.
      const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
      double roots[2] = { a != 0 ? q / a : -1, q != 0 ? c / q : -1 };
      std::sort(roots, roots + 2);
      for (double root : roots)
      {
        if (root > bounds[count - 1] && root < 1)
        {
          bounds[count++] = root;
        }
      }
    }
    bounds[count++] = 1;
    return count;
  }

  // The crossing of a monotone piece: Newton's iteration, kept inside a shrinking bracket.
  double Solve(double level, double low, double high) const
  {
    const bool rising = this->Evaluate(high) > this->Evaluate(low);
    double u = 0.5 * (low + high);
    for (int iteration = 0; iteration < 60 && high - low > 1e-15; ++iteration)
    {
      const double excess = this->Evaluate(u) - level;
      if (excess == 0)
      {
        return u;
      }
      ((excess > 0) == rising ? high : low) = u;
      const double slope = this->C1 + u * (2 * this->C2 + u * 3 * this->C3);
      const double newton = slope != 0 ? u - excess / slope : low;
      const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
      if (std::abs(next - u) < 1e-16)
      {
        return next;
      }
      u = next;
    }
    return u;
  }

  double C0, C1, C2, C3;
};

#endif
