// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Transmittance and the closed form of a segment on the device equal the same text in C++.
#include "ShaderComparison.h"

namespace
{
/// Optical depths from nothing to 1e30, with the switch of the segment's series at 0.166 and the hold
/// of transmittances at 80.
std::vector<Arguments> OpticalDepths()
{
  std::vector<Arguments> table;
  for (double decade = -9; decade <= 2; decade += 0.01)
  {
    const float x = static_cast<float>(std::pow(10.0, decade));
    table.push_back({ x, 2 * x, 0.5f * x });
  }
  for (float x : { 0.0f, 1e-45f, 1e-40f, 1e-38f, 1e-20f, 1e-8f, 0.1659f, 0.166f, 0.1661f, 79.99f,
         80.0f, 80.01f, 88.0f, 104.0f, 1e6f, 1e30f })
  {
    table.push_back({ x, x, x });
  }
  return table;
}

/// exp's relative error is the absolute one of its argument times log2(e), at most 80 x 2^-24 x 1.44
/// roundings of 7e-6, besides the device's exp2: llvmpipe's polynomial is good to 2e-7.
constexpr double ExponentialTolerance = 1.2e-5;

using namespace vtkMediumFormulas;
}

TEST_F(ShaderFormulas, TransmittanceEqualsCxx)
{
  ExpectFormula(
    GpuFormulas::Transmittance, OpticalDepths(), 4, ExponentialTolerance, [](const Arguments& a) {
      return glm::dvec4(
        Double::transmittance(a[0]), Double::transmittance(glm::dvec3(a[0], a[1], a[2])));
    });
}

TEST_F(ShaderFormulas, MeanTransmittanceEqualsCxx)
{
  // 1 - exp(-x) is off by a rounding unit or two of 1 at x = 0.166: 2e-7 / 0.15.
  ExpectFormula(
    GpuFormulas::SegmentMeanTransmittance, OpticalDepths(), 4, 3e-6, [](const Arguments& a) {
      return glm::dvec4(Double::segmentMeanTransmittance(a[0]),
        Double::segmentMeanTransmittance(glm::dvec3(a[0], a[1], a[2])));
    });
}

TEST_F(ShaderFormulas, MeanTransmittanceMeetsItsDefinition)
{
  // Against expm1, not against the same text: the series' 2.2e-7 comes on top.
  ExpectFormula(
    GpuFormulas::SegmentMeanTransmittance, OpticalDepths(), 1, 4e-6, [](const Arguments& a) {
      return glm::dvec4(a[0] > 0 ? -std::expm1(-double(a[0])) / a[0] : 1);
    });
}

TEST_F(ShaderFormulas, TransmittanceFallsAndStaysPositive)
{
  std::vector<Arguments> table;
  for (double x = 0; x < 200; x += 0.125)
  {
    table.push_back({ static_cast<float>(x) });
  }
  float before = 1;
  for (const glm::vec4& value : Device.Evaluate(GpuFormulas::Transmittance, table))
  {
    ASSERT_LE(value.x, before);
    ASSERT_GT(value.x, 0);
    before = value.x;
  }
}
