// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The reference against closed forms. Its own tolerance is 1e-9 of the ray's radiance here, so 1e-9
// relative is the tolerance of a test unless the form itself is less accurate.
#include "ReferenceSetting.h"
#include "vtkMediumFixtures.h"

#include <gtest/gtest.h>

using namespace ReferenceTests;

namespace
{
constexpr double Tolerance = 1e-9;

double One(const glm::dvec3&)
{
  return 1;
}

double RandomDensity(const glm::dvec3& box)
{
  const glm::ivec3 at(glm::floor(box * 64.0 + 0.5));
  return vtkMediumFixtures::Random(at.x + 65 * (at.y + 65 * at.z), 7);
}
}

// Homogeneous box, eye ray along x through its centre, light path l0 + kappa s:
// L = sigma p E exp(-sigma l0) d phi(sigma (1 + kappa) d).
TEST(ReferenceClosedForms, BoxWithDirectionalLight)
{
  struct Case
  {
    glm::dvec3 Light;
    double Start, Kappa;
  };
  const double oblique = std::sqrt(1 + 0.4 * 0.4); // leaves by the x faces for all s in [0, 1]
  const Case cases[] = { { { 1, 0, 0 }, 0, 1 }, { { -1, 0, 0 }, 1, -1 }, { { 0, 0, -1 }, 0.5, 0 },
    { { 0, 1, 0 }, 0.5, 0 }, { { 1, 0.4, 0 }, 0, oblique }, { { -1, 0, 0.4 }, oblique, -oblique } };
  for (double sigma : { 1e-8, 1e-3, 0.7, 5.0, 40.0, 80.0 })
  {
    for (const Case& at : cases)
    {
      Setting setting(MakeGrid({ 9, 8, 7 }, glm::dvec3(1), One), sigma);
      setting.AddDirectionalLight(glm::normalize(at.Light));
      const double truth =
        sigma * Isotropic * std::exp(-sigma * at.Start) * MeanTransmittance(sigma * (1 + at.Kappa));
      const glm::dvec4 rgba = setting.Radiance({ -2, 0.5, 0.5 }, { 3, 0, 0 });
      EXPECT_NEAR(rgba.x / truth, 1, Tolerance) << "sigma " << sigma << ", kappa " << at.Kappa;
      EXPECT_NEAR(rgba.w / -std::expm1(-sigma), 1, 1e-12);
    }
  }
}

// Where everything happens within a fraction 1e-6 … 1e-30 of the box. Positions have 53 bits, so a depth
// from the surface, and with it the light's optical depth, is uncertain by sigma x 2^-53; where that is
// more than 1, the light may count as unweakened, which doubles the truth.
TEST(ReferenceClosedForms, BoxOfExtremeOpticalDepthShinesWithItsSurface)
{
  for (double sigma : { 88.0, 1e3, 1e6, 1e12, 1e30 })
  {
    Setting setting(MakeGrid({ 9, 9, 9 }, glm::dvec3(1), One), sigma);
    setting.AddDirectionalLight({ 1, 0, 0 });
    const glm::dvec4 rgba = setting.Radiance({ -2, 0.5, 0.5 }, { 1, 0, 0 });
    const double resolution = std::min(4 * sigma * std::pow(2, -53), 1.0);
    EXPECT_NEAR(rgba.x / (Isotropic / 2), 1, Tolerance + resolution) << "sigma " << sigma;
    EXPECT_LE(1 - rgba.w, 1e-15);
  }
}

