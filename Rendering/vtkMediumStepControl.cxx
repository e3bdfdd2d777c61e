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
constexpr std::size_t MostFound = 16;

//------------------------------------------------------------------------------
glm::dvec3 FindAxis(const vtkMediumScene::View& eye)
{
  return glm::normalize(eye.Parallel ? eye.Direction : glm::dvec3(eye.ClipW));
}
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
  const bool constant = vtkMediumStructure::HasConstantExtinction(scene.Content);
  // Voxels that are flat beyond measure are not resolved.
  const double edge = std::max(voxel, vtkMediumPlan::ShortestStep / FinestStep);
  const Range range{ std::min(CoarsestStep * edge, CoarsestPart),
    std::min(FinestStep * edge, constant ? FinestPartIfConstant : FinestPart) };
  const bool sameContent = signature == this->Signature;
  if (!sameContent || scene.Eye.LocalToClip != this->MarchedEye)
  {
    this->Marched = vtkMediumStepSearch(LightSafety, range.Coarsest, range.Finest);
    this->LookedUp.clear();
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
  this->Current.Eye = scene.Eye.Origin;
  this->Current.Axis = FindAxis(scene.Eye);
  this->FindSteps(maximumError, range, probes);
  this->Found.push_back(this->Current);
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::Forget()
{
  this->Signature = vtkMediumSignature();
  this->Found.clear();
  this->Marched = vtkMediumStepSearch();
}

//------------------------------------------------------------------------------
void vtkMediumStepControl::FindSteps(double maximumError, const Range& range, const Probes& probes)
{
  const double lit = std::min(this->Lighting.Error, CacheShare * maximumError);
  const double room = std::sqrt(maximumError * maximumError - lit * lit);
  const bool refines = this->Lighting.Method == vtkMediumPlan::MarchThenLookUp;
  Light light = this->Lighting;
  light.PixelTolerance =
    refines ? std::numeric_limits<double>::infinity() : 0; // looked up everywhere
  const double eyeRoom = refines ? EyeShare * room : room;
  vtkMediumStepSearch eye(StepSafety, range.Coarsest, range.Finest);
  eye.Halve(eyeRoom, [&](double step) { return probes.InSteps(light, step); });
  this->Current.Step = this->Current.LightStep = eye.GetLongestStep(eyeRoom);
  double error = eye.GetErrorAt(this->Current.Step);
  if (refines)
  {
    const double lightRoom = std::sqrt(room * room - eyeRoom * eyeRoom);
    this->March(lightRoom, probes);
    this->Current.LightStep = this->Marched.GetLongestStep(lightRoom);
    error = std::hypot(error, this->Marched.GetErrorAt(this->Current.LightStep));
  }
  this->Current.Error = std::hypot(error, this->Lighting.Error);
}
