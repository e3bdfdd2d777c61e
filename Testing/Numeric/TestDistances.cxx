// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// First and last points of the medium, as distances in world units and as window depths.
#include "ClosedForms.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
const glm::dvec3 Size(2, 1.2, 0.8);

/// A window depth (0 near plane, 1 far plane) of a point at `along` from the eye along the view axis.
double WindowDepth(vtkCamera* camera, double along)
{
  const double n = camera->GetClippingRange()[0], f = camera->GetClippingRange()[1];
  return camera->GetParallelProjection() ? (along - n) / (f - n) : f / (f - n) * (1 - n / along);
}

/// Distances of a filled box: its first point, or the way through it.
void ExpectDistances(Scene& scene, const Box& box, double tolerance)
{
  for (int output :
    { vtkSingleScatteringVolumeMapper::FirstHit, vtkSingleScatteringVolumeMapper::Distance })
  {
    scene.Mapper->SetOutput(output);
    const Picture picture = scene.Render();
    int hits = 0;
    ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
      const std::array<double, 2> t = box.Intersect(ray);
      const bool first = output == vtkSingleScatteringVolumeMapper::FirstHit;
      const double truth = first ? t[0] : t[1] - t[0];
      if (std::abs(t[1] - t[0]) < 1e-4 * box.Axes[0][0])
      {
        return; // a ray that grazes an edge may go either way
      }
      ASSERT_EQ(picture.At(x, y, 3), t[0] < t[1] ? 1 : 0) << output << ": " << x << ", " << y;
      ASSERT_NEAR(picture.At(x, y), t[0] < t[1] ? truth : 0, tolerance)
        << (first ? "first hit " : "distance ") << x << ", " << y;
      ASSERT_EQ(picture.At(x, y), picture.At(x, y, 1));
      ASSERT_EQ(picture.At(x, y), picture.At(x, y, 2));
      hits += t[0] < t[1];
    });
    EXPECT_GT(hits, scene.Pixels);
  }
}

/// Depths of a filled box; 1 where there is none.
void ExpectDepths(Scene& scene, const Box& box)
{
  scene.Render();
  const Picture picture = scene.Depths();
  ASSERT_EQ(picture.Components, 1);
  glm::dvec3 forward, eye;
  scene.Camera->GetDirectionOfProjection(&forward[0]);
  scene.Camera->GetPosition(&eye[0]);
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const std::array<double, 2> t = box.Intersect(ray);
    const double along = glm::dot(ray.Origin + t[0] * ray.Direction - eye, forward);
    const double truth = t[0] < t[1] ? WindowDepth(scene.Camera, along) : 1;
    if (std::abs(t[1] - t[0]) > 1e-4)
    {
      ASSERT_NEAR(picture.At(x, y), truth, 1e-5) << x << ", " << y; // float, far / near = 1000
    }
  });
}
}

TEST(Distances, OfFixedStepAreThoseOfTheBox)
{
  Scene scene(MakeBox(Size), 16);
  scene.SetSteps(0.05, 0.5);
  // Float rounding of a hit 4 units away, at a face that the ray meets at a small angle.
  scene.Look({ 0.3, -0.2, -1 }, 4);
  ExpectDistances(scene, Box(Size), 1e-5);
  scene.LookParallel({ 0.3, -0.2, -1 }, 4, 1);
  ExpectDistances(scene, Box(Size), 1e-5);
}

TEST(Distances, OfFixedStepGoThroughThickMedia)
{
  Scene scene(MakeBox(Size), 16);
  scene.SetSteps(0.05, 0.5);
  scene.Medium->SetExtinction(1e3); // a radiance march would stop in the first step
  scene.Look({ 0.3, -0.2, -1 }, 4);
  ExpectDistances(scene, Box(Size), 1e-5);
}

TEST(Distances, OfPaperAreThoseOfTheBox)
{
  Scene scene(MakeBox(Size), 16);
  scene.Mapper->SetIntegratorToPaper();
  scene.Mapper->SetPaperThreshold(0.5);
  scene.SetSteps(0.05, 0.5);
  scene.Look({ 0.3, -0.2, -1 }, 4);
  ExpectDistances(scene, Box(Size), 1e-5);
  scene.LookParallel({ 0.3, -0.2, -1 }, 4, 1);
  ExpectDistances(scene, Box(Size), 1e-5);
}

TEST(Distances, InWorldUnitsWhateverTheUnits)
{
  for (double unit : { 1e-6, 1e6 })
  {
    SCOPED_TRACE(testing::Message() << "unit " << unit);
    Scene scene(MakeBox(unit * Size), 16);
    scene.Look({ 0.3, -0.2, -1 }, 4 * unit);
    ExpectDistances(scene, Box(unit * Size), 1e-5 * unit);
  }
}

TEST(Distances, CountFromTheNearPlaneOnlyWhereItCuts)
{
  Scene scene(MakeBox(Size), 16);
  scene.SetSteps(0.01, 0.5);
  scene.Look({ 0, 0, -1 }, 1);
  scene.Camera->SetClippingRange(0.8, 10); // the box reaches from 0.6 to 1.4
  ExpectDistances(scene, Box(Size), 1e-5); // EyeRay starts at its near plane
}

TEST(Distances, WindowDepthsAreThoseOfTheFirstPoint)
{
  for (int integrator :
    { vtkSingleScatteringVolumeMapper::Paper, vtkSingleScatteringVolumeMapper::FixedStep })
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    Scene scene(MakeBox(Size), 16);
    scene.AddBeam({ 0, 0, -1 });
    scene.Mapper->SetIntegrator(integrator);
    scene.Look({ 0.3, -0.2, -1 }, 4);
    ExpectDepths(scene, Box(Size));
    scene.LookParallel({ 0.3, -0.2, -1 }, 4, 1);
    ExpectDepths(scene, Box(Size));
  }
}
