// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumStepControl
 * @brief Finds the longest step that keeps an image within an error.
 *
 * A few probe pixels are integrated at steps that halve, until the error is met (vtkMediumStepSearch). Probes
 * miss the worst pixel of an image, so that more than what they say is held against the error. It is an
 * estimate, never a bound.
 *
 * The error of light caches does not shrink with the step. It is found by marching light rays for a few
 * probes, in steps that halve until they are accurate enough to judge look-ups by. Where look-ups leave too
 * little room, pixels whose look-ups may err by more are integrated anew, with light rays that are marched
 * until the caches are accurate enough, to a tolerance that is lowered until there is room; where no tolerance
 * does that, all light rays are marched to their ends. How much of what they may err by look-ups do err by is
 * seen in the probes, too. A light ray that is marched to its cache has the step that was found for rays
 * marched to their ends: where it stops changes with the step. The errors of steps and caches have nothing to
 * do with each other: their squares are added.
 *
 * No OpenGL: whoever calls it integrates the probes.
 */
#ifndef vtkMediumStepControl_h
#define vtkMediumStepControl_h

#include "vtkMediumPlan.h"
#include "vtkMediumScene.h"
#include "vtkMediumSignature.h"
#include "vtkMediumStepSearch.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <functional>
#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumStepControl
{
public:
  /// How light reaches a sample: see vtkMediumPlan.
  struct Light
  {
    vtkMediumPlan::LightMethods Method = vtkMediumPlan::March;
    double Tolerance = 0; ///< radiance per local unit that look-ups may err by; MarchThenLookUp
    double PixelTolerance = 0; ///< radiance that those of a pixel may err by; MarchThenLookUp
    double Error = 0;          ///< what that causes, as a fraction of the probes' peak radiance
  };

  /// R, G, B, alpha of each probe pixel.
  using Image = vtkMediumStepSearch::Image;

  /// When light comes from the caches; their error is part of the estimate in any case.
  enum CacheUses
  {
    WhereAccurate,
    Always,
    Never,
  };

  /// How the renderer integrates probes.
  struct Probes
  {
    /// Integrates at a step, local units; light rays are marched in the same step.
    std::function<Image(const Light& light, double step)> InSteps;
    /// Integrates fewer pixels in fixed steps of the eye, so that only the way to the light makes a
    /// difference; light rays are marched at a step, local units. Not asked for where Caches is Never.
    std::function<Image(const Light& light, double lightStep)> InLight;
    /// What the look-ups of each of these pixels may err by, of radiance, once InLight has drawn them with
    /// MarchThenLookUp. Not asked for where Caches is Never.
    std::function<std::vector<float>()> Bounds;
    CacheUses Caches = Never;
  };

  /// Whether a calibration holds for this scene and error, whose step is then the current one: the same
  /// content and lights, and an eye that is off by less than a tenth of its distance and less than ten
  /// degrees. Several are remembered, so that two eyes do not take each other's place.
  bool IsCalibrated(const vtkMediumScene& scene, double maximumError, CacheUses caches);

  /// Finds the step; `voxel` is the step of one voxel, local units.
  void Calibrate(
    const vtkMediumScene& scene, double maximumError, double voxel, const Probes& probes);

  /// Forgets what was found, because the probes could not be drawn.
  void Forget();

  /// How light is to be found: the cheapest way whose error leaves room for that of the step.
  const Light& GetLight() const { return this->Lighting; }
  double GetStep() const { return this->Current.Step; }
  /// Of marched light rays.
  double GetLightStep() const { return this->Current.LightStep; }
  /// The estimated error at these steps, of the peak radiance of the probes.
  double GetEstimatedError() const { return this->Current.Error; }
  /// Calibrations since creation.
  int GetCalibrations() const { return this->Calibrations; }

private:
  /// Steps that were found, and the eye that they were found for.
  struct Calibration
  {
    glm::dvec3 Eye{ 0 };
    glm::dvec3 Axis{ 0 }; ///< unit; the normal of the image plane, wherever in it the window is
    double Step = 0;
    double LightStep = 0;
    double Error = 0;
  };

  /// The range of steps, local units.
  struct Range
  {
    double Coarsest, Finest;
  };

  /// Of the error, that look-ups may use up.
  static constexpr double CacheShare = 0.75;
  /// Of the error that light leaves to steps, that those of the eye may use up where those of light have
  /// their own; the squares of both shares add up to 1.
  static constexpr double EyeShare = 0.7;
  /// The worst pixel against the worst probe of the fewer ones in which light is judged.
  static constexpr double LightSafety = 2;

  void FindLight(double maximumError, const Probes& probes);
  void March(double maximumError, const Probes& probes);
  bool AreLookUpsAccurate(double maximumError, const Probes& probes);
  bool FindTolerance(double maximumError, const Probes& probes);
  std::vector<double> FindErrors(const Light& light, const Probes& probes) const;
  static double FindPartOfBounds(
    const std::vector<double>& errors, const std::vector<float>& bounds, double small);
  void FindSteps(double maximumError, const Range& range, const Probes& probes);

  vtkMediumSignature Signature;
  std::vector<Calibration> Found; ///< of this signature, error and use of caches
  double MaximumError = 0;
  CacheUses Caches = Never;
  Light Lighting;
  vtkMediumStepSearch Marched; ///< of light rays, in InLight, for this signature and eye
  Image LookedUp;              ///< the same pixels by plain look-ups
  glm::dmat4 MarchedEye{ 0 };
  Calibration Current;
  int Calibrations = 0;
};

#endif