// The voxelised ball of nearest interpolation has chords within two voxels of the ball's.
TEST(ReferenceClosedForms, BallIsTheLimitOfFinerVoxels)
{
  const double radius = 0.4, sigma = 2;
  for (int points : { 17, 33, 65, 129 })
  {
    Setting setting(
      MakeGrid(glm::ivec3(points), glm::dvec3(1),
        [&](const glm::dvec3& box) { return glm::length(box - 0.5) < radius ? 1.0 : 0.0; }),
      sigma);
    setting.Property->SetInterpolationTypeToNearest();
    const auto light = setting.AddDirectionalLight({ 1, 0, 0 });
    for (double offset : { 0.0, 0.15, 0.3 })
    {
      const double chord = 2 * std::sqrt(radius * radius - offset * offset);
      const double bound = 2 * sigma * Isotropic / (points - 1);
      light->SetPosition(-1, 0, 0);
      const double fromEye = Isotropic * BallLitFromTheEye(chord, sigma);
      EXPECT_NEAR(setting.Radiance({ -2, 0.5 + offset, 0.5 }, { 1, 0, 0 }).x, fromEye, bound);
      light->SetPosition(1, 0, 0);
      const double towardsEye = Isotropic * BallLitFromBehind(chord, sigma);
      EXPECT_NEAR(setting.Radiance({ -2, 0.5 + offset, 0.5 }, { 1, 0, 0 }).x, towardsEye, bound);
    }
  }
}

// For the part of the ray inside the box.
TEST(ReferenceClosedForms, PointSourceInHomogeneousMedium)
{
  const glm::dvec3 origin(0.05, 0.4, 0.5);
  for (double distance : { 0.3, 0.1, 1e-2, 1e-3 })
  {
    for (double sigma : { 0.3, 4.0 })
    {
      Setting setting(MakeGrid({ 6, 7, 8 }, glm::dvec3(1), One), sigma);
      setting.AddPointLight({ 0.55, 0.4 + distance, 0.5 });
      const double truth = Isotropic *
        PointSourceRadiance(
          { origin, { 1, 0, 0 }, 0 }, { 0.55, 0.4 + distance, 0.5 }, sigma, 0, 0.95);
      EXPECT_NEAR(setting.Radiance(origin, { 1, 0, 0 }).x / truth, 1, Tolerance)
        << "distance " << distance << ", sigma " << sigma;
    }
  }
}

// tau = sigma0 exp(-z0/H) s phi(s sin / H). Linear interpolation of exp(-z/H) at a spacing h is off by
// at most h^2 / (8 H^2) of the value, so the integral too.
TEST(ReferenceClosedForms, ExponentialAtmosphere)
{
  const double height = 0.25, sigma = 3;
  const int points = 1025;
  Setting setting(MakeGrid({ 3, 3, points }, glm::dvec3(1),
                    [&](const glm::dvec3& box) { return std::exp(-box.z / height); }),
    sigma);
  const double sampling = std::pow(1.0 / (points - 1) / height, 2) / 8;
  const glm::dvec3 ends[] = { { 0.9, 0.8, 0.95 }, { 0.9, 0.9, 0.1000001 }, { 0.1, 0.1, 0.6 } };
  for (const glm::dvec3& end : ends)
  {
    const glm::dvec3 begin(0.1, 0.1, 0.1);
    const double length = glm::length(end - begin);
    const double truth =
      AtmosphereDepth(sigma, height, begin.z, (end.z - begin.z) / length, length);
    EXPECT_NEAR(setting.OpticalDepth(begin, end) / truth, 1, sampling + 1e-13);
    EXPECT_NEAR(setting.OpticalDepth(end, begin) / truth, 1, sampling + 1e-13);
  }
}

// tau = a s + b s^2 / 2, which the trilinear field represents exactly.
TEST(ReferenceClosedForms, LinearRamp)
{
  const glm::dvec3 slope(3, 2, 5);
  Setting setting(MakeGrid({ 5, 4, 11 }, glm::dvec3(1),
                    [&](const glm::dvec3& box) { return 0.5 + glm::dot(slope, box); }),
    1.7);
  for (int i = 0; i < 50; ++i)
  {
    glm::dvec3 a, b;
    for (int axis = 0; axis < 3; ++axis)
    {
      a[axis] = vtkMediumFixtures::Random(6 * i + axis, 3);
      b[axis] = vtkMediumFixtures::Random(6 * i + 3 + axis, 3);
    }
    const double s = glm::length(b - a);
    const double truth = 1.7 * RampDepth(0.5 + glm::dot(slope, a), glm::dot(slope, (b - a) / s), s);
    EXPECT_NEAR(setting.OpticalDepth(a, b) / truth, 1, 1e-13);
  }
}

