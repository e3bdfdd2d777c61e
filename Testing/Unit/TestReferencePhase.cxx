// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The reference's phase functions, seen through what a thin box scatters at each angle.
#include "ReferenceSetting.h"

#include <gtest/gtest.h>

using namespace ReferenceTests;

namespace
{
using Medium = vtkParticipatingMedium;

double One(const glm::dvec3&)
{
  return 1;
}

// A box so thin that only the phase function is left; the light reaches the eye's ray at an angle whose
// cosine is `cosine`, 1 for a light behind the box that shines at the eye.
class Scatterer
{
public:
  explicit Scatterer(int phase, double g)
    : At(MakeGrid({ 3, 3, 3 }, glm::dvec3(1), One), Sigma)
  {
    this->At.Medium->SetPhaseFunction(phase);
    this->At.Medium->SetAnisotropy(g);
    this->Light = this->At.AddDirectionalLight({ 1, 0, 0 });
  }

  double Phase(double cosine)
  {
    // The eye looks along +x, so the way to the eye is -x.
    this->Light->SetPosition(cosine, -std::sqrt(1 - cosine * cosine), 0);
    return this->At.Radiance({ -1, 0.5, 0.5 }, { 1, 0, 0 }).x / Sigma;
  }

  static constexpr double Sigma = 1e-11; ///< attenuation changes less than 2e-11
  Setting At;
  vtkSmartPointer<vtkLight> Light;
};

const double Cosines[] = { -1, -0.7, 0, 0.31, 0.99, 1 };
}

TEST(ReferencePhase, ValuesAreThoseOfTheDefinitions)
{
  for (double g : { -0.8, -0.2, 0.0, 0.5, 0.9 })
  {
    Scatterer isotropic(Medium::Isotropic, g), schlick(Medium::Schlick, g),
      schlickK(Medium::SchlickK, g), henyey(Medium::HenyeyGreenstein, g),
      rayleigh(Medium::Rayleigh, g);
    for (double c : Cosines)
    {
      EXPECT_NEAR(isotropic.Phase(c), 1 / (4 * Pi), 1e-10);
      EXPECT_NEAR(rayleigh.Phase(c), 3 / (16 * Pi) * (1 + c * c), 1e-10);
      EXPECT_NEAR(henyey.Phase(c) / HenyeyGreenstein(c, g), 1, 1e-9);
      EXPECT_NEAR(schlickK.Phase(c) / Schlick(c, g), 1, 1e-9);
      EXPECT_NEAR(schlick.Phase(c) / Schlick(c, 1.55 * g - 0.55 * g * g * g), 1, 1e-9);
    }
  }
}

// Draine's function contains two known ones: Rayleigh's (g 0, alpha 1) and Henyey and Greenstein's.
TEST(ReferencePhase, DraineContainsRayleighAndHenyeyGreenstein)
{
  Scatterer rayleigh(Medium::Draine, 0), henyey(Medium::Draine, 0.6);
  rayleigh.At.Medium->SetDraineAlpha(1);
  henyey.At.Medium->SetDraineAlpha(0);
  for (double c : Cosines)
  {
    EXPECT_NEAR(rayleigh.Phase(c), 3 / (16 * Pi) * (1 + c * c), 1e-10);
    EXPECT_NEAR(henyey.Phase(c) / HenyeyGreenstein(c, 0.6), 1, 1e-9);
  }
}

// 2 pi times the integral over the cosine is 1; Simpson's rule on 400 intervals keeps 1e-6 for these g.
TEST(ReferencePhase, EveryFunctionIntegratesToOneOverTheSphere)
{
  for (int phase : { Medium::Isotropic, Medium::Schlick, Medium::SchlickK, Medium::HenyeyGreenstein,
         Medium::DoubleHenyeyGreenstein, Medium::Rayleigh, Medium::Draine, Medium::Droplets })
  {
    for (double g : { -0.7, 0.0, 0.4, 0.8 })
    {
      if (phase == Medium::Droplets && g != 0)
      {
        continue; // its parameters follow from the droplet's diameter, and its peak is too sharp here
      }
      Scatterer at(phase, g);
      at.At.Medium->SetDraineAlpha(2.5);
      // cosine = u (3 - u^2) / 2 packs the samples towards both peaks.
      const double sum =
        2 * Pi * Simpson(-1, 1, phase == Medium::Droplets ? 20000 : 400, [&](double u) {
          return at.Phase(std::max(-1.0, std::min(1.0, u * (3 - u * u) / 2))) * 1.5 * (1 - u * u);
        });
      EXPECT_NEAR(sum, 1, phase == Medium::Droplets ? 1e-3 : 1e-5)
        << "phase " << phase << ", g " << g;
    }
  }
}

// At |g| = 1 the functions would be a delta: they are held at 0.999, finite and not negative.
TEST(ReferencePhase, LimitsStayFiniteAndNonNegative)
{
  for (int phase : { Medium::Schlick, Medium::SchlickK, Medium::HenyeyGreenstein, Medium::Draine })
  {
    for (double g : { -1.0, -0.97, 0.95, 0.97, 0.9995, 1.0 })
    {
      Scatterer at(phase, g);
      for (double c : Cosines)
      {
        EXPECT_GT(at.Phase(c), 0) << "phase " << phase << ", g " << g << ", cosine " << c;
        EXPECT_LT(at.Phase(c), 2e6);
      }
    }
  }
}
