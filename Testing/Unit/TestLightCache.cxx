// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LightCacheSetting.h"

namespace
{
//------------------------------------------------------------------------------
std::vector<float> PlainTransmittance(const vtkMediumLightCache& cache, double densityScale)
{
  std::vector<float> values = cache.GetOpticalDepths();
  for (float& value : values)
  {
    value = std::exp(static_cast<float>(-densityScale) * std::max(value, 0.0f));
  }
  return values;
}

//------------------------------------------------------------------------------
double Interpolate(
  const vtkMediumExtinctionGrid& grid, const std::vector<float>& values, const glm::dvec3& at)
{
  const glm::ivec3 cell(at);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 bit(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 f = at - glm::dvec3(cell);
    const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(bit));
    sum += w.x * w.y * w.z * values[grid.GetIndex(cell.x + bit.x, cell.y + bit.y, cell.z + bit.z)];
  }
  return sum;
}
}

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
    const std::vector<float> transmittance =
      prefilter ? cache.GetTransmittance(1) : PlainTransmittance(cache, 1);
    for (std::uint32_t i = 0; i < 4000; ++i)
    {
      const glm::dvec3 unit(Random(3 * i, 29), Random(3 * i + 1, 29), Random(3 * i + 2, 29));
      const glm::dvec3 at = 2.0 + unit * glm::dvec3(Points - 5); // off the border
      mean[prefilter] += (Interpolate(grid, transmittance, at) -
                           std::exp(-vtkMediumLightOpticalDepth(grid, light, at))) /
        4000;
    }
  }
  EXPECT_GT(mean[0], 1e-4) << "without the filter, convex functions are overestimated";
  EXPECT_LT(std::abs(mean[1]), 0.1 * mean[0]);
}

//------------------------------------------------------------------------------
// On the faces of the lattice there is no second difference across them, and the first is none.
TEST(LightCache, FiltersFacesAsTheInside)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Smooth);
  vtkMediumLightCache cache;
  cache.Build(grid, MakeDirectional({ 1, -0.4, 0.7 }));
  const std::vector<float> plain = PlainTransmittance(cache, 1);
  const std::vector<float> filtered = cache.GetTransmittance(1);
  const std::vector<float> roughness = cache.GetRoughness(1);
  double inside[2] = { 0, 0 }, faces[2] = { 0, 0 };
  for (int k = 0; k < Points.z; ++k)
  {
    for (int j = 0; j < Points.y; ++j)
    {
      for (int i = 0; i < Points.x; ++i)
      {
        const bool face =
          i % (Points.x - 1) == 0 || j % (Points.y - 1) == 0 || k % (Points.z - 1) == 0;
        const std::size_t index = grid.GetIndex(i, j, k);
        if (cache.GetOpticalDepths()[index] < 0)
        {
          continue; // not needed, and so not known
        }
        double* largest = face ? faces : inside;
        largest[0] = std::max(largest[0], std::abs(double(filtered[index]) - plain[index]));
        largest[1] = std::max(largest[1], double(roughness[index]));
      }
    }
  }
  EXPECT_LE(faces[0], inside[0]);
  EXPECT_LE(faces[1], inside[1]);
}

//------------------------------------------------------------------------------
TEST(LightCache, PacksTheTransmittanceOfTheScaledDensity)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Cloud);
  vtkMediumLightCache cache;
  cache.Build(grid, MakeDirectional({ 1, -0.4, 0.7 }));
  const std::vector<float> plain = PlainTransmittance(cache, 0.5);
  const std::vector<float> filtered = cache.GetTransmittance(0.5);
  std::vector<std::uint16_t> packed(2 * plain.size(), 7);
  cache.Pack(0.5, { glm::ivec3(0), Points }, false, packed.data() + 1, 2);
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    ASSERT_FLOAT_EQ(plain[i], std::exp(-0.5f * std::max(cache.GetOpticalDepths()[i], 0.0f)));
    ASSERT_EQ(packed[2 * i + 1], vtkMediumHalfFromFloat(filtered[i]));
    ASSERT_EQ(packed[2 * i], 7) << "other channels are left alone";
  }
}

//------------------------------------------------------------------------------
// Second differences are not all there is to an error, but nearly.
TEST(LightCache, RoughnessIsWhatLookupsErrBy)
{
  for (auto field : { Smooth, Cloud, Binary })
  {
    const vtkMediumExtinctionGrid grid = MakeGrid(field);
    const Light light = MakeDirectional({ 1, -0.4, 0.7 });
    vtkMediumLightCache cache;
    cache.Build(grid, light);
    const std::vector<float> transmittance = cache.GetTransmittance(1);
    const std::vector<float> roughness = cache.GetRoughness(1);
    int beyond = 0, known = 0;
    for (std::uint32_t i = 0; i < 2000; ++i)
    {
      const glm::dvec3 unit(Random(3 * i, 31), Random(3 * i + 1, 31), Random(3 * i + 2, 31));
      const glm::dvec3 at = 2.0 + unit * glm::dvec3(Points - 5);
      const double value = Interpolate(grid, transmittance, at);
      const double rough = Interpolate(grid, roughness, at);
      const double error = std::abs(value - std::exp(-vtkMediumLightOpticalDepth(grid, light, at)));
      known += rough < 0.9 ? 1 : 0;
      beyond += rough < 0.9 && error > rough + 1e-4 ? 1 : 0;
    }
    EXPECT_GT(known, 1000) << field;
    EXPECT_LT(beyond, known / 12) << field;
  }
}

