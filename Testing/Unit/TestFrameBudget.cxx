// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumFrameBudget.h"

#include <gtest/gtest.h>

namespace
{
using Economy = vtkMediumFrameBudget::Economy;

// A machine that takes so long for a frame.
double Take(const Economy& economy, double pixels, double secondsPerPixel)
{
  return secondsPerPixel * pixels / (economy.StepFactor * economy.PixelEdge * economy.PixelEdge);
}
}

//------------------------------------------------------------------------------
TEST(FrameBudget, GivesUpNothingAtRest)
{
  vtkMediumFrameBudget budget;
  budget.Learn(Economy{}, 1e6, 100);
  const Economy economy = budget.Plan(10000, 1e6);
  EXPECT_FALSE(economy.Hurried);
  EXPECT_EQ(economy.StepFactor, 1);
  EXPECT_EQ(economy.PixelEdge, 1);
}

//------------------------------------------------------------------------------
TEST(FrameBudget, MeetsTheTimeAndGivesUpNoMoreThanItMust)
{
  const double seconds = 1.0 / 15;
  for (double pixels : { 256.0 * 256, 1920.0 * 1080 })
  {
    for (double cost : { 1e-9, 2e-7, 5e-7, 2e-6 })
    {
      vtkMediumFrameBudget budget;
      Economy economy;
      for (int frame = 0; frame < 8; ++frame)
      {
        economy = budget.Plan(seconds, pixels);
        budget.Learn(economy, pixels, Take(economy, pixels, cost));
      }
      const double time = Take(economy, pixels, cost);
      const bool coarsest = economy.PixelEdge == vtkMediumFrameBudget::WidestPixel &&
        economy.StepFactor == vtkMediumFrameBudget::LongestStep;
      EXPECT_TRUE(time <= 1.01 * seconds || coarsest) << pixels << ' ' << cost;
      const bool finest = economy.PixelEdge == 1 && economy.StepFactor == 1;
      EXPECT_TRUE(finest || time > seconds / 5) << pixels << ' ' << cost << ' ' << time;
    }
  }
}

//------------------------------------------------------------------------------
TEST(FrameBudget, OneSlowFrameDoesNotMakeTheNextOnesCoarse)
{
  const double pixels = 1e6, cost = 2e-8, seconds = 1.0 / 15;
  vtkMediumFrameBudget budget;
  budget.Learn(Economy{}, pixels, pixels * cost);
  EXPECT_EQ(budget.Plan(seconds, pixels).PixelEdge, 1);
  budget.Learn(Economy{}, pixels, 0.4); // a program was compiled
  EXPECT_LE(budget.Plan(seconds, pixels).PixelEdge, 2);
  budget.Learn(Economy{}, pixels, pixels * cost);
  EXPECT_EQ(budget.Plan(seconds, pixels).PixelEdge, 1) << "forgotten at once";
}

//------------------------------------------------------------------------------
TEST(FrameBudget, LearnsNothingFromFramesWithoutPixels)
{
  vtkMediumFrameBudget budget;
  budget.Learn(Economy{}, 0, 1);
  EXPECT_EQ(budget.GetSecondsPerPixel(), 0);
  EXPECT_EQ(budget.Plan(0, 1e6).PixelEdge, 1) << "a first frame has nothing to go by";
}

//------------------------------------------------------------------------------
TEST(FrameBudget, LeavesRoomForWhatBuildingCachesTook)
{
  vtkMediumFrameBudget budget;
  budget.Learn(Economy{}, 1e6, 0.1);
  auto quality = [&](double spent) {
    const Economy economy = budget.Plan(0.1, 1e6, spent);
    EXPECT_TRUE(economy.Hurried);
    return 1 / (economy.StepFactor * economy.PixelEdge * economy.PixelEdge);
  };
  EXPECT_EQ(quality(0), 1);
  EXPECT_LE(quality(0.05), 0.5);
  EXPECT_GE(quality(0.05), 0.25);
  EXPECT_EQ(quality(1000), quality(0.075)) << "a quarter of the time is left to the rays";
}
