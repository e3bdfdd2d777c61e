// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 8 to 13 and 61: the order of the steps, their ends, and fields that vary along the ray.
#include "StressStage.h"

#include <numeric>

namespace vtkMediumStress
{
namespace
{
double Order(double coarse, double fine)
{
  return std::log2(coarse / fine);
}

void HalvedSteps(Trial& trial)
{
  Stage stage(trial, MakeBox(), 4);
  stage.AddBeam({ 0, 0, -1 });
  stage.LookParallel({ 0, 0, -1 }, 2, 0.3);
  stage.SetSigma(4);
  const double truth = Isotropic * 4 * MeanTransmittance(8);
  double before = 0;
  for (double step : { 0.125, 0.0625, 0.03125, 0.015625 })
  {
    stage.SetSteps(step, step);
    const double error = std::abs(stage.Render().At(2, 2) - truth);
    if (before > 0)
    {
      // Paper's sums err by 1 + x/2 + ..., whose higher orders still show at x = 1.
      trial.Reaches(Order(before, error), trial.Is(Mapper::Paper) ? 0.9 : 1.8,
        "order at step " + std::to_string(step));
    }
    before = error;
  }
}

/// 64 x 64 pixels see the same ray with an entry each of the jitter's table. A jitter below one step in
/// a left Riemann sum moves its sample from the step's begin to anywhere in it.
void Jittered(Trial& trial)
{
  Stage stage(trial, MakeBox(), 64);
  stage.AddBeam({ 0, -1, 0 });
  stage.LookParallel({ 0, 0, -1 }, 2, 1e-4);
  stage.SetSigma(2);
  stage.Mapper->SetJitter(0.999999);
  const double truth = Isotropic * 2 * std::exp(-1.0) * MeanTransmittance(2);
  double before = 0;
  for (double step : { 0.125, 0.0625 })
  {
    stage.SetSteps(step, 2);
    const Picture picture = stage.Render();
    double square = 0;
    for (int i = 0; i < 64 * 64; ++i)
    {
      square += std::pow(picture.At(i % 64, i / 64) - truth, 2);
    }
    const double rms = std::sqrt(square / 4096);
    trial.AtMost(std::abs(picture.Mean() - truth), 3 * rms / 64,
      "bias of the mean, three of its standard deviations");
    trial.Holds(before == 0 || Order(before, rms) > 0.7,
      "one number moves all samples of a ray: RMS order 1, not 1.5");
    before = rms;
  }
}

void LongStep(Trial& trial)
{
  Stage stage(trial, MakeBox(), 4);
  stage.AddBeam({ 0, 0, -1 });
  stage.LookParallel({ 0, 0, -1 }, 2, 0.3);
  stage.SetSigma(2);
  const bool paper = trial.Is(Mapper::Paper);
  // One sample: at the middle, in a closed form; in Paper at the beginning, where nothing weakens it.
  const double truth = Isotropic * 2 * (paper ? 1 : std::exp(-1.0) * MeanTransmittance(2));
  for (double step : { 1.5, 1e3, 1e30, 1e300 })
  {
    stage.SetSteps(step, step);
    trial.AtMost(std::abs(stage.Render().At(2, 2) / truth - 1), 1e-5,
      "relative error of the one sample at step " + std::to_string(step));
  }
}

/// Ramp of the density along z, 0.1 to 1 from the far face to the near one.
double Ramp(const glm::dvec3& p)
{
  return 0.55 + 0.9 * p.z;
}

/// Truth E: tau = a s + b s^2 / 2, whole or to the middle of a step.
void RampDepth(Trial& trial, double step, int type, double allowed)
{
  const double scale = type == VTK_FLOAT ? 3 : 3.0 / 200;
  const double one = type == VTK_FLOAT ? 1 : 200;
  Stage stage(trial,
    MakeImage(
      { 5, 5, 10 }, glm::dvec3(1), [&](const glm::dvec3& p) { return one * Ramp(p); }, false, type),
    8);
  stage.LookParallel({ 0, 0, -1 }, 2, 0.4);
  stage.SetField(scale);
  stage.SetSteps(step, step);
  const double tau = 3 * 0.55;
  trial.AtMost(QError(stage.Render().At(3, 3, 3), -std::expm1(-tau)), allowed, "alpha of the ramp");
  // From the side each ray has a constant density.
  stage.LookParallel({ -1, 0, 0 }, 2, 0.4);
  const Picture picture = stage.Render();
  ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
    trial.AtMost(QError(picture.At(x, y, 3), -std::expm1(-3 * Ramp(ray.Origin))), allowed,
      "alpha across the ramp");
  });
}

