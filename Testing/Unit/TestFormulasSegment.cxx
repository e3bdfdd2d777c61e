// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Laws of Beer's law and of the closed form of a segment.
#include "FormulaTypes.h"

#include <cmath>

namespace
{
long double PlainMeanTransmittance(long double x)
{
  return -std::expm1(-x) / x;
}

// The series keeps 1.8e-7 at the switch in either type; float's 1 - exp(-x) adds 1e-7/0.15.
template <typename F>
constexpr double Tolerance()
{
  return 2.2e-7 + 5 * Epsilon<F>();
}

constexpr double Switch = 0.166;
}

template <typename F>
class FormulasSegment : public ::testing::Test
{
};
TYPED_TEST_SUITE(FormulasSegment, FormulaTypes);

TYPED_TEST(FormulasSegment, MeanTransmittanceMeetsExpm1OverSixteenDecades)
{
  using real = typename TypeParam::real;
  for (double decade = -12; decade <= 4; decade += 0.0078125)
  {
    const real x = static_cast<real>(std::pow(10.0, decade));
    ASSERT_NEAR(
      TypeParam::MeanTransmittance(x) / PlainMeanTransmittance(x), 1, Tolerance<TypeParam>())
      << "x " << x;
  }
  EXPECT_EQ(TypeParam::MeanTransmittance(real(0)), 1);
}

TYPED_TEST(FormulasSegment, MeanTransmittanceIsContinuousAndFallsAcrossTheSwitch)
{
  using real = typename TypeParam::real;
  const int steps = 2000;
  real before = TypeParam::MeanTransmittance(real(0.8 * Switch));
  for (int i = 1; i <= steps; ++i)
  {
    const real x = static_cast<real>(Switch * (0.8 + 0.4 * i / steps));
    const real value = TypeParam::MeanTransmittance(x);
    ASSERT_LT(value, before) << "x " << x; // each step changes it by 1.5e-5
    ASSERT_NEAR(value / PlainMeanTransmittance(x), 1, Tolerance<TypeParam>()) << "x " << x;
    before = value;
  }
}

TYPED_TEST(FormulasSegment, MeanTransmittanceNeverRises)
{
  using real = typename TypeParam::real;
  real before = 1;
  for (double decade = -12; decade <= 4; decade += 0.00390625)
  {
    const real value = TypeParam::MeanTransmittance(static_cast<real>(std::pow(10.0, decade)));
    ASSERT_LE(value, before * (1 + 2 * Epsilon<TypeParam>())) << "decade " << decade;
    before = value;
  }
}

// Against Simpson's rule in long double; rising, falling and level exponents.
TYPED_TEST(FormulasSegment, MeanOverALinearExponentIsItsIntegral)
{
  using real = typename TypeParam::real;
  for (double first : { 0.0, 1e-6, 0.3, 4.0, 30.0 })
  {
    for (double last : { 0.0, 1e-6, 0.31, 5.0, 60.0 })
    {
      const int parts = 4096;
      long double sum = 0;
      for (int i = 0; i <= parts; ++i)
      {
        const long double tau = first + (last - first) * (long double)(i) / parts;
        sum += (i == 0 || i == parts ? 1 : 2 + 2 * (i % 2)) * std::exp(-tau);
      }
      const double truth = static_cast<double>(sum / (3 * parts));
      EXPECT_NEAR(TypeParam::MeanTransmittance(real(first), real(last)) / truth, 1,
        1e-7 + Tolerance<TypeParam>() + 60 * Epsilon<TypeParam>())
        << first << " to " << last;
      EXPECT_EQ(TypeParam::MeanTransmittance(real(first), real(last)),
        TypeParam::MeanTransmittance(real(last), real(first)));
    }
  }
}

TYPED_TEST(FormulasSegment, VectorFormsActOnEachComponent)
{
  using vec3 = typename TypeParam::vec3;
  using real = typename TypeParam::real;
  const vec3 x(real(1e-4), real(0.3), real(7));
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(TypeParam::MeanTransmittance(x)[c], TypeParam::MeanTransmittance(x[c]));
    EXPECT_EQ(TypeParam::Transmittance(x)[c], TypeParam::Transmittance(x[c]));
    EXPECT_EQ(
      TypeParam::MeanTransmittance(x, vec3(1))[c], TypeParam::MeanTransmittance(x[c], real(1)));
  }
}

TYPED_TEST(FormulasSegment, TransmittanceIsMultiplicativeOverSplits)
{
  using real = typename TypeParam::real;
  for (double a : { 0.0, 1e-8, 1e-3, 0.4, 3.0, 20.0, 39.0 })
  {
    for (double b : { 0.0, 1e-6, 0.7, 11.0, 40.0 })
    {
      const double product =
        double(TypeParam::Transmittance(real(a))) * TypeParam::Transmittance(real(b));
      // exp's relative error is the absolute one of its argument: 80 rounding units at most.
      EXPECT_NEAR(
        TypeParam::Transmittance(real(a) + real(b)) / product, 1, 80 * Epsilon<TypeParam>());
    }
  }
}

TYPED_TEST(FormulasSegment, TransmittanceFallsFromOneAndStaysANormalNumber)
{
  using real = typename TypeParam::real;
  EXPECT_EQ(TypeParam::Transmittance(real(0)), 1);
  EXPECT_NEAR(TypeParam::Transmittance(real(1)), std::exp(-1.0), Epsilon<TypeParam>());
  for (real tau : { real(88), real(104), real(1e6), real(1e30) })
  {
    const real value = TypeParam::Transmittance(tau);
    EXPECT_LT(value, 1e-34);
    EXPECT_TRUE(std::isnormal(value));
  }
}
