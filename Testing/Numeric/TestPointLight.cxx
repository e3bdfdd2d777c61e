// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A lamp inside the medium, where its inverse square changes manyfold within one step (closed form C).
#include "PaperFields.h"
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

/// What Paper draws of a medium of extinction 2, lit by a lamp, and the mean error of its pixels at a step.
struct PaperLampScene : PaperScene
{
  using Truth = std::function<double(const Ray& ray)>; ///< NaN: a ray that does not count

  PaperLampScene(vtkImageData* image, const glm::dvec3& lamp, double halfHeight)
    : PaperScene(image, 12)
  {
    this->Medium->SetExtinction(2);
    this->LookParallel({ 0, 0, -1 }, 3, halfHeight);
    this->Camera->SetClippingRange(1, 10);
    this->AddPointLight(lamp);
  }

  double MeanError(double step, const Truth& truth)
  {
    this->SetSteps(step, step);
    const Picture picture = this->Render();
    EXPECT_TRUE(picture.IsLight());
    double sum = 0, truths = 0;
    ForEachPixel(*this, [&](int x, int y, const Ray& ray) {
      const double expected = truth(ray);
      sum += std::isnan(expected) ? 0 : std::abs(picture.At(x, y) - expected);
      truths += std::isnan(expected) ? 0 : expected;
    });
    return sum / truths;
  }

  /// Left Riemann sums are of first order, and at the last step within `allowed` of the mean radiance.
  void ExpectFirstOrder(const Truth& truth, double allowed)
  {
    double before = 0;
    for (double step : { 0.1, 0.05, 0.025, 0.0125 })
    {
      const double error = this->MeanError(step, truth);
      EXPECT_TRUE(before == 0 || (before / error > 1.6 && before / error < 2.6))
        << "step " << step << ": " << before << ", then " << error;
      before = error;
    }
    EXPECT_LT(before, allowed);
    EXPECT_TRUE(this->Errors.empty());
  }
};

/// By Simpson's rule: a ball around the origin of extinction 2, whose lamp is anywhere.
double BallInLampLight(const Ray& ray, const glm::dvec3& lamp)
{
  const double chord = BallChord(ray, BallRadius);
  const double first = -glm::dot(ray.Origin, ray.Direction) - chord / 2;
  return Isotropic * Simpson(0, chord, 2000, [&](double t) {
    const glm::dvec3 point = ray.Origin + (first + t) * ray.Direction;
    const double distance = glm::distance(lamp, point);
    const glm::dvec3 toLamp = (lamp - point) / distance;
    const double b = glm::dot(point, toLamp);
    const double out =
      std::sqrt(std::max(b * b - glm::dot(point, point) + BallRadius * BallRadius, 0.0)) - b;
    return 2 * std::exp(-2 * (t + std::min(out, distance))) / (distance * distance);
  });
}

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

// Closed form C: the lamp is where no ray passes, and its light ends at it.
TEST(PointLight, PaperConvergesInFirstOrderToALampInABox)
{
  const glm::dvec3 lamp(0.45, -0.1, 0.1);
  PaperLampScene scene(MakeBox(), lamp, 0.3);
  scene.ExpectFirstOrder(
    [&](const Ray& ray) {
      const std::array<double, 2> t = Box(glm::dvec3(1)).Intersect(ray);
      return Isotropic * PointSourceRadiance(ray, lamp, 2, t[0], t[1]);
    },
    0.02);
}

// Light rays find their way out of the ball by their own search, and how much of it is before the lamp.
TEST(PointLight, PaperConvergesInFirstOrderToABallBesideALamp)
{
  for (const glm::dvec3& lamp : { glm::dvec3(1.1, 0.9, 0.4), glm::dvec3(0.1, 0.75, -0.05) })
  {
    SCOPED_TRACE(lamp.x);
    PaperLampScene scene(MakeBall(), lamp, 0.55);
    scene.ExpectFirstOrder(
      [&](const Ray& ray) {
        const bool counts = BallChord(ray, BallRadius) > 0.6;
        return counts ? BallInLampLight(ray, lamp) : std::nan("");
      },
      0.03);
  }
}
