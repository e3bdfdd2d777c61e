// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Phase functions on the device equal the same text in C++.
#include "ShaderComparison.h"

namespace
{
const float Cosines[] = { -1, -0.9999f, -0.7f, -1e-3f, -1e-40f, 0, 1e-40f, 1e-8f, 0.3f, 0.99f,
  0.9999f, 0.999999f, 1 };
const float Anisotropies[] = { -1, -0.9999f, -0.999f, -0.9f, -0.3f, -1e-8f, -1e-40f, 0, 1e-40f,
  1e-8f, 1e-3f, 0.5f, 0.938f, 0.97f, 0.99f, 0.999f, 0.9995f, 1 };

/// Float's rounding of 1 - |g| at the limit 0.999 is 6e-8 / 1e-3, its third power is the peak's; the
/// division and the square root add rounding units.
constexpr double PeakTolerance = 2e-4;

std::vector<Arguments> CosinesAndAnisotropies()
{
  std::vector<Arguments> table;
  for (float cosine : Cosines)
  {
    for (float g : Anisotropies)
    {
      table.push_back({ cosine, g });
    }
  }
  return table;
}

using namespace vtkMediumFormulas;
}

TEST_F(ShaderFormulas, IsotropicEqualsCxx)
{
  ExpectFormula(GpuFormulas::PhaseIsotropic, { {} }, 1, 2 * Epsilon,
    [](const Arguments&) { return glm::dvec4(Double::phaseIsotropic()); });
}

TEST_F(ShaderFormulas, HenyeyGreensteinEqualsCxx)
{
  ExpectFormula(GpuFormulas::PhaseHenyeyGreenstein, CosinesAndAnisotropies(), 1, PeakTolerance,
    [](const Arguments& a) { return glm::dvec4(Double::phaseHenyeyGreenstein(a[0], a[1])); });
}

TEST_F(ShaderFormulas, SchlickEqualsCxx)
{
  ExpectFormula(GpuFormulas::PhaseSchlick, CosinesAndAnisotropies(), 1, PeakTolerance,
    [](const Arguments& a) { return glm::dvec4(Double::phaseSchlick(a[0], a[1])); });
}

TEST_F(ShaderFormulas, SchlickFromGEqualsCxx)
{
  std::vector<Arguments> table;
  for (float g : Anisotropies)
  {
    table.push_back({ g });
  }
  // Three multiplications and a subtraction that cancels at most one bit.
  ExpectFormula(GpuFormulas::PhaseSchlickFromG, table, 1, 4 * Epsilon,
    [](const Arguments& a) { return glm::dvec4(Double::phaseSchlickFromG(a[0])); });
}

TEST_F(ShaderFormulas, DoubleHenyeyGreensteinEqualsCxx)
{
  std::vector<Arguments> table;
  for (const Arguments& a : CosinesAndAnisotropies())
  {
    for (float second : { -0.5f, 0.0f, 0.9f })
    {
      for (float weight : { 0.0f, 0.3f, 1.0f })
      {
        table.push_back({ a[0], a[1], second, weight });
      }
    }
  }
  ExpectFormula(
    GpuFormulas::PhaseDoubleHenyeyGreenstein, table, 1, PeakTolerance, [](const Arguments& a) {
      return glm::dvec4(Double::phaseDoubleHenyeyGreenstein(a[0], a[1], a[2], a[3]));
    });
}

TEST_F(ShaderFormulas, RayleighEqualsCxx)
{
  std::vector<Arguments> table;
  for (float cosine : Cosines)
  {
    table.push_back({ cosine });
  }
  ExpectFormula(GpuFormulas::PhaseRayleigh, table, 1, 4 * Epsilon,
    [](const Arguments& a) { return glm::dvec4(Double::phaseRayleigh(a[0])); });
}

TEST_F(ShaderFormulas, DraineAndDropletsEqualCxx)
{
  std::vector<Arguments> table;
  for (const Arguments& a : CosinesAndAnisotropies())
  {
    for (float alpha : { 0.0f, 1e-8f, 1.0f, 250.0f })
    {
      table.push_back({ a[0], a[1], alpha, 0.8f, 0.4f });
    }
  }
  ExpectFormula(GpuFormulas::PhaseDraine, table, 1, PeakTolerance,
    [](const Arguments& a) { return glm::dvec4(Double::phaseDraine(a[0], a[1], a[2])); });
  ExpectFormula(GpuFormulas::PhaseDroplets, table, 1, PeakTolerance, [](const Arguments& a) {
    return glm::dvec4(Double::phaseDroplets(a[0], a[1], a[2], a[3], a[4]));
  });
}

TEST_F(ShaderFormulas, TableCoordinateEqualsCxx)
{
  std::vector<Arguments> table;
  for (float cosine : { -1.5f, -1.0f, -0.999f, 0.0f, 0.25f, 1.0f, 1.0001f })
  {
    for (float size : { 2.0f, 3.0f, 181.0f, 4096.0f })
    {
      table.push_back({ cosine, size });
    }
  }
  // 1 + cosTheta cancels towards -1: rounding of 1/2 against 0.0005.
  ExpectFormula(GpuFormulas::PhaseTableCoordinate, table, 1, 1e-4,
    [](const Arguments& a) { return glm::dvec4(Double::phaseTableCoordinate(a[0], a[1])); });
}

TEST_F(ShaderFormulas, PhaseFunctionsAreNeverNegative)
{
  std::vector<Arguments> table;
  for (int i = 0; i <= 100; ++i)
  {
    for (float g : { -1.0f, -0.97f, -0.94f, 0.938f, 0.95f, 0.97f, 0.999f, 1.0f })
    {
      table.push_back({ i * 0.02f - 1, g });
    }
  }
  for (GpuFormulas::Formula formula :
    { GpuFormulas::PhaseHenyeyGreenstein, GpuFormulas::PhaseSchlick })
  {
    for (const glm::vec4& value : Device.Evaluate(formula, table))
    {
      ASSERT_GE(value.x, 0);
    }
  }
}
