// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 1 to 7: optical depths from 1e-8 to 1e30, and steps from one to 1e5.
#include "StressStage.h"

namespace vtkMediumStress
{
namespace
{
const glm::dvec3 Oblique = glm::normalize(glm::dvec3(0.3, -0.8, -0.4));

void ThinRadiance(Trial& trial)
{
  Stage stage(trial, MakeBox());
  stage.AddBeam({ 0, -1, 0 });
  stage.LookParallel({ 0, 0, -1 }, 2, 0.45);
  for (double tau : { 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3 })
  {
    stage.SetSigma(tau);
    stage.SetFineSteps(1);
    const Picture picture = stage.Render();
    double worst = 0;
    ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
      const double truth = Isotropic * BoxRadiance(Box(glm::dvec3(1)), ray, { 0, 1, 0 }, tau);
      worst = std::max(worst, std::abs(picture.At(x, y) / truth - 1));
    });
    trial.AtMost(worst, trial.Is(Mapper::ErrorControlled) ? 3e-4 : 1e-4,
      "relative error at optical depth " + std::to_string(tau));
  }
}

void ThickRadiance(Trial& trial)
{
  Stage stage(trial, MakeBox());
  stage.AddBeam(Oblique);
  stage.Look({ 0.2, 0.1, -1 }, 2);
  for (double tau : { 1.0, 5.0, 20.0, 80.0 })
  {
    stage.SetSigma(tau);
    stage.SetFineSteps(tau);
    TruthA{ -Oblique, tau }.Check(stage, "optical depth " + std::to_string(tau));
  }
}

/// The light comes from the camera, so that the limit of an infinite depth is p E / 2. Steps much longer
/// than a free path see nothing of it; they may not see more.
void OpaqueRadiance(Trial& trial)
{
  const bool resolves =
    trial.Is(Mapper::Exact) || trial.Is(Mapper::ErrorControlled); // in closed form
  for (double tau : { 88.0, 104.0, 1e6, 1e30 })
  {
    Stage stage(trial, MakeBox(), 4);
    stage.AddBeam({ 0, 0, -1 });
    stage.LookParallel({ 0, 0, -1 }, 2, 0.4);
    stage.SetSigma(tau);
    stage.SetFineSteps(std::min(tau, 1000.0));
    const Picture picture = stage.Render();
    const double limit = Isotropic / 2;
    const std::string what = "optical depth " + std::to_string(tau);
    trial.Holds(picture.At(2, 2, 3) == 1, what + ", alpha is 1");
    if (tau < 1000 || resolves)
    {
      trial.AtMost(QError(trial, picture.At(2, 2), limit, limit), stage.Allowed(tau), what);
    }
    // Paper's left Riemann sum counts its first sample for a whole step: a diagonal times 1e-5 at least.
    const double step = std::max(stage.Mapper->GetSampleDistance(), 1e-5 * std::sqrt(3.0));
    const double most = trial.Is(Mapper::Paper) && tau > 1000 ? Isotropic * tau * step : limit;
    trial.AtMost(picture.At(2, 2), most * (1 + stage.Allowed(std::min(tau, 1000.0))),
      what + ", at most the limit");
  }
}

/// A glowing medium's limit is emission / extinction, whatever the step.
void OpaqueEmission(Trial& trial)
{
  for (double tau : { 1e-3, 1.0, 88.0, 104.0, 1e6, 1e30 })
  {
    Stage stage(trial, MakeBox(), 4);
    stage.LookParallel({ 0, 0, -1 }, 2, 0.4);
    stage.SetSigma(tau);
    stage.Medium->SetEmission(0.5 * tau);
    const Picture picture = stage.Render();
    trial.AtMost(QError(picture.At(2, 2), -0.5 * std::expm1(-tau)), 1e-4,
      "optical depth " + std::to_string(tau));
  }
}

/// An alpha cannot tell 1e-9 from 1e-35; the transmittance itself can. It is held at exp(-80), so that
/// products of it stay normal numbers.
void OpaqueTransmittance(Trial& trial)
{
  Stage stage(trial, MakeBox(), 4);
  stage.LookParallel({ 0, 0, -1 }, 2, 0.4);
  stage.Mapper->SetOutputToTransmittance();
  for (double tau : { 88.0, 104.0, 1e6, 1e30 })
  {
    stage.SetSigma(tau);
    trial.AtMost(
      stage.Render().At(2, 2), 2e-35, "transmittance of optical depth " + std::to_string(tau));
  }
}

void OpaqueLimits(Trial& trial)
{
  OpaqueRadiance(trial);
  if (!trial.Is(Mapper::Paper)) // which has no emission and no such output
  {
    OpaqueEmission(trial);
    OpaqueTransmittance(trial);
  }
}

