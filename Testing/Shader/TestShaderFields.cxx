// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Trilinear interpolation by eight look-ups, for devices whose filter rounds its weights: against the
// definition in double, and against the filter of this device.
#include "GpuFormulas.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace
{
const glm::ivec3 Size(5, 4, 7); // not the same along any two axes

/// Values in 0...1 without a pattern.
std::vector<float> Values(const glm::ivec3& size)
{
  std::vector<float> values;
  for (int i = 0; i < size.x * size.y * size.z; ++i)
  {
    values.push_back(static_cast<float>(std::fmod(0.61803398875 * i * i + 0.3 * i, 1.0)));
  }
  return values;
}

/// Texture coordinates inside, on texel centres, on faces, and beyond them.
std::vector<Arguments> Coordinates()
{
  std::vector<Arguments> table;
  for (int i = 0; i < 2000; ++i)
  {
    const auto along = [&](double step) {
      return static_cast<float>(std::fmod(step * i, 1.4) - 0.2);
    };
    table.push_back({ along(0.618034), along(0.414214), along(0.732051) });
  }
  for (int i = 0; i < 5 * 4 * 7; ++i)
  {
    table.push_back({ (i % 5 + 0.5f) / 5, (i / 5 % 4 + 0.5f) / 4, (i / 20 + 0.5f) / 7 });
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    table.push_back({ float(corner & 1), float(corner >> 1 & 1), float(corner >> 2) });
  }
  return table;
}

/// At a lattice coordinate, 0 at the first value.
double Trilinear(
  const std::vector<float>& values, const glm::ivec3& size, const glm::dvec3& coordinate)
{
  const glm::dvec3 at = glm::clamp(coordinate, glm::dvec3(0), glm::dvec3(size - 1));
  double sum = 0;
  for (int z = 0; z < size.z; ++z)
  {
    for (int y = 0; y < size.y; ++y)
    {
      for (int x = 0; x < size.x; ++x)
      {
        const glm::dvec3 hat =
          glm::max(1.0 - glm::abs(at - glm::dvec3(x, y, z)), glm::dvec3(0)); // of each value
        sum += hat.x * hat.y * hat.z * values[(z * size.y + y) * size.x + x];
      }
    }
  }
  return sum;
}

std::vector<glm::vec4> Interpolate(const std::string& defines)
{
  GpuFormulas device("#define FIELD_COUNT 1\n" + defines);
  EXPECT_TRUE(device.IsCompiled());
  device.SetField(Size, Values(Size));
  return device.Evaluate(GpuFormulas::FieldInterpolate, Coordinates());
}
}

TEST(ShaderFields, EightLookUpsAreTrilinear)
{
  const std::vector<float> values = Values(Size);
  const std::vector<Arguments> table = Coordinates();
  const std::vector<glm::vec4> found = Interpolate("#define COARSE_FILTER\n");
  double largest = 0;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    // A coordinate in texels, up to 7, is rounded by 2.4e-7, and values differ by up to 1 a texel.
    const glm::dvec3 at =
      glm::dvec3(table[i][0], table[i][1], table[i][2]) * glm::dvec3(Size) - 0.5;
    largest = std::max(largest, std::abs(found[i].x - Trilinear(values, Size, at)));
  }
  EXPECT_LT(largest, 3 * 2.4e-7 + 3e-7);
}

TEST(ShaderFields, EightLookUpsEqualTheFilterOfTheDevice)
{
  const std::vector<glm::vec4> precise = Interpolate("#define COARSE_FILTER\n");
  const std::vector<glm::vec4> filtered = Interpolate("");
  ASSERT_EQ(precise.size(), filtered.size());
  for (std::size_t i = 0; i < precise.size(); ++i)
  {
    ASSERT_NEAR(
      precise[i].x, filtered[i].x, 3.0 / 256); // weights of 8 bits along three axes, at worst
  }
}

// In 3 x 2 x 1 blocks: between all values, on them, a little to both sides of them, and beyond the lattice.
TEST(ShaderFields, FoldedFieldsAreTrilinearOverTheirSeams)
{
  const glm::ivec3 size(25, 14, 2);
  constexpr int limit = 12;
  ASSERT_EQ(vtkMediumFold(size, limit).GetBlocks(), glm::ivec3(3, 2, 1));
  const std::vector<float> values = Values(size);
  std::vector<Arguments> table;
  for (int i = 0; i < 4 * size.x * size.y * size.z; ++i)
  {
    const float shift = i % 4 == 0 ? 0.0f : i % 4 == 1 ? 1e-5f : i % 4 == 2 ? -1e-5f : 0.37f;
    const int value = i / 4;
    table.push_back({ value % size.x + shift, value / size.x % size.y + 2 * shift - 0.3f,
      value / (size.x * size.y) - shift });
  }
  for (const char* filter : { "#define COARSE_FILTER\n", "" })
  {
    GpuFormulas device(std::string("#define FIELD_COUNT 1\n#define FOLDED\n") + filter);
    ASSERT_TRUE(device.IsCompiled());
    device.SetField(size, values, limit);
    const std::vector<glm::vec4> found = device.Evaluate(GpuFormulas::FieldInterpolate, table);
    // As above, of coordinates up to 25; and a device's filter.
    const double allowed = filter[0] ? 3 * 2e-6 + 3e-7 : 3.0 / 256;
    for (std::size_t i = 0; i < table.size(); ++i)
    {
      const glm::dvec3 at(table[i][0], table[i][1], table[i][2]);
      ASSERT_NEAR(found[i].x, Trilinear(values, size, at), allowed)
        << at.x << ' ' << at.y << ' ' << at.z;
    }
  }
}
