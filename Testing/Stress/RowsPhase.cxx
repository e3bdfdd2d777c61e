// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 22 to 25: phase functions, as seen in a medium so thin that nothing else matters.
#include "StressStage.h"

namespace vtkMediumStress
{
namespace
{
constexpr double Thin = 1e-5; // weakens by less than 3e-5
using Medium = vtkParticipatingMedium;

struct ThinStage : Stage
{
  explicit ThinStage(Trial& trial)
    : Stage(trial, MakeBox({ 1, 1, 1 }), 2)
  {
    this->LookParallel({ 0, 0, -1 }, 2, 0.2);
    this->SetSigma(Thin);
    this->SetSteps(0.25, 0.5);
    this->Light = this->AddBeam({ 0, 0, 1 });
  }

  /// The phase function's value, from the radiance of an optical depth.
  double Measure(double cosTheta)
  {
    const double sinTheta = std::sqrt(std::max(1 - cosTheta * cosTheta, 0.0));
    this->Light->SetPosition(-sinTheta, 0, -cosTheta); // it travels from there towards 0
    return this->Render().At(0, 0) / Thin;
  }

  vtkSmartPointer<vtkLight> Light;
};

/// What the integrator documents for an anisotropy g: Paper has Schlick's.
double Truth(const Trial& trial, double cosTheta, double g)
{
  if (trial.Is(Mapper::Paper))
  {
    const double k = 1.55 * g - 0.55 * g * g * g;
    return Schlick(cosTheta, std::min(std::max(k, -0.999), 0.999));
  }
  return HenyeyGreenstein(cosTheta, std::min(std::max(g, -0.999), 0.999));
}

void EveryAnisotropy(Trial& trial)
{
  ThinStage stage(trial);
  for (double g : { -1.0, -0.999, -0.97, -0.938, -0.5, 0.0, 0.5, 0.938, 0.95, 0.97, 0.999, 1.0 })
  {
    stage.Medium->SetAnisotropy(g);
    for (double cosTheta : { -1.0, -0.5, 0.0, 0.5, 0.9, 0.97 })
    {
      const double value = stage.Measure(cosTheta);
      trial.Holds(value >= 0, "the phase function is never negative");
      trial.AtMost(std::abs(value / Truth(trial, cosTheta, g) - 1), 1e-3,
        "relative error at g = " + std::to_string(g) + ", cos " + std::to_string(cosTheta));
    }
  }
}

/// The integral over the sphere, over u = 1 / (1 - k cos): Schlick's function is even in u.
void Normalised(Trial& trial)
{
  ThinStage stage(trial);
  stage.Medium->SetPhaseFunctionToSchlickK();
  const int n = 12;
  for (double k : { -0.99, -0.5, 0.3, 0.9, 0.99 })
  {
    stage.Medium->SetAnisotropy(k);
    const double first = 1 / (1 + k), last = 1 / (1 - k), width = (last - first) / n;
    double sum = 0;
    for (int i = 0; i < n; ++i)
    {
      const double u = first + (i + 0.5) * width;
      sum += 2 * Pi * stage.Measure((1 - 1 / u) / k) * width / (k * u * u);
    }
    trial.AtMost(std::abs(sum - 1), 1e-3, "integral - 1 at k = " + std::to_string(k));
  }
}

void Peaks(Trial& trial)
{
  ThinStage stage(trial);
  for (double g : { 0.9, -0.9, 0.5 })
  {
    stage.Medium->SetAnisotropy(g);
    for (double cosTheta : { 1.0, -1.0 })
    {
      trial.AtMost(std::abs(stage.Measure(cosTheta) / Truth(trial, cosTheta, g) - 1), 1e-3,
        "relative error at g = " + std::to_string(g) + ", cos " + std::to_string(cosTheta));
    }
  }
}

void NearlyIsotropic(Trial& trial)
{
  ThinStage stage(trial);
  for (double g : { 0.0, 1e-8, -9.9e-4, 9.9e-4 })
  {
    stage.Medium->SetAnisotropy(g);
    for (double cosTheta : { -1.0, 0.2, 1.0 })
    {
      trial.AtMost(std::abs(stage.Measure(cosTheta) / Isotropic - 1), 1e-2,
        "relative difference from isotropic at g = " + std::to_string(g));
    }
  }
}
}

std::vector<Row> PhaseRows()
{
  return {
    { 22, "PhaseFunctionIsNowhereNegative",
      "≥ 0, and 1e-3 of the function: float's direction is good to 1e-7, at a peak of width 1e-3",
      EveryAnisotropy, {} },
    { 23, "PhaseFunctionIntegratesToOne", "1e-3", Normalised, {} },
    { 24, "ForwardAndBackwardPeaksAreNotSwapped", "1e-3, as row 22", Peaks, {} },
    { 25, "SmallAnisotropyIsIsotropic", "1e-2: three times the largest |g|", NearlyIsotropic, {} },
  };
}
}
