// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The Paper integrator's three modes on a ball, whose chord and radiance are known.
#include "PaperFields.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
constexpr double Sigma = 2;

/// A parallel view along -z onto the ball.
struct BallScene : PaperScene
{
  BallScene()
    : PaperScene(MakeBall())
  {
    this->LookParallel({ 0, 0, -1 }, 3, 0.9);
    this->Camera->SetClippingRange(1, 10);
    this->Medium->SetExtinction(Sigma);
  }

  /// Visits pixels whose chord is well away from the silhouette, where surface errors blow up.
  void ForEachChord(const std::function<void(int x, int y, double chord, const Ray&)>& visit)
  {
    ForEachPixel(*this, [&](int x, int y, const Ray& ray) {
      const double chord = BallChord(ray, BallRadius);
      if (chord > 0.6)
      {
        visit(x, y, chord, ray);
      }
    });
  }
};

/// An error of the surface changes a chord of half length c/2 by its part along the ray, at each end.
double ChordError(double chord)
{
  return 2 * BallSurfaceError * BallRadius / (chord / 2);
}

/// The light path out of the ball from a point inside.
double LightPath(const glm::dvec3& point, const glm::dvec3& toLight)
{
  const double b = glm::dot(point, toLight);
  return -b + std::sqrt(std::max(b * b - glm::dot(point, point) + BallRadius * BallRadius, 0.0));
}

/// Radiance of one ray by Simpson's rule with 2000 intervals.
double BallRadiance(const Ray& ray, double chord, const glm::dvec3& toLight)
{
  const int n = 2000;
  const double h = chord / n;
  double sum = 0;
  for (int i = 0; i <= n; ++i)
  {
    const glm::dvec3 point(ray.Origin.x, ray.Origin.y, chord / 2 - i * h);
    const double weight = i == 0 || i == n ? 1 : i % 2 ? 4 : 2;
    sum += weight * std::exp(-Sigma * (i * h + LightPath(point, toLight)));
  }
  return Isotropic * Sigma * sum * h / 3;
}

double MeanError(BallScene& scene, const glm::dvec3& toLight)
{
  const Picture picture = scene.Render();
  double sum = 0;
  int count = 0;
  scene.ForEachChord([&](int x, int y, double chord, const Ray& ray) {
    sum += std::abs(picture.At(x, y) - BallRadiance(ray, chord, toLight));
    ++count;
  });
  return sum / count;
}
}

TEST(PaperBall, FirstHitIsTheNearPoint)
{
  BallScene scene;
  scene.Mapper->SetOutputToFirstHit();
  scene.SetSteps(0.05, 0.05);
  const Picture picture = scene.Render();
  scene.ForEachChord([&](int x, int y, double chord, const Ray&) {
    ASSERT_NEAR(picture.At(x, y), 2 - chord / 2, ChordError(chord)) << x << ", " << y;
  });
}

TEST(PaperBall, DistanceIsTheChord)
{
  BallScene scene;
  scene.Mapper->SetOutputToDistance();
  scene.SetSteps(0.05, 0.05);
  const Picture picture = scene.Render();
  scene.ForEachChord([&](int x, int y, double chord, const Ray&) {
    ASSERT_NEAR(picture.At(x, y), chord, ChordError(chord)) << x << ", " << y;
  });
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    if (std::hypot(ray.Origin.x, ray.Origin.y) > BallRadius + BallSpacing)
    {
      ASSERT_EQ(picture.At(x, y, 3), 0) << "a ray that misses hits " << x << ", " << y;
    }
  });
}

TEST(PaperBall, BinarySearchHalvesTheErrorOfAHit)
{
  BallScene scene;
  scene.Mapper->SetOutputToFirstHit();
  const double step = 0.4;
  scene.SetSteps(step, step);
  double before = 0;
  for (int n = 0; n <= 10; ++n)
  {
    scene.Mapper->SetBinarySearchIterations(n);
    const Picture picture = scene.Render();
    double sum = 0;
    int count = 0;
    scene.ForEachChord([&](int x, int y, double chord, const Ray&) {
      const double error = std::abs(picture.At(x, y) - (2 - chord / 2));
      // The middle of a bracket of 2^-n of a step.
      ASSERT_LE(error, std::ldexp(step, -n - 1) + ChordError(chord)) << "iterations " << n;
      sum += error;
      ++count;
    });
    // Hits are spread evenly enough over a bracket for its mean error to halve, until the grid shows.
    if (n >= 1 && n <= 5)
    {
      EXPECT_NEAR(before / (sum / count), 2, 0.4) << "iterations " << n;
    }
    before = sum / count;
  }
}

TEST(PaperBall, BacklitRadianceIsThatOfTheChord)
{
  // Every point has the way c to go, so that Riemann sums are exact but for the light path's search.
  BallScene scene;
  scene.AddBeam({ 0, 0, 1 });
  scene.SetSteps(0.02, 0.02);
  const Picture picture = scene.Render();
  scene.ForEachChord([&](int x, int y, double chord, const Ray&) {
    const double truth = Isotropic * Sigma * chord * std::exp(-Sigma * chord);
    // d(truth) / dc is at most truth (1 / c + sigma); the light path has an error of its own.
    ASSERT_NEAR(picture.At(x, y), truth, truth * (1 / chord + 2 * Sigma) * ChordError(chord));
    ASSERT_NEAR(picture.At(x, y, 3), -std::expm1(-Sigma * chord), Sigma * ChordError(chord));
  });
}

