// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Laws of positional lights.
#include "FormulaTypes.h"
#include "vtkMediumClosedForms.h"

#include <cmath>

template <typename F>
class FormulasLight : public ::testing::Test
{
};
TYPED_TEST_SUITE(FormulasLight, FormulaTypes);

TYPED_TEST(FormulasLight, AttenuationIsTheReciprocalOfTheQuadratic)
{
  using real = typename TypeParam::real;
  using vec3 = typename TypeParam::vec3;
  for (double r : { 1e-4, 1e-3, 0.02, 0.5, 1.0, 30.0, 1e8 })
  {
    EXPECT_EQ(TypeParam::Attenuation(real(r), vec3(1, 0, 0)), 1);
    EXPECT_NEAR(
      TypeParam::Attenuation(real(r), vec3(0, 0, 1)) * r * r, 1, 4 * Epsilon<TypeParam>());
    const double plain = 1 / (0.5 + 2 * r + 3 * r * r);
    EXPECT_NEAR(
      TypeParam::Attenuation(real(r), vec3(real(0.5), 2, 3)) / plain, 1, 8 * Epsilon<TypeParam>());
  }
}

TYPED_TEST(FormulasLight, AttenuationIsHeldNearTheLight)
{
  using real = typename TypeParam::real;
  using vec3 = typename TypeParam::vec3;
  const real held = TypeParam::Attenuation(real(1e-4), vec3(0, 0, 1));
  EXPECT_NEAR(held, 1e8, 100);
  EXPECT_EQ(TypeParam::Attenuation(real(0), vec3(0, 0, 1)), held);
  EXPECT_EQ(TypeParam::Attenuation(real(3e-5), vec3(0, 0, 1)), held);
  EXPECT_TRUE(std::isfinite(TypeParam::Attenuation(real(0), vec3(0, 0, 0))));
}

TYPED_TEST(FormulasLight, SpotIsDarkOutsideItsConeAndFallsByItsExponentInside)
{
  using real = typename TypeParam::real;
  const real cone = static_cast<real>(std::cos(0.5));
  EXPECT_EQ(TypeParam::Spot(cone - real(1e-6), cone, 1), 0);
  EXPECT_EQ(TypeParam::Spot(-1, cone, 0), 0);
  EXPECT_GT(TypeParam::Spot(cone, cone, 1), 0);
  EXPECT_EQ(TypeParam::Spot(1, cone, 64), 1);
  EXPECT_EQ(TypeParam::Spot(real(0.9), cone, 0), 1);
  for (double exponent : { 0.5, 1.0, 3.0, 20.0 })
  {
    EXPECT_NEAR(TypeParam::Spot(real(0.95), cone, real(exponent)) / std::pow(0.95, exponent), 1,
      64 * Epsilon<TypeParam>()); // pow multiplies the logarithm's error by the exponent
  }
}

TYPED_TEST(FormulasLight, SpotNeverRaisesZeroOrANegativeNumberToAPower)
{
  using real = typename TypeParam::real;
  const real wide = -1; // a cone wide open
  EXPECT_EQ(TypeParam::Spot(0, wide, 0), 1);
  EXPECT_EQ(TypeParam::Spot(0, wide, 1), 0);
  EXPECT_EQ(TypeParam::Spot(real(-0.3), wide, real(0.5)), 0);
  EXPECT_EQ(TypeParam::Spot(1 + 2 * Epsilon<TypeParam>(), wide, 128), 1);
}

TYPED_TEST(FormulasLight, DirectionHasUnitLengthOrIsTheFallback)
{
  using real = typename TypeParam::real;
  using vec3 = typename TypeParam::vec3;
  const vec3 up(0, 0, 1);
  EXPECT_EQ(TypeParam::LightDirection(vec3(0), up), up);
  EXPECT_EQ(TypeParam::LightDirection(vec3(real(1e-20)), up), up);
  for (double scale : { 1e-12, 1e-3, 1.0, 1e8 })
  {
    const vec3 found =
      TypeParam::LightDirection(vec3(real(2), real(-3), real(6)) * real(scale), up);
    EXPECT_NEAR(found.x, 2.0 / 7, 4 * Epsilon<TypeParam>());
    EXPECT_NEAR(found.y, -3.0 / 7, 4 * Epsilon<TypeParam>());
    EXPECT_NEAR(found.z, 6.0 / 7, 4 * Epsilon<TypeParam>());
  }
}

// The mean of 1 / (r^2 + softening) over a segment, and its mean place, against Simpson's rule in the angle.
TYPED_TEST(FormulasLight, SegmentIsTheMeanOfTheInverseSquareAndItsPlace)
{
  using F = TypeParam;
  using real = typename F::real;
  using vec3 = typename F::vec3;
  for (double across : { 1e-3, 0.02, 1.0 })
  {
    for (double along : { -0.3, -0.05, 0.0, 1e-3, 0.2 })
    {
      for (double softening : { 0.0, 0.01 })
      {
        const double width = 0.1, apart = std::sqrt(across * across + softening);
        const double begin = std::atan((-0.05 - along) / apart);
        const double end = std::atan((0.05 - along) / apart);
        const double mean = (end - begin) / apart / width;
        const double place = vtkMediumTest::Simpson(begin, end, 4000,
                               [&](double angle) { return along + apart * std::tan(angle); }) /
          (end - begin);
        const typename F::vec2 found = F::LightSegment(
          vec3(real(across), 0, real(along)), vec3(0, 0, 1), real(width), real(softening));
        // The angle is small where the light is far along the ray or beside it; the logarithm of a quotient
        // near 1 loses (r / width)^2 of the digits.
        EXPECT_NEAR(found.x / mean, 1, 64 * Epsilon<F>() + 1e-12) << across << " " << along;
        EXPECT_NEAR(found.y, place, 2e4 * Epsilon<F>() * width * (across * across + 0.01) + 1e-9)
          << across << " " << along << " " << softening;
      }
    }
  }
}

TYPED_TEST(FormulasLight, SegmentStaysFiniteWhereTheRayMeetsTheLight)
{
  using F = TypeParam;
  using real = typename F::real;
  using vec3 = typename F::vec3;
  for (double along : { -0.05, 0.0, 0.02, 0.05, 0.3 })
  {
    const typename F::vec2 found =
      F::LightSegment(vec3(0, 0, real(along)), vec3(0, 0, 1), real(0.1), 0);
    EXPECT_TRUE(std::isfinite(found.x) && found.x > 0);
    EXPECT_LE(found.x, vtkMediumTest::Pi / (0.1 * 1e-4) * (1 + 1e-6)); // at the minimum radius
    EXPECT_LE(std::abs(found.y), 0.05 * (1 + 1e-6));
  }
}
