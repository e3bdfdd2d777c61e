// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 47 and 50 to 52: functions with jumps, empty space, early ends, features thinner than a step.
#include "StressRefusal.h"

#include "vtkPiecewiseFunction.h"

namespace vtkMediumStress
{
namespace
{
/// A ramp of 0 to 1 along z, mapped by a property.
struct PropertyStage : Stage
{
  explicit PropertyStage(Trial& trial)
    : Stage(
        trial, MakeImage({ 3, 3, 9 }, glm::dvec3(1), [](const glm::dvec3& p) { return p.z + 0.5; }))
  {
    this->Mapper->SetMedium(nullptr);
    this->Property->SetScalarOpacity(this->Opacity);
    this->White->AddPoint(0, 1);
    this->White->AddPoint(1, 1);
    this->Property->SetColor(this->White);
    this->AddBeam({ 0.3, -1, -0.2 });
    this->Look({ 0.5, 0.4, -1 }, 2);
  }

  vtkNew<vtkPiecewiseFunction> Opacity, White;
};

/// Extinction 3 where the value is above 0.437, none below.
double JumpError(Trial& trial, double step)
{
  PropertyStage stage(trial);
  const double opaque = -std::expm1(-3.0);
  for (const glm::dvec2& node :
    { glm::dvec2(0, 0), { 0.437, 0 }, { 0.437 + 1e-9, opaque }, { 1, opaque } })
  {
    stage.Opacity->AddPoint(node.x, node.y);
  }
  stage.SetSteps(step, 0.05);
  const Picture picture = stage.Render();
  double sum = 0;
  ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
    Box filled({ 1, 1, 1 - 0.437 });
    filled.Origin.z = 0.437 - 0.5;
    const std::array<double, 2> t = filled.Intersect(ray);
    const double d = std::max(t[1] - t[0], 0.0);
    sum += std::abs(picture.At(x, y, 3) + std::expm1(-3 * d)) / (stage.Pixels * stage.Pixels);
  });
  return sum;
}

void Jumps(Trial& trial)
{
  if (trial.Is(Mapper::FixedStep))
  {
    const double coarse = JumpError(trial, 0.2), fine = JumpError(trial, 0.0125);
    trial.Reaches(std::log2(coarse / fine) / 4, 0.9, "order of the mean error over 4 halvings");
  }
  else
  {
    // The function has 1024 intervals or so: the jump is a ramp of 1 / 1024 of the box.
    trial.AtMost(
      JumpError(trial, 0.1), trial.Is(Mapper::Exact) ? 2e-3 : 5e-3, "mean error of alpha");
  }
}

/// Bounded, or refused by one error.
void CheckBounded(Stage& stage, double most, const std::string& what)
{
  stage.Window->Render();
  if (stage.Errors.size() == 1)
  {
    stage.Errors.clear();
    return;
  }
  const Picture picture = stage.Render();
  stage.Cell.AtMost(*std::max_element(picture.Values.begin(), picture.Values.end()), most, what);
}

void OddFunctions(Trial& trial)
{
  const double nan = std::nan("");
  PropertyStage stage(trial);
  stage.Opacity->AddPoint(0, 1);
  stage.Opacity->AddPoint(1, 1);
  CheckBounded(stage, 1, "opacity 1");
  stage.Opacity->AddPoint(0.5, nan);
  CheckBounded(stage, 1, "an opacity of NaN");
  stage.Opacity->RemoveAllPoints();
  CheckBounded(stage, 1, "no opacity at all");
  stage.Opacity->AddPoint(nan, 0.5);
  CheckBounded(stage, 1, "an opacity at the scalar NaN");
  stage.Opacity->RemoveAllPoints();
  stage.Opacity->AddPoint(0.5, 0.9);
  CheckBounded(stage, 1, "a single node");
  stage.Mapper->SetInputData(MakeBox()); // a range of zero
  CheckBounded(stage, 1, "one value only");
  Jumps(trial);
}