void NothingAndPureAbsorption(Trial& trial)
{
  Stage stage(trial, MakeBox());
  stage.AddBeam({ 0, 0, -1 });
  stage.Look({ 0.2, 0.1, -1 }, 2);
  stage.Medium->SetAlbedo(0);
  const Picture absorbing = stage.Render();
  double worst = 0;
  ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
    const TruthA truth{ { 0, 0, 1 }, 1 };
    worst = std::max(worst, QError(absorbing.At(x, y, 3), truth.Alpha(ray)));
    trial.Holds(absorbing.At(x, y) == 0, "pure absorption is black");
  });
  trial.AtMost(worst, 1e-4, "alpha of pure absorption");
  stage.Medium->SetAlbedo(1);
  stage.SetSigma(0);
  for (float value : stage.Render().Values)
  {
    trial.Holds(value == 0, "no medium is transparent, to the bit");
  }
}

/// One segment's (1 - exp(-x)) / x on both sides of where its series ends. In Paper the same light is a
/// Riemann sum without that formula.
void SwitchOfTheSeries(Trial& trial)
{
  Stage stage(trial, MakeBox(), 4);
  stage.LookParallel({ 0, 0, -1 }, 2, 0.4);
  stage.SetSteps(2, 2);
  std::vector<double> values, errors;
  for (int i = 0; i <= 40; ++i)
  {
    const double x = 0.166 * (0.8 + 0.01 * i);
    stage.SetSigma(x);
    stage.Medium->SetEmission(1);
    values.push_back(stage.Render().At(2, 2));
    errors.push_back(values.back() - MeanTransmittance(x));
    trial.AtMost(std::abs(errors.back() / MeanTransmittance(x)), 1e-6,
      "relative error at x = " + std::to_string(x));
  }
  for (std::size_t i = 2; i < values.size(); ++i)
  {
    trial.Holds(values[i] < values[i - 1], "falls with x");
    trial.AtMost(std::abs(errors[i] - 2 * errors[i - 1] + errors[i - 2]), 1e-6,
      "second difference, but for the formula's own");
  }
}

void LightAlongTheView(Trial& trial)
{
  // The light travels with the view, turned by so little that kappa is -1 +- 1e-7 and the light path
  // still ends at the same face.
  Stage stage(trial, MakeBox({ 4, 4, 1 }));
  stage.LookParallel({ 0, 0, -1 }, 2, 0.4);
  for (double kappa : { -1.0, -1 + 1e-7, -1 - 1e-7 })
  {
    // Light towards the eye has a path that grows by 1 / cos a per unit: kappa = 1 / cos a there, so
    // the turn is of the order of 5e-4.
    const double turn = std::sqrt(2 * std::abs(kappa + 1)) * (kappa < -1 ? -1 : 1);
    const glm::dvec3 beam = glm::normalize(glm::dvec3(std::sin(turn), 0, std::cos(turn)));
    vtkSmartPointer<vtkLight> light = stage.AddBeam(beam);
    for (double sigma : { 1e-3, 3.0 })
    {
      stage.SetSigma(sigma);
      stage.SetFineSteps(sigma);
      TruthA{ -beam, sigma, Box({ 4, 4, 1 }) }.Check(stage, "kappa " + std::to_string(kappa));
    }
    stage.Renderer->RemoveLight(light);
  }
}

void ManySteps(Trial& trial)
{
  Stage stage(trial, MakeBox(), 2);
  stage.AddBeam(Oblique);
  stage.LookParallel({ -1, -1, -1 }, 3, 0.002);
  stage.SetSigma(1);
  for (double steps : { 1e4, 1e5 })
  {
    stage.SetSteps(std::sqrt(3.0) / steps, 2);
    TruthA{ -Oblique, 1 }.Check(stage, std::to_string(steps) + " steps");
  }
}
}

std::vector<Row> OpticalDepthRows()
{
  const char* noEmission = "has no emission and no closed form of a segment";
  return {
    { 1, "ThinRadianceIsProportionalToThickness",
      "1e-4 relative (Q without its absolute part, which would hide all of it); ErrorControlled "
      "3e-4",
      ThinRadiance, {} },
    { 2, "RadianceIsTruthA",
      "Q; Paper: its left Riemann sum errs by σh; ErrorControlled: 1e-4 of the peak, found by "
      "probes",
      ThickRadiance, {} },
    { 3, "OpaqueMediaReachTheirLimit",
      "T ≤ 2e-35, exp(-80); Q where a step resolves a free path, else at most the limit p E / 2",
      OpaqueLimits, {} },
    { 4, "NoMediumIsTransparentAndNoAlbedoBlack", "bitwise; Q", NothingAndPureAbsorption, {} },
    { 5, "SeriesAndQuotientMeetSmoothly",
      "1e-6: float's rounding of a difference of two exponentials", SwitchOfTheSeries,
      { { Mapper::Paper, noEmission }, { Mapper::ErrorControlled, ChoosesSteps } } },
    { 6, "LightAlongTheViewIsTruthA", "as row 2", LightAlongTheView, {} },
    { 7, "HundredThousandStepsAreTruthA", "as row 2", ManySteps,
      { { Mapper::ErrorControlled, ChoosesSteps }, { Mapper::Exact, ChoosesSteps } } },
  };
}
}
