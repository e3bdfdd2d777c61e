// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StressStage.h
 * @brief The scene of a row: its pictures are sound or the row fails.
 *
 * Every frame is finite and >= 0, with alpha at most 1, and comes without an error of OpenGL or of VTK.
 * No ray ends early and none is jittered, so that what is left is the integrator's own error.
 */
#ifndef StressStage_h
#define StressStage_h

#include "ClosedForms.h"
#include "vtkMediumFixtures.h"

#include "vtkOpenGLRenderWindow.h"

#include "GLWatch.h"
#include "StressTable.h"

namespace vtkMediumStress
{
using namespace vtkMediumTest;

/// ErrorControlled's target, of the peak radiance; it is met by estimate, and a truth may be missed by
/// twice that (the probes see every eighth pixel).
constexpr double ControlledError = 1e-4;

struct Stage : Scene
{
  Trial& Cell;
  GLWatch Watch;

  Stage(Trial& trial, vtkImageData* image, int pixels = 12)
    : Scene(image, pixels)
    , Cell(trial)
  {
    this->Mapper->SetIntegrator(trial.Integrator);
    this->Mapper->SetTransmittanceThreshold(0);
    this->Mapper->SetJitter(0);
    this->Mapper->SetBinarySearchIterations(10);
    this->Mapper->SetMaximumError(ControlledError);
    this->Watch.Start(this->Window);
  }

  ~Stage() { this->Watch.Stop(this->Window); }

  /// The float image of a frame that must be sound.
  Picture Render()
  {
    const Picture picture = this->Scene::Render();
    this->Window->MakeCurrent();
    const std::vector<std::string>& heard = this->Watch.Look();
    this->Cell.Holds(heard.empty(), "no OpenGL error, but: " + (heard.empty() ? "" : heard[0]));
    this->Cell.Holds(this->Errors.empty(),
      "no error event, but: " + (this->Errors.empty() ? "" : this->Errors[0]));
    this->Cell.Holds(picture.IsLight(), "finite, >= 0, alpha <= 1");
    return picture;
  }

  /// Density 1 becomes this extinction, in every integrator.
  void SetSigma(double sigma) { this->Medium->SetExtinction(sigma); }

  /// The field times `scale` is the extinction.
  void SetField(double scale)
  {
    this->Medium->SetExtinctionArrayName("");
    this->Medium->SetExtinctionScale(scale);
  }

  /// Steps that hold FixedStep within Q of a medium of extinction sigma: its error is (2 sigma h)^2 / 24,
  /// and (sigma h)^2 / 4 p where the light path has a kink. In a homogeneous convex box one step of the
  /// light ray is as good as many.
  void SetFineSteps(double sigma) { this->SetSteps(std::min(0.01 / sigma, 0.005), 0.3); }

  /// What Q is in this integrator, in a medium of extinction sigma with SetFineSteps. Paper's left
  /// Riemann sum errs by sigma (1 + kappa) h / 2; kappa, by which the light's path grows per unit of the
  /// eye's, is at most 1.5 in these views.
  double Allowed(double sigma) const
  {
    const double step = std::max(this->Mapper->GetSampleDistance(), 1e-5);
    return this->Cell.Is(vtkMediumStress::Mapper::Paper)        ? 1e-4 + 1.25 * sigma * step
      : this->Cell.Is(vtkMediumStress::Mapper::ErrorControlled) ? 1e-4 + 2 * ControlledError
                                                                : 1e-4;
  }
};

/// Q's measure: an absolute error of 1e-6 counts as much as a relative one of 1e-4.
inline double QError(double value, double truth)
{
  return std::abs(value - truth) / (std::abs(truth) + 0.01);
}

/// ErrorControlled answers for errors of the frame's peak, the others for each pixel's.
inline double QError(const Trial& trial, double value, double truth, double peak)
{
  return trial.Is(Mapper::ErrorControlled) ? std::abs(value - truth) / std::max(peak, 0.01)
                                           : QError(value, truth);
}

/// The box as it is seen, against truth A: radiance and alpha of every pixel.
struct TruthA
{
  glm::dvec3 ToLight;
  double Sigma = 1;
  Box Shape{ glm::dvec3(1) };

  double Radiance(const Ray& ray) const
  {
    return Isotropic * BoxRadiance(this->Shape, ray, this->ToLight, this->Sigma);
  }
  double Alpha(const Ray& ray) const
  {
    const std::array<double, 2> t = this->Shape.Intersect(ray);
    return -std::expm1(-this->Sigma * std::max(t[1] - t[0], 0.0));
  }

  /// Renders and compares; `factor` widens the allowance.
  void Check(Stage& stage, const std::string& what, double factor = 1) const
  {
    const Picture picture = stage.Render();
    double peak = 0, radiance = 0, alpha = 0;
    ForEachPixel(
      stage, [&](int, int, const Ray& ray) { peak = std::max(peak, this->Radiance(ray)); });
    int hits = 0;
    ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
      hits += this->Alpha(ray) > 0;
      radiance =
        std::max(radiance, QError(stage.Cell, picture.At(x, y), this->Radiance(ray), peak));
      alpha = std::max(alpha, QError(picture.At(x, y, 3), this->Alpha(ray)));
    });
    stage.Cell.Holds(hits * 20 > stage.Pixels * stage.Pixels, what + ": the view shows the box");
    stage.Cell.AtMost(radiance, factor * stage.Allowed(this->Sigma), what + ", radiance");
    stage.Cell.AtMost(alpha, factor * 1e-4, what + ", alpha");
  }
};

/// The law: two pictures are the same but for `allowed` of the first one's largest value.
inline void CheckSame(
  Trial& trial, const Picture& a, const Picture& b, double allowed, const std::string& what)
{
  trial.Holds(a.Mean(3) > 0, what + ": there is something to see");
  trial.AtMost(Difference(a, b), allowed, what);
}

/// S: float's rounding, in the same renderer.
constexpr double Same = 2e-4;
}

#endif