/// One voxel in 4913 is filled; the bricks without it are leapt.
void HotVoxel(Trial& trial)
{
  Stage stage(trial,
    MakeImage(glm::ivec3(17), glm::dvec3(1),
      [](const glm::dvec3& p) {
        return glm::length(p - glm::dvec3(0.1875, -0.125, 0.25)) < 1e-6 ? 1.0 : 0.0;
      }),
    24);
  stage.SetField(40);
  stage.AddBeam({ 0.3, -1, -0.2 });
  stage.LookParallel({ 0.2, 0.3, -1 }, 2, 0.5);
  stage.SetSteps(0.003, 0.003);
  const Picture leapt = stage.Render();
  stage.Mapper->SetIntegratorToExact();
  CheckSame(trial, stage.Render(), leapt,
    trial.Is(Mapper::ErrorControlled) ? 4 * ControlledError : 1e-3,
    "against Exact, which leaps nothing");
}

void EarlyEnds(Trial& trial)
{
  Stage stage(trial, MakeBox(), 12);
  stage.AddBeam({ 0.3, -1, -0.2 });
  stage.Look({ 0.3, 0.2, -1 }, 2);
  stage.SetSigma(12);
  stage.SetSteps(0.01, 1);
  const Picture whole = stage.Render();
  // ErrorControlled's step follows from other probes, of its own error.
  const double own = trial.Is(Mapper::ErrorControlled) ? 4 * ControlledError * Isotropic : 1e-7;
  for (double threshold : { 1e-6, 1e-3, 0.03, 0.2 })
  {
    stage.Mapper->SetTransmittanceThreshold(threshold);
    const Picture cut = stage.Render();
    double radiance = 0, alpha = 0;
    for (std::size_t i = 0; i < cut.Values.size(); ++i)
    {
      const double lost = std::abs(double(whole.Values[i]) - cut.Values[i]);
      (i % 4 == 3 ? alpha : radiance) = std::max(i % 4 == 3 ? alpha : radiance, lost);
    }
    trial.AtMost(radiance, threshold * Isotropic + own, "radiance lost");
    trial.AtMost(alpha, threshold + 1e-7, "alpha lost");
  }
}

/// A layer of one lattice plane of 33: a triangle of width 2 / 32 in the density.
void ThinShell(Trial& trial)
{
  Stage stage(trial,
    MakeImage({ 3, 3, 33 }, glm::dvec3(1),
      [](const glm::dvec3& p) { return std::abs(p.z - 0.25) < 1e-6 ? 1.0 : 0.0; }),
    8);
  stage.SetField(20);
  stage.LookParallel({ 0, 0, -1 }, 2, 0.4);
  stage.SetSteps(0.3, 0.3);
  const double truth = -std::expm1(-20.0 / 32), alpha = stage.Render().At(4, 4, 3);
  if (trial.Is(Mapper::FixedStep))
  {
    // Documented: a step sees what its middle sees. Missed, or counted for the whole step.
    trial.Holds(alpha == 0 || alpha > truth, "missed or counted for a step");
    stage.SetSteps(0.001, 0.3);
    trial.AtMost(QError(stage.Render().At(4, 4, 3), truth), 1e-3, "in short steps");
  }
  else
  {
    // ErrorControlled's finest step is 1/16 of a voxel: what it misses of its target it reports.
    const double said = stage.Mapper->GetEstimatedError();
    trial.Is(Mapper::ErrorControlled)
      ? trial.AtMost(std::abs(alpha - truth), said, "found")
      : trial.AtMost(QError(alpha, truth), stage.Allowed(0), "found");
    trial.Holds(said < 1e-3, "its finest step resolves the shell");
  }
}
}

std::vector<Row> FunctionRows()
{
  const std::map<int, const char*> notPaper = { { Mapper::Paper, DrawsHomogeneous } };
  std::map<int, const char*> hot = notPaper;
  hot[Mapper::Exact] = "is what the others are compared with here";
  return {
    { 47, "FunctionsWithJumpsAndBadNodesAreBounded",
      "bounded, or E; FixedStep: order ≥ 0.9; Exact 2e-3, ErrorControlled 5e-3: the function's "
      "table",
      OddFunctions, notPaper },
    { 50, "LeapingEmptySpaceChangesNothing",
      "ErrorControlled, which leaps: its error for each frame; FixedStep 1e-3", HotVoxel, hot },
    { 51, "EarlyEndsLoseAtMostTheirThreshold",
      "threshold × p E; ErrorControlled: and its own error", EarlyEnds, {} },
    { 52, "ThinShellIsFoundOrMissedAsDocumented",
      "Q where found; FixedStep: missed or counted for a whole step, 1e-3 in short ones; "
      "ErrorControlled, whose finest step is 1/16 of a voxel: the error that it reports",
      ThinShell, notPaper },
  };
}
}
