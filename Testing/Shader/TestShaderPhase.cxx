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
      table.push_back({ 1 - cosine, 1 + cosine, g });
    }
  }
  return table;
}

using namespace vtkMediumFormulas;

/// The angle of a row's first two arguments.
glm::dvec2 AngleOf(const Arguments& a)
{
  return { a[0], a[1] };
}
}

TEST_F(ShaderFormulas, IsotropicEqualsCxx)
{
  ExpectFormula(GpuFormulas::PhaseIsotropic, { {} }, 1, 2 * Epsilon,
    [](const Arguments&) { return glm::dvec4(Double::phaseIsotropic()); });
}

TEST_F(ShaderFormulas, HenyeyGreensteinEqualsCxx)
{
  ExpectFormula(GpuFormulas::PhaseHenyeyGreenstein, CosinesAndAnisotropies(), 1, PeakTolerance,
    [](const Arguments& a) { return glm::dvec4(Double::phaseHenyeyGreenstein(AngleOf(a), a[2])); });
}

TEST_F(ShaderFormulas, SchlickEqualsCxx)
{
  ExpectFormula(GpuFormulas::PhaseSchlick, CosinesAndAnisotropies(), 1, PeakTolerance,
    [](const Arguments& a) { return glm::dvec4(Double::phaseSchlick(AngleOf(a), a[2])); });
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
        table.push_back({ a[0], a[1], a[2], second, weight });
      }
    }
  }
  ExpectFormula(
    GpuFormulas::PhaseDoubleHenyeyGreenstein, table, 1, PeakTolerance, [](const Arguments& a) {
      return glm::dvec4(Double::phaseDoubleHenyeyGreenstein(AngleOf(a), a[2], a[3], a[4]));
    });
}

TEST_F(ShaderFormulas, RayleighEqualsCxx)
{
  std::vector<Arguments> table;
  for (float cosine : Cosines)
  {
    table.push_back({ 1 - cosine, 1 + cosine });
  }
  ExpectFormula(GpuFormulas::PhaseRayleigh, table, 1, 4 * Epsilon,
    [](const Arguments& a) { return glm::dvec4(Double::phaseRayleigh(AngleOf(a))); });
}

TEST_F(ShaderFormulas, DraineAndDropletsEqualCxx)
{
  std::vector<Arguments> table;
  for (const Arguments& a : CosinesAndAnisotropies())
  {
    for (float alpha : { 0.0f, 1e-8f, 1.0f, 250.0f })
    {
      table.push_back({ a[0], a[1], a[2], alpha, 0.8f, 0.4f });
    }
  }
  ExpectFormula(GpuFormulas::PhaseDraine, table, 1, PeakTolerance,
    [](const Arguments& a) { return glm::dvec4(Double::phaseDraine(AngleOf(a), a[2], a[3])); });
  ExpectFormula(GpuFormulas::PhaseDroplets, table, 1, PeakTolerance, [](const Arguments& a) {
    return glm::dvec4(Double::phaseDroplets(AngleOf(a), a[2], a[3], a[4], a[5]));
  });
}

TEST_F(ShaderFormulas, TableCoordinateEqualsCxx)
{
  std::vector<Arguments> table;
  for (float cosine : { -1.0f, -0.999f, 0.0f, 0.25f, 1.0f, 1.0001f })
  {
    for (float size : { 2.0f, 3.0f, 181.0f, 4096.0f })
    {
      table.push_back({ 1 - cosine, 1 + cosine, size });
    }
  }
  ExpectFormula(GpuFormulas::PhaseTableCoordinate, table, 1, 2 * Epsilon,
    [](const Arguments& a) { return glm::dvec4(Double::phaseTableCoordinate(AngleOf(a), a[2])); });
}

TEST_F(ShaderFormulas, PhaseAngleEqualsCxxToTheLastDigits)
{
  std::vector<Arguments> table;
  for (float theta : { 0.0f, 1e-4f, 1e-3f, 0.1f, 1.0f, 3.0f, 3.1406f })
  {
    // Arguments 4 to 6 are the second vector.
    table.push_back({ std::sin(theta), 0, std::cos(theta), 0, 0, 0, 1 });
  }
  ExpectFormula(GpuFormulas::PhaseAngle, table, 2, 8 * Epsilon, [](const Arguments& a) {
    const glm::dvec2 angle =
      Double::phaseAngle(glm::dvec3(a[0], a[1], a[2]), glm::dvec3(a[4], a[5], a[6]));
    return glm::dvec4(angle, 0, 0);
  });
}

TEST_F(ShaderFormulas, PhaseFunctionsAreNeverNegative)
{
  std::vector<Arguments> table;
  for (int i = 0; i <= 100; ++i)
  {
    for (float g : { -1.0f, -0.97f, -0.94f, 0.938f, 0.95f, 0.97f, 0.999f, 1.0f })
    {
      table.push_back({ 2 - i * 0.02f, i * 0.02f, g });
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
