// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumHalf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
TEST(Half, AllFiniteHalvesSurviveTheRoundTrip)
{
  for (std::uint32_t bits = 0; bits < 65536; ++bits)
  {
    const std::uint16_t half = static_cast<std::uint16_t>(bits);
    if ((half & 0x7c00) != 0x7c00)
    {
      ASSERT_EQ(vtkMediumHalfFromFloat(vtkMediumHalfToFloat(half)), half);
    }
  }
}

//------------------------------------------------------------------------------
TEST(Half, RoundsToTheNearestAndTiesToEven)
{
  for (std::uint16_t half = 0; half < 0x7bff; ++half)
  {
    const float a = vtkMediumHalfToFloat(half), b = vtkMediumHalfToFloat(half + 1);
    const float middle = 0.5f * (a + b);
    ASSERT_EQ(vtkMediumHalfFromFloat(std::nextafter(middle, a)), half);
    ASSERT_EQ(vtkMediumHalfFromFloat(std::nextafter(middle, b)), half + 1);
    ASSERT_EQ(vtkMediumHalfFromFloat(middle), half % 2 ? half + 1 : half);
    ASSERT_EQ(vtkMediumHalfFromFloat(-middle), 0x8000 | (half % 2 ? half + 1 : half));
  }
}

//------------------------------------------------------------------------------
TEST(Half, NeverMakesInfinitiesOrNaN)
{
  EXPECT_EQ(vtkMediumHalfFromFloat(1e6f), 0x7bff);
  EXPECT_EQ(vtkMediumHalfFromFloat(-std::numeric_limits<float>::infinity()), 0xfbff);
  EXPECT_EQ(vtkMediumHalfFromFloat(65519), 0x7bff);
  EXPECT_EQ(vtkMediumHalfFromFloat(65520), 0x7bff);
  EXPECT_EQ(vtkMediumHalfFromFloat(std::numeric_limits<float>::quiet_NaN()) & 0x7fff, 0);
}
