// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumFrameBudget.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double UpwardShare = 0.3;   // of a frame that took longer than was thought
constexpr double LeastForRays = 0.25; // of a frame's time
}

//------------------------------------------------------------------------------
vtkMediumFrameBudget::Economy vtkMediumFrameBudget::Plan(
  double seconds, double pixels, double spent) const
{
  Economy economy;
  economy.Hurried = seconds < AtRest;
  if (economy.Hurried)
  {
    const double left = std::max({ seconds - spent, LeastForRays * seconds, 1e-3 });
    const double excess = this->SecondsPerPixel * pixels / left;
    economy.StepFactor = std::min(std::max(excess, 1.0), LongestStep);
    const double edge = std::ceil(std::sqrt(excess / economy.StepFactor) - 1e-9);
    economy.PixelEdge = static_cast<int>(std::min(std::max(edge, 1.0), double(WidestPixel)));
  }
  return economy;
}

//------------------------------------------------------------------------------
void vtkMediumFrameBudget::Learn(const Economy& economy, double pixels, double seconds)
{
  if (!(pixels > 0) || !(seconds > 0))
  {
    return;
  }
  const double measured =
    seconds / pixels * economy.StepFactor * economy.PixelEdge * economy.PixelEdge;
  const bool faster = this->SecondsPerPixel == 0 || measured < this->SecondsPerPixel;
  this->SecondsPerPixel +=
    faster ? measured - this->SecondsPerPixel : UpwardShare * (measured - this->SecondsPerPixel);
}
