// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Every way in which a vtkCamera can make a projection gives the box's closed form on its rays, which are
// taken here from the inverse of the camera's own matrix.
#include "ClosedForms.h"

#include "vtkMatrix4x4.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <utility>

using namespace vtkMediumTest;

namespace
{
constexpr double Sigma = 2;
const glm::dvec3 Size(1, 0.7, 1.2);
const glm::dvec3 Beam = glm::normalize(glm::dvec3(1, -0.7, -0.4));
constexpr int Side = 20;

struct BoxScene : Scene
{
  explicit BoxScene(int integrator = vtkSingleScatteringVolumeMapper::FixedStep)
    : Scene(MakeImage(glm::ivec3(17), Size, [](const glm::dvec3&) { return 1.0; }), Side)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetTransmittanceThreshold(0);
    this->Medium->SetExtinctionArrayName("density");
    this->Medium->SetExtinctionScale(Sigma);
    this->SetSteps(0.004, 0.2);
    this->AddBeam(Beam);
    this->Look({ 0.3, 0.2, -1 }, 2);
  }
};

glm::dvec3 Unproject(vtkMatrix4x4* clipToWorld, double x, double y, double z)
{
  const double clip[4] = { x, y, z, 1 };
  double world[4];
  clipToWorld->MultiplyPoint(clip, world);
  return glm::dvec3(world[0], world[1], world[2]) / world[3];
}

/// Renders and compares every pixel's radiance and alpha, as fractions of their own peaks, with the box
/// between the near plane and infinity.
void ExpectTruth(BoxScene& scene, double tolerance)
{
  const Picture picture = scene.Render();
  ASSERT_TRUE(scene.Errors.empty()) << scene.Errors[0];
  ASSERT_TRUE(picture.IsLight());
  vtkNew<vtkMatrix4x4> clipToWorld;
  clipToWorld->DeepCopy(scene.Camera->GetCompositeProjectionTransformMatrix(
    double(picture.Size.x) / picture.Size.y, -1, 1));
  clipToWorld->Invert();
  const Box box(Size);
  int hits = 0;
  for (int y = 0; y < picture.Size.y; ++y)
  {
    for (int x = 0; x < picture.Size.x; ++x)
    {
      const double u = (2 * x + 1.0) / picture.Size.x - 1, v = (2 * y + 1.0) / picture.Size.y - 1;
      Ray ray;
      ray.Origin = Unproject(clipToWorld, u, v, -1);
      ray.Direction = glm::normalize(Unproject(clipToWorld, u, v, 0.5) - ray.Origin);
      ray.Near = 0;
      const std::array<double, 2> t = box.Intersect(ray);
      const double d = std::max(t[1] - t[0], 0.0);
      hits += d > 0;
      ASSERT_NEAR(picture.At(x, y, 3), -std::expm1(-Sigma * d), tolerance) << x << ", " << y;
      ASSERT_NEAR(
        picture.At(x, y), Isotropic * BoxRadiance(box, ray, -Beam, Sigma), tolerance * Isotropic)
        << x << ", " << y;
    }
  }
  EXPECT_GT(hits, Side);
}

vtkSmartPointer<vtkMatrix4x4> Frustum(
  double left, double right, double bottom, double top, double nearest, double farthest)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->Zero();
  matrix->SetElement(0, 0, 2 * nearest / (right - left));
  matrix->SetElement(0, 2, (right + left) / (right - left));
  matrix->SetElement(1, 1, 2 * nearest / (top - bottom));
  matrix->SetElement(1, 2, (top + bottom) / (top - bottom));
  const bool endless = !std::isfinite(farthest);
  matrix->SetElement(2, 2, endless ? -1 : -(farthest + nearest) / (farthest - nearest));
  matrix->SetElement(2, 3, endless ? -2 * nearest : -2 * farthest * nearest / (farthest - nearest));
  matrix->SetElement(3, 2, -1);
  return matrix;
}

void SetExplicit(BoxScene& scene, vtkMatrix4x4* projection)
{
  scene.Camera->SetExplicitProjectionTransformMatrix(projection);
  scene.Camera->UseExplicitProjectionTransformMatrixOn();
}

using Pose = std::pair<const char*, std::function<void(BoxScene&)>>;

