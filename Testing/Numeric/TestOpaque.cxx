// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Opaque geometry ends the rays, in perspective and in parallel projection, at any depth.
#include "ClosedForms.h"
#include "OpaquePlane.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
const glm::dvec3 Size(2, 2, 1);

void ExpectMediumBeforePlane(
  Scene& scene, const Plane& plane, const glm::dvec3& toLight, double tolerance = 1e-3)
{
  const Box box(Size);
  const double sigma = 1.5;
  scene.Medium->SetExtinction(sigma);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.SetSteps(0.01, 0.1);
  const Picture picture = scene.Render();
  ASSERT_TRUE(picture.IsLight());
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    std::array<double, 2> t = box.Intersect(ray);
    const double opaque = plane.Hit(ray);
    t[1] = opaque > t[0] ? std::min(t[1], opaque) : t[0];
    const double d = std::max(t[1] - t[0], 0.0);
    const double truth = d > 0 ? Isotropic * BoxRadiance(box, ray, toLight, sigma, t[0], t[1]) : 0;
    // A 24-bit depth is good to 6e-5 of the far distance at most, here 3e-6 of 40.
    ASSERT_NEAR(picture.At(x, y, 3), -std::expm1(-sigma * d), tolerance) << x << ", " << y;
    ASSERT_NEAR(picture.At(x, y), truth, tolerance * (truth + 0.1)) << x << ", " << y;
  });
}
}

TEST(Opaque, PlaneEndsTheRaysAtEveryDepth)
{
  for (double offset : { -0.6, -0.4999, -0.3, 0.0, 0.2, 0.45, 0.6 })
  {
    SCOPED_TRACE(testing::Message() << "plane at z = " << offset);
    const Plane plane = { { 0, 0, 1 }, offset };
    Scene scene(MakeBox(Size), 12);
    plane.AddTo(scene.Renderer);
    scene.AddBeam({ 0, 0, -1 });
    scene.Look({ 0.1, -0.1, -1 }, 4);
    ExpectMediumBeforePlane(scene, plane, { 0, 0, 1 });
    scene.LookParallel({ 0.1, -0.1, -1 }, 4, 1.2);
    ExpectMediumBeforePlane(scene, plane, { 0, 0, 1 });
  }
}

// A window's depth may be multisampled, and share its bits with a stencil.
TEST(Opaque, PlaneEndsTheRaysInEveryKindOfWindow)
{
  const Plane plane = { { 0, 0, 1 }, 0.2 };
  for (int samples : { 0, 4 })
  {
    for (int stencil : { 0, 1 })
    {
      SCOPED_TRACE(testing::Message() << samples << " samples, stencil " << stencil);
      Scene scene(MakeBox(Size), 12);
      scene.Window->SetMultiSamples(samples);
      scene.Window->SetStencilCapable(stencil);
      plane.AddTo(scene.Renderer);
      scene.AddBeam({ 0, 0, -1 });
      scene.Look({ 0.1, -0.1, -1 }, 4);
      // One of a pixel's samples gives its depth, up to half a pixel beside the centre, where the plane
      // is up to 5e-3 nearer or farther.
      ExpectMediumBeforePlane(scene, plane, { 0, 0, 1 }, samples ? 1e-2 : 1e-3);
    }
  }
}

TEST(Opaque, SlantedPlaneEndsTheRays)
{
  const Plane plane = { glm::normalize(glm::dvec3(0.5, 0.3, 1)), 0.1 };
  Scene scene(MakeBox(Size), 12);
  plane.AddTo(scene.Renderer);
  scene.AddBeam({ 0.6, 0, -0.8 });
  scene.Look({ 0, 0, -1 }, 4);
  ExpectMediumBeforePlane(scene, plane, { -0.6, 0, 0.8 });
  scene.LookParallel({ 0, 0, -1 }, 4, 1.2);
  ExpectMediumBeforePlane(scene, plane, { -0.6, 0, 0.8 });
}

TEST(Opaque, PlaneEndsTheRaysOfADistantEye)
{
  const Plane plane = { { 0, 0, 1 }, 0.1 };
  Scene scene(MakeBox(Size), 12);
  plane.AddTo(scene.Renderer);
  scene.AddBeam({ 0, 0, -1 });
  scene.Look({ 0.1, -0.1, -1 }, 2000);
  scene.Camera->SetViewAngle(0.05);
  scene.Camera->SetClippingRange(1995, 2005);
  // VTK draws the plane by a float matrix, which is good to some 1e-4 at this distance.
  ExpectMediumBeforePlane(scene, plane, { 0, 0, 1 }, 2e-3);
}

TEST(Opaque, PlaneEndsThePapersDistance)
{
  const Plane plane = { { 0, 0, 1 }, 0.2 };
  Scene scene(MakeBox(Size), 12);
  plane.AddTo(scene.Renderer);
  scene.Mapper->SetIntegratorToPaper();
  scene.Mapper->SetOutputToDistance();
  scene.LookParallel({ 0, 0, -1 }, 4, 0.8);
  const Picture picture = scene.Render();
  ForEachPixel(scene, [&](int x, int y, const Ray&) {
    ASSERT_NEAR(picture.At(x, y), 0.3, 1e-4) << x << ", " << y; // from z = 0.5 to 0.2
  });
}

TEST(Opaque, PlaneStaysVisibleThroughTheMedium)
{
  const Plane plane = { { 0, 0, 1 }, -0.6 };
  Scene scene(MakeBox(Size), 12);
  plane.AddTo(scene.Renderer);
  scene.AddBeam({ 0, 0, -1 });
  scene.Look({ 0, 0, -1 }, 4);
  scene.Medium->SetExtinction(0);
  const std::vector<unsigned char> clear = scene.RenderWindow();
  scene.Medium->SetExtinction(0.7);
  scene.Medium->SetAlbedo(0);
  const std::vector<unsigned char> seen = scene.RenderWindow();
  const std::size_t centre = 3 * (6 * 12 + 6);
  ASSERT_GT(clear[centre], 200);
  // The background behind a premultiplied picture is weakened by 1 - alpha; bytes round.
  EXPECT_NEAR(seen[centre], clear[centre] * std::exp(-0.7), 3);
}
