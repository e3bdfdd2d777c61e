// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What no density may change: the furnace, reciprocity, the power of a thin medium; and the ball's limit.
#include "ClosedForms.h"
#include "vtkMediumFixtures.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
using Mapper = vtkSingleScatteringVolumeMapper;

/// The integrators that draw any density; Paper's medium is homogeneous.
struct Conservation : testing::TestWithParam<int>
{
  static void Choose(Scene& scene, double step)
  {
    scene.Mapper->SetIntegrator(GetParam());
    scene.Mapper->SetTransmittanceThreshold(0);
    scene.SetSteps(step, step);
  }
};

const glm::dvec3 CloudSize(1, 0.7, 1.3);

vtkSmartPointer<vtkImageData> MakeCloud()
{
  return vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(16), CloudSize, false);
}

/// Radiance times the picture's area in parallel projection.
double Power(Scene& scene, double halfHeight)
{
  return scene.Render().Mean() * 4 * halfHeight * halfHeight;
}

/// A ball whose surface is a ramp of one voxel, in a cube of 1.
vtkSmartPointer<vtkImageData> MakeSoftBall(int points)
{
  return MakeImage(glm::ivec3(points), glm::dvec3(1), [=](const glm::dvec3& p) {
    return glm::clamp((0.4 - glm::length(p)) * (points - 1) + 0.5, 0.0, 1.0);
  });
}

/// The mean error of the ball's picture, as a fraction of its brightest pixel.
double BallError(Scene& scene, bool fromTheEye)
{
  double sum = 0, peak = 0;
  const Picture picture = scene.Render();
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const double chord = BallChord(ray, 0.4);
    const double truth =
      Isotropic * (fromTheEye ? BallLitFromTheEye(chord, 3) : BallLitFromBehind(chord, 3));
    peak = std::max(peak, truth);
    sum += std::abs(picture.At(x, y) - truth);
  });
  return sum / (scene.Pixels * scene.Pixels) / peak;
}
}

TEST_P(Conservation, BallIsTheLimitOfFinerVoxels)
{
  for (bool fromTheEye : { true, false })
  {
    SCOPED_TRACE(fromTheEye ? "lit from the eye" : "lit from behind");
    double errors[2];
    for (int fine : { 0, 1 })
    {
      Scene scene(MakeSoftBall(fine ? 33 : 17), 24);
      Choose(scene, 0.01);
      scene.Mapper->SetMaximumError(1e-3);
      scene.Medium->SetExtinctionArrayName("");
      scene.Medium->SetExtinctionScale(3);
      scene.AddBeam({ 0, 0, fromTheEye ? -1.0 : 1.0 });
      scene.LookParallel({ 0, 0, -1 }, 2, 0.5);
      errors[fine] = BallError(scene, fromTheEye);
    }
    EXPECT_LT(errors[1], 0.5 * errors[0]); // first order or better
  }
}

// Emission of sigma_t times 0.6 is what a furnace of that radiance scatters into any view at albedo 1.
TEST_P(Conservation, FurnaceOfAnyDensity)
{
  Scene scene(MakeCloud(), 16);
  Choose(scene, 0.02);
  scene.Medium->SetExtinctionArrayName("");
  scene.Medium->SetExtinctionScale(5);
  scene.Medium->SetAlbedo(0);
  scene.Medium->SetEmissionArrayName("");
  scene.Medium->SetEmissionScale(3);
  scene.Look({ 0.4, -0.3, -1 }, 2.4);
  const Picture picture = scene.Render();
  const double tolerance =
    GetParam() == Mapper::ErrorControlled ? scene.Mapper->GetMaximumError() : 1e-4;
  ASSERT_GT(picture.Mean(3), 0.05);
  ForEachPixel(scene, [&](int x, int y, const Ray&) {
    const double depth = -std::log1p(-picture.At(x, y, 3));
    ASSERT_NEAR(picture.At(x, y), FurnaceRadiance(0.6, depth), tolerance * 0.6) << x << ", " << y;
  });
}

TEST_P(Conservation, FurnaceBoundsWhatIsLit)
{
  Scene scene(MakeCloud(), 16);
  Choose(scene, 0.02);
  scene.Medium->SetExtinctionArrayName("");
  scene.Medium->SetExtinctionScale(5);
  scene.Medium->SetAlbedo(0.8);
  scene.AddBeam({ 0.3, -0.8, -0.4 });
  scene.Look({ 0.4, -0.3, -1 }, 2.4);
  const Picture picture = scene.Render();
  ASSERT_GT(picture.Mean(), 0);
  ForEachPixel(scene, [&](int x, int y, const Ray&) {
    const double depth = -std::log1p(-picture.At(x, y, 3));
    ASSERT_LE(picture.At(x, y), Isotropic * FurnaceRadiance(0.8, depth) * (1 + 1e-4) + 1e-6);
  });
}

TEST_P(Conservation, ViewAndLightMayBeExchanged)
{
  const glm::dvec3 pairs[][2] = { { { 0, 0, -1 }, { 1, 0, 0 } },
    { { 0.4, -0.3, -1 }, { 0.3, 0.8, 0.4 } }, { { -1, 0.2, 0.5 }, { 0.1, -1, 0.6 } } };
  for (const auto& [view, beam] : pairs)
  {
    Scene scene(MakeCloud(), 48);
    Choose(scene, 0.02);
    scene.Medium->SetExtinctionArrayName("");
    scene.Medium->SetExtinctionScale(5);
    scene.Medium->SetAnisotropy(0.4);
    vtkSmartPointer<vtkLight> light = scene.AddBeam(beam);
    scene.LookParallel(view, 3, 0.95);
    const double there = Power(scene, 0.95);
    scene.Renderer->RemoveLight(light);
    scene.AddBeam(view);
    scene.LookParallel(beam, 3, 0.95);
    EXPECT_NEAR(Power(scene, 0.95) / there, 1, 0.01);
  }
}

TEST_P(Conservation, ThinPowerIsThatOfTheWholeMedium)
{
  Scene scene(MakeBox(CloudSize), 48);
  Choose(scene, 0.02);
  scene.Medium->SetExtinction(1e-3);
  scene.AddBeam({ 0.3, -0.8, -0.4 });
  scene.LookParallel({ 0.4, -0.3, -1 }, 3, 0.95);
  const double truth = Isotropic * ThinPower(CloudSize.x * CloudSize.y * CloudSize.z, 1e-3);
  EXPECT_NEAR(
    Power(scene, 0.95) / truth, 1, 0.01); // the silhouette's pixels, and 1e-3 of extinction
}

INSTANTIATE_TEST_SUITE_P(Mapper, Conservation,
  testing::Values(Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact),
  [](const auto& parameters) {
    return std::string(parameters.param == Mapper::FixedStep ? "FixedStep"
        : parameters.param == Mapper::Exact                  ? "Exact"
                                                             : "ErrorControlled");
  });