void FractionalEnd(Trial& trial)
{
  if (trial.Is(Mapper::Paper)) // a homogeneous medium
  {
    Stage stage(trial, MakeBox(), 4);
    stage.AddBeam({ 0, -1, 0 });
    stage.LookParallel({ 0, 0, -1 }, 2, 0.3);
    stage.SetSigma(0.5);
    stage.SetSteps(1 / 7.3, 2);
    trial.AtMost(QError(stage.Render().At(2, 2, 3), -std::expm1(-0.5)), 1e-4, "alpha of 7.3 steps");
    return;
  }
  RampDepth(trial, 1 / 7.3, VTK_FLOAT, 1e-4);
}

void RampTypes(Trial& trial)
{
  RampDepth(trial, 0.05, VTK_FLOAT, 1e-4);
  // Rounded to 1/200 of the top: the medium itself is another by half of that, 3 / 400 of a depth.
  RampDepth(trial, 0.05, VTK_UNSIGNED_CHAR, 3.0 / 400);
}

void Atmosphere(Trial& trial)
{
  const double height = 0.2;
  Stage stage(trial,
    MakeImage({ 3, 3, 65 }, glm::dvec3(1),
      [&](const glm::dvec3& p) { return std::exp(-(p.z + 0.5) / height); }),
    8);
  stage.SetField(4);
  stage.SetSteps(0.004, 0.1);
  for (const glm::dvec3& view : { glm::dvec3(-1, 0, 0), { -1, 0, -0.05 }, { 0, 0, -1 } })
  {
    stage.LookParallel(view, 2, 0.3);
    const Picture picture = stage.Render();
    ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
      const std::array<double, 2> t = Box(glm::dvec3(1)).Intersect(ray);
      const double s = std::max(t[1] - t[0], 0.0), climb = ray.Direction.z / height;
      const double z0 = (ray.Origin + t[0] * ray.Direction).z + 0.5;
      const double tau = 4 * std::exp(-z0 / height) * s *
        (std::abs(s * climb) < 1e-9 ? 1 : -std::expm1(-s * climb) / (s * climb));
      trial.AtMost(QError(picture.At(x, y, 3), -std::expm1(-tau)), 1e-3, "alpha of the atmosphere");
    });
  }
}

void MillionSamples(Trial& trial)
{
  const glm::dvec3 toLight = glm::normalize(glm::dvec3(1, 1, 0.9));
  Stage stage(trial, MakeBox(), 2);
  stage.AddBeam(-toLight);
  stage.LookParallel({ -1, -1, -1 }, 3, 0.002);
  if (!trial.Is(Mapper::Paper)) // of a constant extinction, light rays are not marched elsewhere
  {
    stage.SetField(1);
  }
  stage.SetSteps(std::sqrt(3.0) / 1000, std::sqrt(3.0) / 1000);
  TruthA{ toLight, 1 }.Check(stage, "1000 x 1000 steps");
  if (trial.Is(Mapper::Paper) || trial.Is(Mapper::FixedStep))
  {
    trial.Reaches(stage.Mapper->GetStatistics()->GetPasses(), 2, "draws of the frame");
  }
}
}

std::vector<Row> MarchRows()
{
  const std::map<int, const char*> ownSteps = { { Mapper::ErrorControlled, ChoosesSteps },
    { Mapper::Exact, ChoosesSteps } };
  std::map<int, const char*> onlyPaper = ownSteps;
  onlyPaper[Mapper::FixedStep] = onlyPaper[Mapper::ErrorControlled] = onlyPaper[Mapper::Exact] =
    "has no jitter: its samples are at the middles of equal steps or cells";
  const std::map<int, const char*> notPaper = { { Mapper::Paper, DrawsHomogeneous } };
  return {
    { 8, "ErrorFallsWithTheOrderOfTheMethod", "order ≥ 1.8; Paper, a left Riemann sum: ≥ 0.9",
      HalvedSteps, ownSteps },
    { 9, "JitterKeepsTheMean", "three standard deviations of the mean of 4096 pixels", Jittered,
      onlyPaper },
    { 10, "StepBeyondTheBoxIsOneSample", "1e-5: float's rounding of one sample", LongStep,
      ownSteps },
    { 11, "FractionOfAStepAtTheEndCounts", "Q: midpoints are exact on a ramp", FractionalEnd, {} },
    { 12, "RampIsTruthE", "Q; 8 bits: half a level of the data", RampTypes, notPaper },
    { 13, "AtmosphereIsTruthD",
      "1e-3: linear interpolation of the exponential at 65 points is off by (h/H)²/12 = 5e-4",
      Atmosphere, notPaper },
    { 61, "MillionSamplesOfAPixelArrive", "as row 2", MillionSamples, {} },
  };
}
}
