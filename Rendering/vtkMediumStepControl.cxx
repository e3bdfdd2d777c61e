// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumStepControl.h"

#include "vtkMediumStructure.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double CoarsestStep = 16;     // voxels
constexpr double FinestStep = 1.0 / 16; // voxels
// The same for a lattice of few voxels, in diagonals of the box: several steps differ from one, and a
// dense medium is resolved however large its voxels are.
constexpr double CoarsestPart = 1.0 / 16;
constexpr double FinestPart = 1.0 / 512;
constexpr double FinestPartIfConstant = 1.0 / 1024; // where light rays are one segment
constexpr double StepSafety = 1.5; // the worst pixel against the worst probe of many
constexpr double CacheSafety = 2;  // the same, of few
// The same, where no bound says which pixels are worse: seen at 256^3 voxels of 0 and 1, where the worst of
// 512^2 pixels erred by six times what the worst of the probes did.
constexpr double LookUpSafety = 6;
constexpr double SlowestOrder = 1.4; // least ratio of successive changes that is believed
constexpr double SecondOrder = 4;
// Of the error, that look-ups may use up.
constexpr double CacheShare = 0.75;
// Of the error that light leaves to steps, that those of the eye may use up where those of light have
// their own; the squares of both shares add up to 1.
constexpr double EyeShare = 0.7;
// What the look-ups of a pixel were seen to err by, of their bounds' sum: they err to both sides.
constexpr double PartOfBounds = 0.75;
// What look-ups may err by along the volume's diagonal: at first, of the error that is asked for, since
// they err to both sides; from then on as the error that it causes says.
constexpr double FirstTolerance = 16;
constexpr double ToleranceOrder = 0.8;
constexpr double MostOfTolerance = 0.6;
constexpr double MostOfError = 0.85; // that a lower tolerance leaves, where it is the tolerance's
constexpr int Tolerances = 10;
constexpr std::size_t MostFound = 16;

//------------------------------------------------------------------------------
double PeakOf(const vtkMediumStepControl::Image& image)
{
  double peak = 0;
  for (std::size_t i = 0; i < image.size(); ++i)
  {
    peak = std::max(peak, i % 4 == 3 ? 0.0 : image[i]); // alpha is no radiance
  }
  return peak;
}

//------------------------------------------------------------------------------
struct FoundStep
{
  double Step, Error;
};

// The longest step, from the coarsest on, that keeps the error; about the finest if none does.
FoundStep FindStep(double safety, double maximumError, double coarsest, double finest,
  const std::function<vtkMediumStepControl::Image(double step)>& integrate)
{
  double step = coarsest;
  double error = 0;
  vtkMediumStepControl::Image coarse = integrate(step);
  double before = -1; // the change of the halving before
  double ratio = SecondOrder;
  for (;;)
  {
    step *= 0.5;
    vtkMediumStepControl::Image fine = integrate(step);
    const double change = vtkMediumStepControl::RelativeDifference(coarse, fine);
    // Where all rays meet a kink alike, two steps may err by the same and seem not to differ at all: more
    // than a method of second order gains by a halving is not believed.
    const double relative = std::max(change, before / SecondOrder);
    ratio = before > 0 && relative > 0
      ? std::min(std::max(before / relative, SlowestOrder), SecondOrder)
      : 2;
    error = safety * relative / (ratio - 1);
    if (error <= maximumError || step <= finest)
    {
      break;
    }
    before = change;
    coarse.swap(fine);
  }
  // Between this step and its double, the error grows with the order that was seen.
  const double order = std::log2(ratio);
  const double longer =
    error > 0 ? std::min(std::max(std::pow(maximumError / error, 1 / order), 1.0), 1.9) : 1.9;
  return { step * longer, error * std::pow(longer, order) };
}

//------------------------------------------------------------------------------
glm::dvec3 FindAxis(const vtkMediumScene::View& eye)
{
  return glm::normalize(eye.Parallel ? eye.Direction : glm::dvec3(eye.ClipW));
}
}

