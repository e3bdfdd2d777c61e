// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumStepControl.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double CoarsestStep = 8;      // voxels
constexpr double FinestStep = 1.0 / 16; // voxels
constexpr double ProbeSafety = 2;       // the worst pixel against the worst probe
constexpr double SlowestOrder = 1.4;    // least ratio of successive changes that is believed
constexpr double SecondOrder = 4;

struct Change
{
  double Largest = 0; // of any colour of any pixel
  double Peak = 0;
};

//------------------------------------------------------------------------------
Change Compare(const std::vector<float>& coarse, const std::vector<float>& fine)
{
  Change change;
  for (std::size_t i = 0; i < fine.size(); ++i)
  {
    const double value = fine[i];
    change.Largest = std::max(change.Largest, std::abs(value - coarse[i]));
    // Without light the image is its alpha alone.
    change.Peak = std::max(change.Peak, i % 4 == 3 ? 0.0 : value);
  }
  return change;
}
}

//------------------------------------------------------------------------------
bool vtkMediumStepControl::IsCalibrated(const vtkMediumScene& scene, double maximumError) const
{
  if (this->Signature.IsEmpty() || maximumError != this->MaximumError)
  {
    return false;
  }
  const double distance = glm::length(this->Eye);
  const double sameDirection = 0.985; // cosine of ten degrees
  return glm::distance(scene.Eye.Origin, this->Eye) <= 0.1 * distance + 0.01 &&
    glm::dot(scene.Eye.Direction, this->Direction) > sameDirection &&
    vtkMediumSignature::OfContentAndLights(scene) == this->Signature;
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::Calibrate(
  const vtkMediumScene& scene, double maximumError, double voxel, const Probe& probe)
{
  this->Signature = vtkMediumSignature::OfContentAndLights(scene);
  this->Eye = scene.Eye.Origin;
  this->Direction = scene.Eye.Direction;
  this->MaximumError = maximumError;
  ++this->Calibrations;

  double step = CoarsestStep * voxel;
  std::vector<float> coarse = probe(step);
  double before = -1; // the change of the halving before
  double ratio = SecondOrder;
  for (;;)
  {
    step *= 0.5;
    std::vector<float> fine = probe(step);
    const Change change = Compare(coarse, fine);
    const double relative = change.Peak > 0 ? change.Largest / change.Peak : change.Largest;
    ratio = before > 0 && relative > 0
      ? std::min(std::max(before / relative, SlowestOrder), SecondOrder)
      : 2;
    this->Error = ProbeSafety * relative / (ratio - 1);
    if (this->Error <= maximumError || step <= FinestStep * voxel)
    {
      break;
    }
    before = relative;
    coarse.swap(fine);
  }
  // Between this step and its double, the error grows with the order that was seen.
  const double order = std::log2(ratio);
  const double longer = this->Error > 0
    ? std::min(std::max(std::pow(maximumError / this->Error, 1 / order), 1.0), 1.9)
    : 1.9;
  this->Step = step * longer;
  this->Error *= std::pow(longer, order);
}