// A medium that glows in proportion to its extinction shows S (1 - T), whatever its density.
TEST(ReferenceClosedForms, FurnaceOfAnyDensity)
{
  for (double sigma : { 0.1, 20.0, 3000.0 })
  {
    Setting setting(MakeGrid(glm::ivec3(14), { 1, 2, 0.5 }, RandomDensity), sigma);
    setting.Medium->SetEmissionArrayName("");
    setting.Medium->SetEmissionScale(sigma, 2 * sigma, 3 * sigma);
    const glm::dvec3 origin(-0.3, 0.2, 0.1);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1, 1, 0.15));
    const glm::dvec4 rgba = setting.Radiance(origin, direction);
    const double absorbed = -std::expm1(-setting.OpticalDepth(origin, origin + 9.0 * direction));
    EXPECT_NEAR(rgba.w, absorbed, 1e-13);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(rgba[c] / ((c + 1) * absorbed), 1, Tolerance) << "sigma " << sigma;
    }
  }
}

// With light that reaches every point unweakened L would be p E (1 - T); attenuation only takes away.
TEST(ReferenceClosedForms, FurnaceBoundsWhatIsLit)
{
  Setting setting(MakeGrid(glm::ivec3(14), glm::dvec3(1), RandomDensity), 6);
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(-1, 2, 1)));
  for (int i = 0; i < 20; ++i)
  {
    const glm::dvec3 direction = vtkMediumFixtures::RandomDirection(i, 5);
    const glm::dvec4 rgba = setting.Radiance(glm::dvec3(0.5) - 2.0 * direction, direction);
    EXPECT_GT(rgba.x, 0);
    EXPECT_LT(rgba.x, Isotropic * rgba.w);
  }
}

// Chandrasekhar's diffuse reflection and transmission of a slab, single scattering; the transmission
// cancels where the two cosines meet.
TEST(ReferenceClosedForms, SlabReflectionAndTransmission)
{
  const double tau = 1.3;
  for (double mu : { 1.0, 0.8, 0.3 })
  {
    for (double mu0 : { 0.9, 0.3, 0.3 + 1e-7, 0.5 })
    {
      Setting setting(MakeGrid({ 3, 3, 5 }, { 100, 100, 1 }, One), tau);
      const double sin0 = std::sqrt(1 - mu0 * mu0), sine = std::sqrt(1 - mu * mu);
      const auto light = setting.AddDirectionalLight({ sin0, 0, -mu0 });
      const glm::dvec3 origin(50 - 2 * sine / mu, 50, 1 + 2);
      const double reflected = Isotropic * SlabReflection(tau, mu, mu0);
      EXPECT_NEAR(setting.Radiance(origin, { sine, 0, -mu }).x / reflected, 1, Tolerance);

      light->SetPosition(-sin0, 0, -mu0); // from below
      const double transmitted = Isotropic * SlabTransmission(tau, mu, mu0);
      EXPECT_NEAR(setting.Radiance(origin, { sine, 0, -mu }).x / transmitted, 1, Tolerance);
    }
  }
}

// Chromatic extinction and albedo: each channel is a medium of its own.
TEST(ReferenceClosedForms, ChannelsAreIndependent)
{
  Setting setting(MakeGrid({ 5, 5, 5 }, glm::dvec3(1), One), 1);
  const glm::dvec3 sigma(0.5, 2, 7), albedo(1, 0.25, 0.6), color(1, 2, 0.5);
  setting.Medium->SetExtinctionScale(sigma.x, sigma.y, sigma.z);
  setting.Medium->SetAlbedo(albedo.x, albedo.y, albedo.z);
  const auto light = setting.AddDirectionalLight({ 1, 0, 0 });
  light->SetColor(color.x, color.y, color.z);
  const glm::dvec4 rgba = setting.Radiance({ -1, 0.5, 0.5 }, { 1, 0, 0 });
  double alpha = 0;
  for (int c = 0; c < 3; ++c)
  {
    const double truth = albedo[c] * color[c] * Isotropic * -std::expm1(-2 * sigma[c]) / 2;
    EXPECT_NEAR(rgba[c] / truth, 1, Tolerance);
    alpha -= std::expm1(-sigma[c]) / 3;
  }
  EXPECT_NEAR(rgba.w, alpha, 1e-14);
}