//------------------------------------------------------------------------------
double vtkMediumStepControl::RelativeDifference(const Image& image, const Image& other)
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
bool vtkMediumStepControl::IsCalibrated(
  const vtkMediumScene& scene, double maximumError, CacheUses caches)
{
  if (this->Found.empty() || maximumError != this->MaximumError || caches != this->Caches ||
    vtkMediumSignature::OfContentAndLights(scene) != this->Signature)
  {
    return false;
  }
  const glm::dvec3 axis = FindAxis(scene.Eye);
  const double sameAxis = 0.985; // cosine of ten degrees
  auto holds = [&](const Calibration& found) {
    return glm::distance(scene.Eye.Origin, found.Eye) <= 0.1 * glm::length(found.Eye) + 0.01 &&
      glm::dot(axis, found.Axis) > sameAxis;
  };
  const auto found = std::find_if(this->Found.begin(), this->Found.end(), holds);
  if (found == this->Found.end())
  {
    return false;
  }
  this->Current = *found;
  return true;
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::Calibrate(
  const vtkMediumScene& scene, double maximumError, double voxel, const Probes& probes)
{
  const vtkMediumSignature signature = vtkMediumSignature::OfContentAndLights(scene);
  const bool sameContent = signature == this->Signature;
  if (!sameContent || scene.Eye.LocalToClip != this->MarchedEye)
  {
    this->Marched.clear();
  }
  this->Signature = signature;
  this->MarchedEye = scene.Eye.LocalToClip;
  const bool sameLight =
    sameContent && maximumError == this->MaximumError && probes.Caches == this->Caches;
  if (!sameLight)
  {
    this->FindLight(maximumError, probes);
  }
  if (!sameLight || this->Found.size() >= MostFound)
  {
    this->Found.clear();
  }
  this->MaximumError = maximumError;
  this->Caches = probes.Caches;
  ++this->Calibrations;
  const double lit = std::min(this->Lighting.Error, CacheShare * maximumError);
  const double room = std::sqrt(maximumError * maximumError - lit * lit);
  const bool constant = vtkMediumStructure::HasConstantExtinction(scene.Content);
  // Voxels that are flat beyond measure are not resolved.
  const double edge = std::max(voxel, vtkMediumPlan::ShortestStep / FinestStep);
  this->Current.Eye = scene.Eye.Origin;
  this->Current.Axis = FindAxis(scene.Eye);
  this->FindSteps(room, std::min(CoarsestStep * edge, CoarsestPart),
    std::min(FinestStep * edge, constant ? FinestPartIfConstant : FinestPart), probes);
  this->Current.Error = std::hypot(this->Current.Error, this->Lighting.Error);
  this->Found.push_back(this->Current);
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::Forget()
{
  this->Signature = vtkMediumSignature();
  this->Found.clear();
  this->Marched.clear();
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::FindLight(double maximumError, const Probes& probes)
{
  this->Lighting = Light();
  if (probes.Caches == Never)
  {
    return;
  }
  auto differenceOf = [&](const Light& light) {
    return RelativeDifference(probes.InLight(light, 0), this->Marched);
  };
  Light light;
  light.Method = vtkMediumPlan::LookUp;
  if (this->Marched.empty())
  {
    this->Marched = probes.InLight(Light(), 0);
    this->LookUpError = LookUpSafety * differenceOf(light);
  }
  light.Error = this->LookUpError;
  if (probes.Caches == Always || light.Error <= CacheShare * maximumError)
  {
    this->Lighting = light;
    return;
  }
  light.Method = vtkMediumPlan::MarchThenLookUp;
  const double peak = PeakOf(this->Marched);
  light.Tolerance = FirstTolerance * maximumError * peak;
  light.PixelTolerance = maximumError * peak;
  const double room = 1.0001 * CacheShare * maximumError;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < Tolerances; ++i)
  {
    const double seen = CacheSafety * differenceOf(light);
    // Probes know of the pixels that are integrated anew, bounds of the others.
    light.Error =
      std::min(seen, std::max(seen / CacheSafety, PartOfBounds * light.PixelTolerance / peak));
    if (light.Error <= room)
    {
      this->Lighting = light;
      return;
    }
    // An error that did not fall is that of pixels that were not integrated anew.
    const bool others = seen > MostOfError * before;
    (others ? light.PixelTolerance : light.Tolerance) *=
      std::min(std::pow(room / light.Error, ToleranceOrder), MostOfTolerance);
    before = others ? std::numeric_limits<double>::infinity() : seen;
  }
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::FindSteps(
  double maximumError, double coarsest, double finest, const Probes& probes)
{
  const bool refines = this->Lighting.Method == vtkMediumPlan::MarchThenLookUp;
  const double share = refines ? EyeShare : 1;
  Light lookedUp = this->Lighting;
  lookedUp.PixelTolerance = refines ? std::numeric_limits<float>::max() : 0;
  const FoundStep eye = FindStep(StepSafety, share * maximumError, coarsest, finest,
    [&](double step) { return probes.InSteps(lookedUp, step); });
  this->Current.Step = this->Current.LightStep = eye.Step;
  this->Current.Error = eye.Error;
  if (refines)
  {
    Light marched = this->Lighting;
    marched.Tolerance = marched.PixelTolerance = 0;
    const FoundStep light = FindStep(CacheSafety, std::sqrt(1 - share * share) * maximumError,
      coarsest, finest, [&](double step) { return probes.InLight(marched, step); });
    this->Current.LightStep = light.Step;
    this->Current.Error = std::hypot(eye.Error, light.Error);
  }
}
