// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A lamp inside the medium, where its inverse square changes manyfold within one step (closed form C).
#include "ReferenceScene.h"

using namespace vtkMediumTest;

namespace
{
/// Rays along -z through a unit box of extinction 2, and a lamp beside them in its middle.
struct LampScene : Scene
{
  glm::dvec3 Lamp;

  explicit LampScene(const glm::dvec3& lamp)
    : Scene(MakeBox(), 8)
    , Lamp(lamp)
  {
    this->Medium->SetExtinction(2);
    this->Mapper->SetTransmittanceThreshold(0);
    this->LookParallel({ 0, 0, -1 }, 2, 0.4);
    this->AddPointLight(lamp);
  }

  /// The largest error of FixedStep over the pixels, relative to the truth of each.
  double Measure(double step)
  {
    this->SetSteps(step, step);
    const Picture picture = this->Render();
    EXPECT_TRUE(picture.IsLight());
    double largest = 0;
    ForEachPixel(*this, [&](int x, int y, const Ray& ray) {
      const std::array<double, 2> t = Box(glm::dvec3(1)).Intersect(ray);
      const double truth = Isotropic * PointSourceRadiance(ray, this->Lamp, 2, t[0], t[1]);
      largest = std::max(largest, std::abs(picture.At(x, y) / truth - 1));
    });
    return largest;
  }
};

/// Lamps at these distances from the ray of the pixel whose centre is at (0.05, 0.05).
const double Distances[] = { 0.05, 1e-2, 1e-3 };

glm::dvec3 LampBeside(double distance)
{
  return { 0.05, 0.05 + distance, 0.013 };
}
}

// 17 % at one voxel if each step takes the inverse square at its middle.
TEST(PointLight, ALampInsideIsSeenInStepsFarLongerThanItsDistance)
{
  for (double distance : Distances)
  {
    LampScene scene(LampBeside(distance));
    for (double step : { 0.1, 1.0 / 31, 0.01 })
    {
      // What varies over a step but the inverse square: sigma h / 2 of the way to the lamp, squared.
      EXPECT_LT(scene.Measure(step), 1e-2) << "distance " << distance << ", step " << step;
    }
  }
}

TEST(PointLight, TheErrorFallsInSecondOrder)
{
  LampScene scene(LampBeside(0.05));
  const double order = std::log10(scene.Measure(0.1) / scene.Measure(0.01));
  EXPECT_GT(order, 1.7);
}

// No step of the sequence is far from where the attenuation begins to be averaged.
TEST(PointLight, IsContinuousWhereTheMeanTakesOver)
{
  LampScene scene({ 0, 0, 1.4 });
  double before = 0;
  for (double step = 0.05; step < 0.1; step *= 1.02)
  {
    scene.SetSteps(step, 0.01);
    const double radiance = scene.Render().At(4, 4);
    EXPECT_TRUE(before == 0 || std::abs(radiance / before - 1) < 2e-3) << "step " << step;
    before = radiance;
  }
}

// In a field of its own, with a phase function, whose truth is the reference's.
TEST(PointLight, InsideASmoothFieldIsMet)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.Renderer->RemoveAllLights();
  scene.AddPointLight({ 0.05, -0.08, 0.1 });
  scene.FindTruth();
  const double voxel = scene.Measure(ReferenceVoxel).Largest;
  const double half = scene.Measure(0.5 * ReferenceVoxel).Largest;
  EXPECT_LT(voxel, 1e-2);
  EXPECT_LT(half, 4e-3);
}
