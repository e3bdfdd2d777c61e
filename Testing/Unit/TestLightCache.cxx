// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LightCacheSetting.h"

//------------------------------------------------------------------------------
TEST(LightCache, PrefilteringCentresTheErrorOfTrilinearLookups)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Smooth);
  const Light light = MakeDirectional({ 1, -0.4, 0.7 });
  vtkMediumLightCache cache;
  cache.Build(grid, light);
  double mean[2] = { 0, 0 };
  for (bool prefilter : { false, true })
  {
    const std::vector<float> transmittance = cache.GetTransmittance(1, prefilter);
    for (std::uint32_t i = 0; i < 4000; ++i)
    {
      const glm::dvec3 unit(Random(3 * i, 29), Random(3 * i + 1, 29), Random(3 * i + 2, 29));
      const glm::dvec3 at = 2.0 + unit * glm::dvec3(Points - 5); // off the border
      const glm::ivec3 cell(at);
      double value = 0;
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 bit(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 f = at - glm::dvec3(cell);
        const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(bit));
        value += w.x * w.y * w.z *
          transmittance[grid.GetIndex(cell.x + bit.x, cell.y + bit.y, cell.z + bit.z)];
      }
      mean[prefilter] += (value - std::exp(-vtkMediumLightOpticalDepth(grid, light, at))) / 4000;
    }
  }
  EXPECT_GT(mean[0], 1e-4) << "without the filter, convex functions are overestimated";
  EXPECT_LT(std::abs(mean[1]), 0.1 * mean[0]);
}

//------------------------------------------------------------------------------
TEST(LightCache, PacksTheTransmittanceOfTheScaledDensity)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Cloud);
  vtkMediumLightCache cache;
  cache.Build(grid, MakeDirectional({ 1, -0.4, 0.7 }));
  const std::vector<float> plain = cache.GetTransmittance(0.5, false);
  const std::vector<float> filtered = cache.GetTransmittance(0.5, true);
  std::vector<std::uint16_t> packed(2 * plain.size(), 7);
  cache.PackTransmittance(0.5, true, packed.data() + 1, 2);
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    ASSERT_FLOAT_EQ(plain[i], std::exp(-0.5f * cache.GetOpticalDepths()[i]));
    ASSERT_EQ(packed[2 * i + 1], vtkMediumHalfFromFloat(filtered[i]));
    ASSERT_EQ(packed[2 * i], 7) << "other channels are left alone";
  }
}

//------------------------------------------------------------------------------
TEST(LightCache, PoseLeavesOutColourAndAttenuation)
{
  Light a = MakePoint({ 0.1, 0.2, 0.3 });
  Light b = a;
  b.Irradiance = glm::dvec3(5);
  b.Attenuation = glm::dvec3(0, 0, 1);
  b.Direction = glm::dvec3(1, 0, 0); // which a point light has no use for
  EXPECT_TRUE(vtkMediumLightCache::HaveSamePose(a, b));
  b.Position.x += 1e-9;
  EXPECT_FALSE(vtkMediumLightCache::HaveSamePose(a, b));
  a = MakeDirectional({ 0, 0, 1 });
  b = MakeDirectional({ 0, 1e-6, 1 });
  EXPECT_FALSE(vtkMediumLightCache::HaveSamePose(a, b));
  b = a;
  b.Position = glm::dvec3(9);
  EXPECT_TRUE(vtkMediumLightCache::HaveSamePose(a, b));
  b.Type = Light::Spot;
  EXPECT_FALSE(vtkMediumLightCache::HaveSamePose(a, b));
}
