// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumStepSearch.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double SlowestOrder = 1.4; // least ratio of successive changes that is believed
constexpr double SecondOrder = 4;
constexpr double Shorter = 0.95; // than a step that seemed to miss the error
}

//------------------------------------------------------------------------------
vtkMediumStepSearch::vtkMediumStepSearch(double safety, double coarsest, double finest)
  : Safety(safety)
  , Finest(finest)
  , Step(coarsest)
{
}

//------------------------------------------------------------------------------
void vtkMediumStepSearch::Halve(double maximumError, const Integrate& integrate)
{
  if (!this->IsBegun())
  {
    this->Fine = integrate(this->Step);
    this->HalveOnce(integrate);
    this->HalveOnce(integrate);
  }
  while (this->GetError() > maximumError && !this->IsFinest())
  {
    this->HalveOnce(integrate);
  }
}

//------------------------------------------------------------------------------
void vtkMediumStepSearch::HalveOnce(const Integrate& integrate)
{
  this->Step *= 0.5;
  Image fine = integrate(this->Step);
  const double change = RelativeDifference(this->Fine, fine);
  // Where all rays meet a kink alike, two steps may err by the same and seem not to differ at all: more
  // than a method of second order gains by a halving is not believed.
  const double relative = std::max(change, this->Before / SecondOrder);
  this->Ratio = this->Before > 0 && relative > 0
    ? std::min(std::max(this->Before / relative, SlowestOrder), SecondOrder)
    : 2;
  this->Errors.push_back(this->Safety * relative / (this->Ratio - 1));
  if (this->Errors.size() == 2)
  {
    // The first was a guess at the order.
    this->Errors[0] = std::min(this->Errors[0], this->Ratio * this->Errors[1]);
  }
  this->Before = change;
  this->Fine.swap(fine);
}

//------------------------------------------------------------------------------
double vtkMediumStepSearch::GetLongestStep(double maximumError) const
{
  const double error = this->GetError();
  const double farthest = std::pow(2.0, this->Errors.size());
  const double wanted =
    error > 0 ? std::pow(maximumError / error, 1 / std::log2(this->Ratio)) : farthest;
  double missed =
    2; // the shortest step that missed the error, or the coarsest; in lengths of the shortest
  for (auto seen = this->Errors.rbegin() + 1; seen != this->Errors.rend() && *seen <= maximumError;
       ++seen)
  {
    missed *= 2;
  }
  return this->Step * std::min(std::max(wanted, 1.0), Shorter * missed);
}

//------------------------------------------------------------------------------
double vtkMediumStepSearch::GetErrorAt(double step) const
{
  return this->GetError() * std::pow(step / this->Step, std::log2(this->Ratio));
}

//------------------------------------------------------------------------------
double vtkMediumStepSearch::RelativeDifference(const Image& image, const Image& other)
{
  double radiance = 0, alpha = 0;
  for (std::size_t i = 0; i < other.size(); ++i)
  {
    double& largest = i % 4 == 3 ? alpha : radiance;
    largest = std::max(largest, std::abs(double(other[i]) - image[i]));
  }
  const double peak = PeakOf(other);
  return std::max(alpha, peak > 0 ? radiance / peak : 0);
}

//------------------------------------------------------------------------------
double vtkMediumStepSearch::PeakOf(const Image& image)
{
  double peak = 0;
  for (std::size_t i = 0; i < image.size(); ++i)
  {
    peak = std::max(peak, i % 4 == 3 ? 0.0 : image[i]); // alpha is no radiance
  }
  return peak;
}