//------------------------------------------------------------------------------
// Light that grazes a face through which it enters a medium that begins there: one cell takes it from full
// light to hardly any, along a curve that bends the other way than the differences inside.
TEST(LightCache, RoughnessKnowsTheCellsWhereLightEnters)
{
  const auto image = MakeImage(Smooth, Points, Size);
  for (int i = 0; i < Points.x * Points.y * Points.z; ++i)
  {
    image->GetPointData()->GetScalars()->SetTuple1(
      i, i / Points.x % Points.y == Points.y - 1 ? 0 : 1);
  }
  vtkMediumExtinctionGrid grid;
  grid.Build(MakeScene(image, Sigma, false));
  const Light light = MakeDirectional({ -1, -0.1, 0.3 });
  vtkMediumLightCache cache;
  cache.Build(grid, light);
  const std::vector<float> transmittance = cache.GetTransmittance(1);
  const std::vector<float> roughness = cache.GetRoughness(1);
  double beyond = 0, errors = 0;
  for (std::uint32_t i = 0; i < 1000; ++i)
  {
    const glm::dvec3 at(2 + Random(3 * i, 37) * (Points.x - 9),
      Points.y - 2 + Random(3 * i + 1, 37),
      7 + Random(3 * i + 2, 37) * (Points.z - 9)); // from where light leaves by that face alone
    const double truth = std::exp(-vtkMediumLightOpticalDepth(grid, light, at));
    const double error = std::abs(Interpolate(grid, transmittance, at) - truth);
    beyond += std::max(error - Interpolate(grid, roughness, at), 0.0);
    errors += error;
  }
  EXPECT_GT(errors, 20) << "the light does graze";
  EXPECT_LT(beyond, 0.02 * errors);
}

//------------------------------------------------------------------------------
TEST(LightCache, PacksAPartAsItIsInTheWhole)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Cloud);
  vtkMediumLightCache cache;
  cache.Build(grid, MakeDirectional({ 1, -0.4, 0.7 }));
  std::vector<std::uint16_t> whole(2 * grid.GetValues().size());
  cache.Pack(1, { glm::ivec3(0), Points }, true, whole.data(), 2);
  const glm::ivec3 begins[] = { { 3, 5, 4 }, { 0, 0, 0 }, Points - 1 };
  const glm::ivec3 ends[] = { { 20, 6, 19 }, { 1, 1, 1 }, Points };
  for (int i = 0; i < 3; ++i)
  {
    const vtkMediumLatticePart part{ begins[i], ends[i] };
    std::vector<std::uint16_t> packed(2 * part.GetNumberOfPoints());
    cache.Pack(1, part, true, packed.data(), 2);
    std::size_t at = 0;
    for (int z = part.Begin.z; z < part.End.z; ++z)
    {
      for (int y = part.Begin.y; y < part.End.y; ++y)
      {
        for (int x = part.Begin.x; x < part.End.x; ++x, at += 2)
        {
          const std::size_t from = 2 * grid.GetIndex(x, y, z);
          ASSERT_EQ(packed[at], whole[from]) << i;
          ASSERT_EQ(packed[at + 1], whole[from + 1]) << i;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(LightCache, RoughnessIsOneWhereNothingIsKnown)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Binary);
  vtkMediumLightCache cache;
  cache.Build(grid, MakeDirectional({ 1, -0.4, 0.7 }));
  const std::vector<float> roughness = cache.GetRoughness(1);
  std::vector<std::uint16_t> packed(2 * roughness.size());
  cache.Pack(1, { glm::ivec3(0), Points }, true, packed.data(), 2);
  int unknown = 0;
  for (std::size_t i = 0; i < roughness.size(); ++i)
  {
    if (cache.GetOpticalDepths()[i] < 0)
    {
      ++unknown;
      ASSERT_EQ(roughness[i], 1);
    }
    ASSERT_EQ(packed[2 * i + 1], vtkMediumHalfFromFloat(roughness[i]));
  }
  EXPECT_GT(unknown, 0) << "the fixture has empty parts";
}

//------------------------------------------------------------------------------
// For while a light is dragged.
TEST(LightCache, OverHalfThePointsStaysCloseInSmoothMedia)
{
  for (bool onCells : { false, true })
  {
    const glm::ivec3 points(64, 57, 60);
    vtkMediumExtinctionGrid grid, coarse;
    grid.Build(MakeScene(MakeImage(Smooth, points, Size, onCells), Sigma, onCells));
    coarse.BuildCoarser(grid);
    for (const Light& light : { MakeDirectional({ 1, -0.4, 0.7 }), MakePoint({ 0.1, 0.6, 0.2 }) })
    {
      vtkMediumLightCache cache;
      cache.Build(coarse, light);
      const std::vector<float> transmittance = cache.GetTransmittance(1);
      double worst = 0;
      for (std::uint32_t i = 0; i < 1000; ++i)
      {
        const glm::dvec3 unit(Random(3 * i, 41), Random(3 * i + 1, 41), Random(3 * i + 2, 41));
        const glm::dvec3 at = 0.5 + unit * glm::dvec3(coarse.GetDimensions() - 2);
        const glm::dvec3 fine = grid.LocalToLattice(coarse.LatticeToLocal(at));
        const double truth = std::exp(-vtkMediumLightOpticalDepth(grid, light, fine));
        worst = std::max(worst, std::abs(Interpolate(coarse, transmittance, at) - truth));
      }
      EXPECT_LT(255 * worst, 3) << onCells << ' ' << light.Type;
    }
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