const Pose Poses[] = {
  { "inside the volume",
    [](BoxScene& s) {
      s.Look({ 0.3, 0.2, -1 }, 0.01, { 0.1, 0.05, 0.2 });
    } },
  { "inside, looking along an axis",
    [](BoxScene& s) {
      s.Look({ 0, 0, -1 }, 0.01, { 0.1, 0.05, 0.2 });
    } },
  { "near plane cuts the volume", [](BoxScene& s) { s.Camera->SetClippingRange(1.9, 5); } },
  { "near plane cuts the volume around the eye",
    [](BoxScene& s) {
      s.Look({ 0.3, 0.2, -1 }, 0.01, { 0.1, 0.05, 0.2 });
      s.Camera->SetClippingRange(0.3, 5);
    } },
  { "parallel",
    [](BoxScene& s) {
      s.LookParallel({ 0.3, 0.2, -1 }, 2, 0.7);
    } },
  { "parallel, near plane cuts the volume",
    [](BoxScene& s) {
      s.LookParallel({ 0.3, 0.2, -1 }, 2, 0.7);
      s.Camera->SetClippingRange(1.9, 5);
    } },
  { "parallel, near plane behind the camera",
    [](BoxScene& s) {
      s.LookParallel({ 0.3, 0.2, -1 }, 0.1, 0.7);
      s.Camera->SetClippingRange(-3, 3);
    } },
  { "narrow and far away",
    [](BoxScene& s) {
      s.Look({ 0.3, 0.2, -1 }, 2000);
      s.Camera->SetViewAngle(0.04);
    } },
  { "nearly half a turn wide",
    [](BoxScene& s) {
      s.Look({ 0.3, 0.2, -1 }, 0.4);
      s.Camera->SetViewAngle(150);
    } },
  { "rolled", [](BoxScene& s) { s.Camera->Roll(33); } },
  { "horizontal view angle",
    [](BoxScene& s) {
      s.Window->SetSize(Side, 2 * Side);
      s.Camera->UseHorizontalViewAngleOn();
    } },
  { "wide window", [](BoxScene& s) { s.Window->SetSize(2 * Side, Side); } },
  { "window centre", [](BoxScene& s) { s.Camera->SetWindowCenter(0.4, -0.3); } },
  { "window centre, parallel",
    [](BoxScene& s) {
      s.LookParallel({ 0.3, 0.2, -1 }, 2, 0.7);
      s.Camera->SetWindowCenter(0.4, -0.3);
    } },
  { "view shear", [](BoxScene& s) { s.Camera->SetViewShear(0.2, -0.3, 1); } },
  { "view shear, parallel",
    [](BoxScene& s) {
      s.LookParallel({ 0.3, 0.2, -1 }, 2, 0.7);
      s.Camera->SetViewShear(0.3, -0.4, 1);
    } },
  { "off-axis projection onto a screen",
    [](BoxScene& s) {
      s.Camera->UseOffAxisProjectionOn();
      s.Camera->SetScreenBottomLeft(-0.5, -0.4, -0.7);
      s.Camera->SetScreenBottomRight(0.6, -0.4, -0.7);
      s.Camera->SetScreenTopRight(0.6, 0.7, -0.7);
    } },
  { "explicit projection",
    [](BoxScene& s) { SetExplicit(s, Frustum(-0.4, 0.3, -0.2, 0.4, 1, 9)); } },
  { "explicit projection without a far plane",
    [](BoxScene& s) { SetExplicit(s, Frustum(-0.4, 0.3, -0.2, 0.4, 1, INFINITY)); } },
  { "explicit projection, near plane cuts the volume",
    [](BoxScene& s) { SetExplicit(s, Frustum(-0.8, 0.6, -0.4, 0.8, 2, 9)); } },
  { "explicit projection that mirrors",
    [](BoxScene& s) { SetExplicit(s, Frustum(0.4, -0.3, -0.2, 0.4, 1, 9)); } },
  { "user view transform",
    [](BoxScene& s) {
      vtkNew<vtkTransform> transform;
      transform->Translate(0.1, -0.05, 0.2);
      transform->RotateWXYZ(20, 1, 0.2, 0.4);
      s.Camera->SetUserViewTransform(transform);
    } },
  { "user transform of the projection",
    [](BoxScene& s) {
      vtkNew<vtkTransform> transform;
      transform->Scale(1.2, -0.9, 1);
      transform->Translate(0.1, -0.1, 0);
      s.Camera->SetUserTransform(transform);
    } },
  { "model transform",
    [](BoxScene& s) {
      vtkNew<vtkTransform> transform;
      transform->Translate(0.1, -0.05, 0.2);
      transform->RotateWXYZ(30, 0.3, 1, 0.4);
      s.Camera->SetModelTransformMatrix(transform->GetMatrix());
    } },
};
}

TEST(Cameras, EveryProjectionSeesTheBoxOnItsRays)
{
  for (const Pose& pose : Poses)
  {
    SCOPED_TRACE(pose.first);
    BoxScene scene;
    pose.second(scene);
    ExpectTruth(scene, 1e-4); // float rays, and midpoints of 0.004
  }
}

TEST(Cameras, EveryProjectionKeepsTheAllowedErrorWithBricksAndCaches)
{
  for (const Pose& pose : Poses)
  {
    SCOPED_TRACE(pose.first);
    BoxScene scene(vtkSingleScatteringVolumeMapper::ErrorControlled);
    scene.Mapper->SetMaximumError(2e-3);
    pose.second(scene);
    // The peak is at most the phase function's 1 / (4 pi); alpha has no bound of its own.
    ExpectTruth(scene, 4e-3);
  }
}
