// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumStepSearch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using Image = vtkMediumStepSearch::Image;

// A pixel of 1 and one that errs by factor step^order.
vtkMediumStepSearch::Integrate Power(double factor, double order, int& asked)
{
  return [=, &asked](double step) {
    ++asked;
    return Image{ 1, 1, 1, 1, static_cast<float>(0.5 + factor * std::pow(step, order)), 0, 0, 1 };
  };
}
}

//------------------------------------------------------------------------------
TEST(StepSearch, FindsTheLongestStepOfAKnownOrder)
{
  for (double order : { 1.0, 2.0 })
  {
    int asked = 0;
    vtkMediumStepSearch search(1, 16, 1.0 / 16);
    const double factor = 1e-4;
    search.Halve(1e-3, Power(factor, order, asked));
    const double longest = search.GetLongestStep(1e-3);
    EXPECT_NEAR(search.GetError(), factor * std::pow(search.GetStep(), order), 1e-5) << order;
    EXPECT_NEAR(factor * std::pow(longest, order), 1e-3, 1e-4) << order;
    EXPECT_NEAR(search.GetErrorAt(longest), 1e-3, 1e-9) << order;
  }
}

//------------------------------------------------------------------------------
// The first change says nothing of the order, and first order is taken for granted.
TEST(StepSearch, SeesTheOrderBeforeItStops)
{
  int asked = 0;
  vtkMediumStepSearch search(1, 16, 1.0 / 16);
  search.Halve(1, Power(1e-5, 2, asked));
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(search.GetStep(), 4);
  EXPECT_NEAR(search.GetError(), 1.6e-4, 1e-6);
  EXPECT_NEAR(search.GetLongestStep(1), 0.95 * 16, 1e-9) << "not beyond what was tried";
  EXPECT_NEAR(search.GetLongestStep(1e-3), 10, 0.01) << "beyond steps that were accurate enough";
}

//------------------------------------------------------------------------------
TEST(StepSearch, GoesOnWhereItWas)
{
  int asked = 0;
  vtkMediumStepSearch search(1, 16, 1.0 / 16);
  EXPECT_FALSE(search.IsBegun());
  search.Halve(1e-2, Power(1e-3, 2, asked));
  const int before = asked;
  search.Halve(1e-2, Power(1e-3, 2, asked));
  EXPECT_EQ(asked, before) << "accurate enough";
  search.Halve(1e-4, Power(1e-3, 2, asked));
  EXPECT_LE(search.GetError(), 1e-4);
  EXPECT_EQ(search.GetStep(), 16 / std::pow(2, asked - 1)) << "no step twice";
  search.Halve(0, Power(1e-3, 2, asked));
  EXPECT_TRUE(search.IsFinest());
  const int all = asked;
  search.Halve(0, Power(1e-3, 2, asked));
  EXPECT_EQ(asked, all);
}
