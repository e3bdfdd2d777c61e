// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Laws of the pixel jitter. It is deterministic, so these tests cannot fail by chance; their bounds
// are those that independent uniform numbers keep with five standard errors.
#include "FormulaTypes.h"

#include <cmath>
#include <set>

namespace
{
constexpr unsigned Size = 512;
constexpr double Count = double(Size) * Size;

// The correlation between a pixel's number and that of another pixel, or of the next seed.
template <typename F>
double Correlation(unsigned dx, unsigned dy, unsigned dseed)
{
  double sum = 0;
  for (unsigned y = 0; y < Size; ++y)
  {
    for (unsigned x = 0; x < Size; ++x)
    {
      sum += (F::Jitter(x, y, 3) - 0.5) * (F::Jitter(x + dx, y + dy, 3 + dseed) - 0.5);
    }
  }
  return 12 * sum / Count;
}
}

template <typename F>
class FormulasJitter : public ::testing::Test
{
};
TYPED_TEST_SUITE(FormulasJitter, FormulaTypes);

TYPED_TEST(FormulasJitter, IsUniformInTheUnitInterval)
{
  for (unsigned seed : { 0u, 1u, 77u, 0xffffffffu })
  {
    double sum = 0, squares = 0;
    int bins[16] = {};
    for (unsigned y = 0; y < Size; ++y)
    {
      for (unsigned x = 0; x < Size; ++x)
      {
        const double value = TypeParam::Jitter(x, y, seed);
        ASSERT_GE(value, 0);
        ASSERT_LT(value, 1);
        sum += value;
        squares += value * value;
        ++bins[static_cast<int>(16 * value)];
      }
    }
    const double mean = sum / Count;
    EXPECT_NEAR(mean, 0.5, 5 * std::sqrt(1 / 12.0 / Count));
    EXPECT_NEAR(squares / Count - mean * mean, 1 / 12.0, 5 * std::sqrt(1 / 180.0 / Count));
    for (int bin : bins)
    {
      EXPECT_NEAR(bin, Count / 16, 5 * std::sqrt(Count / 16));
    }
  }
}

TYPED_TEST(FormulasJitter, NeighboursAndSeedsAreUncorrelated)
{
  const double bound = 5 / std::sqrt(Count);
  for (unsigned dy = 0; dy < 3; ++dy)
  {
    for (unsigned dx = dy ? 0 : 1; dx < 3; ++dx)
    {
      EXPECT_NEAR(Correlation<TypeParam>(dx, dy, 0), 0, bound) << dx << " " << dy;
    }
  }
  EXPECT_NEAR(Correlation<TypeParam>(0, 0, 1), 0, bound);
}

TYPED_TEST(FormulasJitter, SwappedCoordinatesGiveOtherNumbers)
{
  std::set<double> seen;
  for (unsigned y = 0; y < 16; ++y)
  {
    for (unsigned x = 0; x < 16; ++x)
    {
      seen.insert(TypeParam::Jitter(x, y, 0));
    }
  }
  EXPECT_EQ(seen.size(), 256u);
}

TEST(FormulasJitterTypes, FloatAndDoubleGiveTheSameNumber)
{
  for (unsigned x = 0; x < 4096; ++x)
  {
    ASSERT_EQ(
      double(FloatFormulas::Jitter(x, 1000 - x, 5)), DoubleFormulas::Jitter(x, 1000 - x, 5));
  }
}
