// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 38 to 40: opaque geometry ends the rays, in both projections and at extreme clipping ranges.
#include "StressStage.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"

namespace vtkMediumStress
{
namespace
{
const glm::dvec3 Size(2, 2, 1);
constexpr double Sigma = 1.5;

/// A homogeneous box, and an opaque plane of constant z wide enough for every view.
struct PlaneStage : Stage
{
  explicit PlaneStage(Trial& trial)
    : Stage(trial, MakeBox(Size))
  {
    this->SetSigma(Sigma);
    this->SetFineSteps(Sigma);
    this->AddBeam({ 0, 0, -1 });
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Plane->GetOutputPort());
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
  }

  void Check(double offset, double allowed)
  {
    this->Plane->SetOrigin(-4, -4, offset);
    this->Plane->SetPoint1(4, -4, offset);
    this->Plane->SetPoint2(-4, 4, offset);
    const Picture picture = this->Render();
    ForEachPixel(*this, [&](int x, int y, const Ray& ray) {
      std::array<double, 2> t = Box(Size).Intersect(ray);
      const double opaque = (offset - ray.Origin.z) / ray.Direction.z;
      t[1] = opaque > t[0] ? std::min(t[1], opaque) : t[0];
      const double d = std::max(t[1] - t[0], 0.0);
      const double truth =
        d > 0 ? Isotropic * BoxRadiance(Box(Size), ray, { 0, 0, 1 }, Sigma, t[0], t[1]) : 0;
      const std::string what = "plane at z = " + std::to_string(offset);
      this->Cell.AtMost(std::abs(picture.At(x, y, 3) + std::expm1(-Sigma * d)), allowed, what);
      this->Cell.AtMost(
        std::abs(picture.At(x, y) - truth) / (truth + 0.1), allowed + this->Allowed(Sigma), what);
    });
  }

  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkActor> Actor;
};

constexpr double Offsets[] = { -0.6, -0.4999, -0.4, -0.2, -0.1, 0.0, 0.1, 0.3, 0.45, 0.6 };

void Perspective(Trial& trial)
{
  PlaneStage stage(trial);
  stage.Look({ 0.1, -0.1, -1 }, 4);
  for (double offset : Offsets)
  {
    stage.Check(offset, 1e-3);
  }
}

void Parallel(Trial& trial)
{
  PlaneStage stage(trial);
  stage.LookParallel({ 0.1, -0.1, -1 }, 4, 1.2);
  for (double offset : Offsets)
  {
    stage.Check(offset, 1e-3);
  }
}

/// A depth of 24 bits, or of a float near 1, at the distance z from a near plane n is good to
/// z^2 / n 2^-24; the plane's own depth is interpolated over a wide polygon, for which as much is added.
void DistantFarPlane(Trial& trial)
{
  PlaneStage stage(trial);
  stage.Look({ 0.1, -0.1, -1 }, 4);
  for (double nearest : { 0.1, 0.01 })
  {
    stage.Camera->SetClippingRange(nearest, 1e6 * nearest);
    const double resolution = 25 / nearest * std::pow(2.0, -24);
    stage.Check(0, 2 * Sigma * resolution + 1e-5);
  }
}
}

std::vector<Row> DepthRows()
{
  return {
    { 38, "OpaquePlanesEndTheRays", "1e-3: a depth of 24 bits, to 6e-5 of the far distance",
      Perspective, {} },
    { 39, "OpaquePlanesEndTheRaysOfParallelViews", "as row 38", Parallel, {} },
    { 40, "FarOverNearOfAMillionIsBoundByTheDepthsUlp", "2 σ z² / n 2⁻²⁴", DistantFarPlane, {} },
  };
}
}
