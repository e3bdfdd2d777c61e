// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShaderComparison.h
 * @brief Holds what the device makes of a formula to what C++ makes of the same text in double.
 */
#ifndef ShaderComparison_h
#define ShaderComparison_h

#include "GpuFormulas.h"
#include "vtkMediumFormulas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

constexpr double Epsilon = std::numeric_limits<float>::epsilon();
/// Devices may flush what is smaller to zero.
constexpr double SmallestNormal = std::numeric_limits<float>::min();

/// A test of shader formulas, with a device that has compiled them.
class ShaderFormulas : public ::testing::Test
{
protected:
  void SetUp() override { ASSERT_TRUE(this->Device.IsCompiled()); }

  /// Every result of `components` numbers is finite and within `tolerance`, relative, of the truth.
  void ExpectFormula(GpuFormulas::Formula formula, const std::vector<Arguments>& table,
    int components, double tolerance, const std::function<glm::dvec4(const Arguments&)>& truth)
  {
    const std::vector<glm::vec4> results = this->Device.Evaluate(formula, table);
    double largest = 0;
    for (std::size_t i = 0; i < table.size(); ++i)
    {
      const glm::dvec4 expected = truth(table[i]);
      for (int c = 0; c < components; ++c)
      {
        const double value = results[i][c];
        const double error = std::abs(value - expected[c]);
        std::ostringstream arguments;
        for (float a : table[i])
        {
          arguments << a << " ";
        }
        ASSERT_TRUE(std::isfinite(value)) << "of " << arguments.str();
        ASSERT_LE(error, tolerance * std::abs(expected[c]) + SmallestNormal)
          << value << " instead of " << expected[c] << " of " << arguments.str();
        const bool normal = std::abs(expected[c]) > SmallestNormal;
        largest = std::max(largest, normal ? error / std::abs(expected[c]) : 0);
      }
    }
    this->RecordProperty("LargestRelativeError", std::to_string(largest));
  }

  GpuFormulas Device;
};

#endif
