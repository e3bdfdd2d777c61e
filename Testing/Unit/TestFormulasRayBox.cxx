// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Laws of the ray-box test, against a slab test in long double.
#include "FormulaTypes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
struct Interval
{
  long double First = -INFINITY;
  long double Last = INFINITY;
  bool IsHit() const { return this->First < this->Last; }
};

template <typename Vec3>
Interval PlainSlabs(Vec3 origin, Vec3 direction)
{
  Interval ray;
  for (int axis = 0; axis < 3; ++axis)
  {
    const long double o = origin[axis], d = direction[axis];
    if (d == 0)
    {
      if (o < 0 || o > 1)
      {
        ray.Last = -INFINITY;
      }
      continue;
    }
    ray.First = std::max(ray.First, std::min(-o / d, (1 - o) / d));
    ray.Last = std::min(ray.Last, std::max(-o / d, (1 - o) / d));
  }
  return ray;
}
}

template <typename F>
class FormulasRayBox : public ::testing::Test
{
};
TYPED_TEST_SUITE(FormulasRayBox, FormulaTypes);

TYPED_TEST(FormulasRayBox, MeetsTheSlabTestOnEveryMixOfSpecialNumbers)
{
  using real = typename TypeParam::real;
  using vec3 = typename TypeParam::vec3;
  const real denormal = std::numeric_limits<real>::denorm_min();
  const real origins[] = { real(-2), real(-0.0), real(0), real(0.25), real(1), real(1.5) };
  const real directions[] = { real(-1), real(-1e-5), -denormal, real(-0.0), real(0), denormal,
    real(1e-38), real(1e-3), real(1) };
  int hits = 0, misses = 0;
  for (int i = 0; i < 216; ++i)
  {
    const vec3 origin(origins[i % 6], origins[i / 6 % 6], origins[i / 36]);
    for (int j = 0; j < 729; ++j)
    {
      const vec3 direction(directions[j % 9], directions[j / 9 % 9], directions[j / 81]);
      const real longest =
        std::max({ std::abs(direction.x), std::abs(direction.y), std::abs(direction.z) });
      if (longest < real(1e-5))
      {
        continue; // not a direction
      }
      vec3 parallel = direction; // what cannot cross the box in 1e30 lengths is parallel to it
      for (int axis = 0; axis < 3; ++axis)
      {
        parallel[axis] = std::abs(direction[axis]) < real(1e-30) ? real(0) : direction[axis];
      }
      const Interval expected = PlainSlabs(origin, parallel);
      const auto found = TypeParam::RayBox(origin, direction);
      ASSERT_FALSE(std::isnan(found.x) || std::isnan(found.y));
      // A ray that only touches an edge may go either way by rounding.
      if (std::abs(expected.Last - expected.First) <= 1e-6L * std::abs(expected.First))
      {
        continue;
      }
      ASSERT_EQ(found.x < found.y, expected.IsHit())
        << "origin " << origin.x << " " << origin.y << " " << origin.z << " direction "
        << direction.x << " " << direction.y << " " << direction.z;
      if (expected.IsHit())
      {
        ++hits;
        ASSERT_NEAR(found.x, expected.First, 4 * Epsilon<TypeParam>() * std::abs(expected.First));
        ASSERT_NEAR(found.y, expected.Last, 4 * Epsilon<TypeParam>() * std::abs(expected.Last));
      }
      else
      {
        ++misses;
      }
    }
  }
  EXPECT_GT(hits, 10000);
  EXPECT_GT(misses, 10000);
}

TYPED_TEST(FormulasRayBox, MeetsTheSlabTestOnRandomRays)
{
  using real = typename TypeParam::real;
  using vec3 = typename TypeParam::vec3;
  const unsigned seed = 20240501;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 2), way(-1, 1);
  int hits = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const vec3 origin(real(place(random)), real(place(random)), real(place(random)));
    const vec3 direction(real(way(random)), real(way(random)), real(way(random)));
    const Interval expected = PlainSlabs(origin, direction);
    const auto found = TypeParam::RayBox(origin, direction);
    if (std::abs(expected.Last - expected.First) < 1e-5L * std::abs(expected.First))
    {
      continue; // grazes an edge
    }
    ASSERT_EQ(found.x < found.y, expected.IsHit());
    if (expected.IsHit())
    {
      ++hits;
      ASSERT_NEAR(found.x, expected.First, 4 * Epsilon<TypeParam>() * std::abs(expected.First));
      ASSERT_NEAR(found.y, expected.Last, 4 * Epsilon<TypeParam>() * std::abs(expected.Last));
    }
  }
  EXPECT_GT(hits, 20000);
}

TYPED_TEST(FormulasRayBox, PointsOfTheIntervalAreInsideAndOthersOutside)
{
  using real = typename TypeParam::real;
  using vec3 = typename TypeParam::vec3;
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.5, 1.5), way(-1, 1), along(-4, 4);
  for (int i = 0; i < 100000; ++i)
  {
    const vec3 origin(real(place(random)), real(place(random)), real(place(random)));
    const vec3 direction(real(way(random)), real(way(random)), real(way(random)));
    const auto found = TypeParam::RayBox(origin, direction);
    const double t = along(random);
    double outside = -1; // how far beyond the nearest face, < 0 inside
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = origin[axis] + t * direction[axis];
      outside = std::max({ outside, -x, x - 1 });
    }
    if (std::abs(outside) > 1e-5) // nearer to a face rounding may decide
    {
      ASSERT_EQ(found.x < t && t < found.y, outside < 0) << i;
    }
  }
}