TEST(PaperBall, FrontLitRadianceConvergesInFirstOrder)
{
  BallScene scene;
  scene.AddBeam({ 0, 0, -1 });
  double before = 0;
  for (double step : { 0.2, 0.1, 0.05, 0.025 })
  {
    scene.SetSteps(step, 0.01);
    const Picture picture = scene.Render();
    double sum = 0;
    int count = 0;
    scene.ForEachChord([&](int x, int y, double chord, const Ray&) {
      const double truth = Isotropic * Sigma * chord * MeanTransmittance(2 * Sigma * chord);
      sum += std::abs(picture.At(x, y) - truth);
      ++count;
    });
    if (before > 0)
    {
      EXPECT_GT(before / (sum / count), 1.6) << "step " << step;
      EXPECT_LT(before / (sum / count), 2.6) << "step " << step;
    }
    before = sum / count;
  }
}

TEST(PaperBall, SideLitRadianceConvergesInFirstOrder)
{
  BallScene scene;
  const glm::dvec3 toLight = glm::normalize(glm::dvec3(0.5, 0.7, 0.3));
  scene.AddBeam(-toLight);
  double before = 0;
  for (double step : { 0.2, 0.1, 0.05, 0.025 })
  {
    scene.SetSteps(step, step);
    const double error = MeanError(scene, toLight);
    if (before > 0)
    {
      EXPECT_GT(before / error, 1.6) << "step " << step;
      EXPECT_LT(before / error, 2.6) << "step " << step;
    }
    before = error;
  }
  // Left Riemann sums err by about h/2 (f(first) - f(last)), at most half of a step's source.
  EXPECT_LT(before, 0.5 * 0.025 * Isotropic * Sigma);
}

TEST(PaperBall, JitterOnlyDarkensWithinItsShareOfAStep)
{
  // From the camera: the integrand falls as f = exp(-2 sigma t), so a sample that is later by a share xi
  // of the step h is darker by h (f(first) - f(last)) (1 - exp(-2 sigma xi h)) / (1 - exp(-2 sigma h)).
  BallScene scene;
  scene.AddBeam({ 0, 0, -1 });
  const double step = 0.1, jitter = 0.2;
  scene.SetSteps(step, 0.01);
  const Picture regular = scene.Render();
  scene.Mapper->SetJitter(jitter);
  const Picture jittered = scene.Render();
  const double largest = step * -std::expm1(-2 * Sigma * jitter * step) /
    -std::expm1(-2 * Sigma * step) * Isotropic * Sigma;
  double least = 1, most = 0;
  scene.ForEachChord([&](int x, int y, double, const Ray&) {
    const double darker = regular.At(x, y) - jittered.At(x, y);
    const double share = darker / largest;
    ASSERT_GE(share, -0.01); // of the light path's search
    ASSERT_LE(share, 1.01);
    least = std::min(least, share);
    most = std::max(most, share);
  });
  EXPECT_LT(least, 0.2); // it is a spread of random numbers
  EXPECT_GT(most, 0.7);
}

TEST(PaperBall, FullJitterIsUnbiasedToFirstOrder)
{
  // Offsets over the whole of a step turn the left Riemann sum into a midpoint rule on average.
  BallScene scene;
  scene.AddBeam({ 0, 0, -1 });
  scene.SetSteps(0.1, 0.01);
  auto meanError = [&scene](double jitter) {
    scene.Mapper->SetJitter(jitter);
    const Picture picture = scene.Render();
    double sum = 0, squares = 0;
    int count = 0;
    scene.ForEachChord([&](int x, int y, double chord, const Ray&) {
      const double truth = Isotropic * Sigma * chord * MeanTransmittance(2 * Sigma * chord);
      const double error = picture.At(x, y) / truth - 1;
      sum += error;
      squares += error * error;
      ++count;
    });
    return glm::dvec2(sum, std::sqrt(squares)) / double(count);
  };
  const double biased = meanError(0)[0];
  const glm::dvec2 jittered = meanError(0.999);
  EXPECT_GT(biased, 0.1);
  // Three standard errors of the mean, and the second order of a midpoint rule, (2 sigma h)^2 / 24.
  EXPECT_LT(std::abs(jittered[0]), 3 * jittered[1] + 0.01);
}

TEST(PaperBall, PhaseFunctionIsSchlicks)
{
  BallScene scene;
  scene.SetSteps(0.1, 0.1);
  scene.AddBeam({ 0, 0, 1 });
  const Picture isotropic = scene.Render();
  for (double g : { 0.5, -0.5 })
  {
    scene.Medium->SetAnisotropy(g);
    const double k = 1.55 * g - 0.55 * g * g * g;
    // From the ball to the eye is +z, as the light travels: forward scattering.
    EXPECT_NEAR(scene.Render().At(12, 12) / isotropic.At(12, 12), Schlick(1, k) / Isotropic, 1e-3);
  }
}
