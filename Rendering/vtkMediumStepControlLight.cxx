// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// How vtkMediumStepControl finds the cheapest way to the light that is accurate enough.
#include "vtkMediumStepControl.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// The worst pixel against the worst probe, where no bound says which pixels are worse: seen at 256^3 voxels of 0 and 1, where the worst of
// 512^2 pixels erred by six times what the worst of the probes did.
constexpr double LookUpSafety = 6;
// Of the error that is asked for: what the reference of the light caches may err by at first.
constexpr double MarchShare = 0.47;
// What the look-ups of a pixel err by, of their bounds' sum, at least and at most: they err to both sides, but
// kinks between lattice points escape the bounds. More than the worst probe is believed of other pixels.
constexpr double LeastOfBounds = 0.5;
constexpr double MostOfBounds = 4;
constexpr double BoundsSafety = 1.25;
constexpr double SmallPart = 0.1; // of the error asked for; says nothing of that part
// What look-ups may err by along the volume's diagonal: at first, of the error that is asked for, since
// they err to both sides; from then on as the error that it causes says.
constexpr double FirstTolerance = 16;
constexpr double ToleranceOrder = 0.8;
constexpr double MostOfTolerance = 0.6;
constexpr int Tolerances = 10;
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::March(double maximumError, const Probes& probes)
{
  this->Marched.Halve(maximumError, [&](double step) { return probes.InLight(Light(), step); });
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::FindLight(double maximumError, const Probes& probes)
{
  this->Lighting = Light();
  if (probes.Caches == Never)
  {
    return;
  }
  const bool accurate = this->AreLookUpsAccurate(maximumError, probes);
  if (probes.Caches != Always && !accurate && !this->FindTolerance(maximumError, probes))
  {
    this->Lighting = Light();
  }
}

//------------------------------------------------------------------------------
// Light rays are marched in ever shorter steps until they say it for certain. Lighting is then by look-ups.
bool vtkMediumStepControl::AreLookUpsAccurate(double maximumError, const Probes& probes)
{
  const double room = CacheShare * maximumError;
  this->Lighting.Method = vtkMediumPlan::LookUp;
  this->March(MarchShare * maximumError, probes);
  if (this->LookedUp.empty())
  {
    this->LookedUp = probes.InLight(this->Lighting, this->Marched.GetStep());
  }
  for (;;)
  {
    const double difference =
      vtkMediumStepSearch::RelativeDifference(this->LookedUp, this->Marched.GetImage());
    this->Lighting.Error = LookUpSafety * difference;
    const double least = LookUpSafety * (difference - this->Marched.GetError());
    if (this->Lighting.Error <= room || least > room || this->Marched.IsFinest())
    {
      return this->Lighting.Error <= room;
    }
    this->March(0.5 * this->Marched.GetError(), probes);
  }
}

//------------------------------------------------------------------------------
// False where no tolerance leaves room for the error of steps.
bool vtkMediumStepControl::FindTolerance(double maximumError, const Probes& probes)
{
  Light light;
  light.Method = vtkMediumPlan::MarchThenLookUp;
  light.PixelTolerance = std::numeric_limits<double>::infinity();
  const std::vector<double> lookedUp = this->FindErrors(light, probes);
  const std::vector<float> bounds = probes.Bounds();
  const double peak = vtkMediumStepSearch::PeakOf(this->Marched.GetImage());
  const double part = FindPartOfBounds(lookedUp, bounds, SmallPart * maximumError * peak);
  const double room = 1.0001 * CacheShare * maximumError * peak; // radiance
  light.Tolerance = FirstTolerance * maximumError * peak;
  light.PixelTolerance = room / part;
  for (int i = 0; i < Tolerances; ++i)
  {
    const std::vector<double> errors = this->FindErrors(light, probes);
    double anew = 0, others = 0;
    for (std::size_t pixel = 0; pixel < std::min(errors.size(), bounds.size()); ++pixel)
    {
      double& worst = bounds[pixel] > light.PixelTolerance ? anew : others;
      worst = std::max(worst, LightSafety * errors[pixel]);
    }
    others = std::min(others, part * light.PixelTolerance); // their bounds know more than probes
    if (std::max(anew, others) <= room)
    {
      light.Error = std::max(anew, others) / peak;
      this->Lighting = light;
      return true;
    }
    light.Tolerance *=
      anew > room ? std::min(std::pow(room / anew, ToleranceOrder), MostOfTolerance) : 1;
    light.PixelTolerance *= others > room ? MostOfTolerance * room / others : 1;
  }
  return false;
}

//------------------------------------------------------------------------------
// Of each probe: the largest error of R, G and B, radiance.
std::vector<double> vtkMediumStepControl::FindErrors(const Light& light, const Probes& probes) const
{
  const Image seen = probes.InLight(light, this->Marched.GetStep());
  const Image& truth = this->Marched.GetImage();
  std::vector<double> errors(truth.size() / 4);
  for (std::size_t i = 0; i < 4 * errors.size(); ++i)
  {
    const double error = i % 4 == 3 ? 0 : std::abs(double(seen[i]) - truth[i]);
    errors[i / 4] = std::max(errors[i / 4], error);
  }
  return errors;
}

//------------------------------------------------------------------------------
// What the look-ups of a pixel err by, of what they may err by.
double vtkMediumStepControl::FindPartOfBounds(
  const std::vector<double>& errors, const std::vector<float>& bounds, double small)
{
  double part = 0;
  for (std::size_t pixel = 0; pixel < std::min(bounds.size(), errors.size()); ++pixel)
  {
    part = errors[pixel] > small && bounds[pixel] > 0
      ? std::max(part, errors[pixel] / bounds[pixel])
      : part;
  }
  return std::min(std::max(BoundsSafety * part, LeastOfBounds), MostOfBounds);
}
