// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rays, lights and jitter on the device equal the same text in C++.
#include "ShaderComparison.h"

namespace
{
using namespace vtkMediumFormulas;

/// Origins inside, outside, on faces, edges and corners; directions with zeros of either sign,
/// denormals, and along faces.
std::vector<Arguments> Rays()
{
  std::vector<Arguments> table;
  const float places[] = { -2, -1e-6f, 0, 1e-8f, 0.5f, 1, 1.000001f, 3 };
  const float ways[] = { -1, -0.3f, -1e-20f, -1e-40f, -0.0f, 0, 1e-40f, 1e-29f, 0.7f, 1 };
  for (float x : places)
  {
    for (float y : { 0.0f, 0.25f, 1.0f })
    {
      for (float a : ways)
      {
        for (float b : { -0.6f, 0.0f, 1.0f })
        {
          table.push_back({ x, y, 0.75f, 0, a, b, 0.5f, 0 });
          table.push_back({ x, y, 0, 0, a, b, 0, 0 });
        }
      }
    }
  }
  return table;
}
}

TEST_F(ShaderFormulas, RayBoxEqualsCxx)
{
  // Held to C++ in float: a direction of 1e-40 is a float, and what is inside is decided in float.
  // One subtraction and one division of up to three units each.
  ExpectFormula(GpuFormulas::RayBox, Rays(), 2, 4 * Epsilon, [](const Arguments& a) {
    const glm::vec2 t = Float::rayBox(glm::vec3(a[0], a[1], a[2]), glm::vec3(a[4], a[5], a[6]));
    return glm::dvec4(t.x, t.y, 0, 0);
  });
}

TEST_F(ShaderFormulas, RayBoxOfARayInAFaceIsTheWayAlongIt)
{
  const std::vector<glm::vec4> t = Device.Evaluate(GpuFormulas::RayBox,
    { { 0, 0.25f, 0.5f, 0, 0, 1, 0, 0 }, { 1, 0.25f, 0.5f, 0, -0.0f, 1, 0, 0 },
      { 1.001f, 0.25f, 0.5f, 0, 0, 1, 0, 0 }, { 0.5f, 0.5f, -1, 0, 0, 0, 1, 0 } });
  EXPECT_FLOAT_EQ(t[0].x, -0.25f);
  EXPECT_FLOAT_EQ(t[0].y, 0.75f);
  EXPECT_FLOAT_EQ(t[1].x, -0.25f);
  EXPECT_FLOAT_EQ(t[1].y, 0.75f);
  EXPECT_GE(t[2].x, t[2].y); // beside the box
  EXPECT_FLOAT_EQ(t[3].x, 1);
  EXPECT_FLOAT_EQ(t[3].y, 2);
}

TEST_F(ShaderFormulas, LightAttenuationEqualsCxx)
{
  std::vector<Arguments> table;
  for (float r : { 0.0f, 1e-40f, 1e-8f, 9.9e-5f, 1e-4f, 0.5f, 1.0f, 1e4f, 1e15f })
  {
    table.push_back({ r, 0, 0, 0, 1, 0, 0 });
    table.push_back({ r, 0, 0, 0, 0, 1, 0 });
    table.push_back({ r, 0, 0, 0, 0, 0, 1 });
    table.push_back({ r, 0, 0, 0, 0.1f, 2, 3 });
    table.push_back({ r, 0, 0, 0, 0, 0, 0 });
  }
  ExpectFormula(GpuFormulas::LightAttenuation, table, 1, 6 * Epsilon, [](const Arguments& a) {
    return glm::dvec4(Double::lightAttenuation(a[0], glm::dvec3(a[4], a[5], a[6])));
  });
}

TEST_F(ShaderFormulas, LightSpotEqualsCxx)
{
  std::vector<Arguments> table;
  for (float cosine : { -1.0f, -0.5f, 0.0f, 1e-8f, 0.3f, 0.86f, 0.87f, 0.999f, 1.0f, 1.0000001f })
  {
    for (float cone : { -1.0f, 0.0f, 0.866f })
    {
      for (float exponent : { 0.0f, 0.5f, 1.0f, 2.0f, 30.0f })
      {
        table.push_back({ cosine, cone, exponent });
      }
    }
  }
  // pow(x, 30) = exp2(30 log2 x): llvmpipe's log2 and exp2 are good to some 1e-7, times 30.
  ExpectFormula(GpuFormulas::LightSpot, table, 1, 3e-5,
    [](const Arguments& a) { return glm::dvec4(Double::lightSpot(a[0], a[1], a[2])); });
}

TEST_F(ShaderFormulas, LightDirectionEqualsCxx)
{
  std::vector<Arguments> table;
  for (float scale : { 0.0f, 1e-40f, 1e-20f, 1e-14f, 1e-3f, 1.0f, 1e10f })
  {
    table.push_back({ scale, -2 * scale, 0.5f * scale, 0, 0, 1, 0 });
    table.push_back({ 0, 0, scale, 0, 0, 1, 0 });
  }
  ExpectFormula(GpuFormulas::LightDirection, table, 3, 6 * Epsilon, [](const Arguments& a) {
    const glm::dvec3 d =
      Double::lightDirection(glm::dvec3(a[0], a[1], a[2]), glm::dvec3(a[4], a[5], a[6]));
    return glm::dvec4(d, 0);
  });
}

TEST_F(ShaderFormulas, JitterIsTheSameNumberOnEveryDevice)
{
  std::vector<Arguments> table;
  for (float high : { 0.0f, 1.0f, 255.0f, 65535.0f })
  {
    for (float x : { 0.0f, 1.0f, 63.0f, 1023.0f, 65535.0f })
    {
      for (float y : { 0.0f, 1.0f, 62.0f, 4097.0f })
      {
        table.push_back({ high, x, 0, y, high, 7 });
        table.push_back({ 0, x, high, y, 0, 0 });
      }
    }
  }
  const std::vector<glm::vec4> values = Device.Evaluate(GpuFormulas::JitterOffset, table);
  auto whole = [](float high, float low) {
    return static_cast<unsigned int>(high) * 65536u + static_cast<unsigned int>(low);
  };
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const Arguments& a = table[i];
    ASSERT_EQ(
      values[i].x, Float::jitterOffset(whole(a[0], a[1]), whole(a[2], a[3]), whole(a[4], a[5])));
    ASSERT_GE(values[i].x, 0);
    ASSERT_LT(values[i].x, 1);
  }
}

TEST_F(ShaderFormulas, LightSegmentEqualsCxx)
{
  std::vector<Arguments> table;
  for (float across : { 1e-3f, 0.03f, 0.4f })
  {
    for (float along : { -0.35f, -0.05f, 0.02f, 0.3f })
    {
      // The offset and the width; the direction and the softening.
      table.push_back({ across, 0, along, 0.05f, 0, 0, 1, 0.001f });
    }
  }
  // Mesa's arc tangent is a polynomial, good to 3e-5 of a small angle.
  ExpectFormula(GpuFormulas::LightSegment, table, 1, 1e-4, [](const Arguments& a) {
    const glm::dvec2 segment =
      Double::lightSegment(glm::dvec3(a[0], a[1], a[2]), glm::dvec3(a[4], a[5], a[6]), a[3], a[7]);
    return glm::dvec4(segment, 0, 0);
  });
}
