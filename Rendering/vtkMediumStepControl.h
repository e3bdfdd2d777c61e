// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumStepControl
 * @brief Finds the longest step that keeps an image within an error.
 *
 * A few probe pixels are integrated at steps that halve, until what the last halving changed says that
 * the error is met: with changes d1 and then d2, the order shows in d1 / d2 and the error that is left
 * is about d2 / (d1 / d2 - 1) (Richardson). Probes miss the worst pixel of an image, so that more than
 * that is held against the error. It is an estimate, never a bound.
 *
 * The error of light caches does not shrink with the step. It is found by marching light rays for a few
 * probes. Where it leaves too little room, pixels whose look-ups may err by more are integrated anew, with
 * light rays that are marched until the caches are accurate enough, to a tolerance that is lowered until
 * there is room; where no tolerance does that, all light rays are marched to their ends. A light ray that is
 * marched to its cache has a step of its own: where it stops changes with the step, so it is marched to its
 * end to find that. The errors of steps and caches have nothing to do with each other: their squares are
 * added.
 *
 * No OpenGL: whoever calls it integrates the probes.
 */
#ifndef vtkMediumStepControl_h
#define vtkMediumStepControl_h

#include "vtkMediumPlan.h"
#include "vtkMediumScene.h"
#include "vtkMediumSignature.h"
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
  using Image = std::vector<float>;

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
    /// difference; light rays are marched at a step, 0: a fixed one. Not asked for where Caches is Never.
    std::function<Image(const Light& light, double lightStep)> InLight;
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

  /// The largest difference of two images of the same pixels: of radiance, as a fraction of the second's
  /// peak, or of alpha, whichever is greater.
  static double RelativeDifference(const Image& image, const Image& other);

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

  void FindLight(double maximumError, const Probes& probes);
  void FindSteps(double maximumError, double coarsest, double finest, const Probes& probes);

  vtkMediumSignature Signature;
  std::vector<Calibration> Found; ///< of this signature, error and use of caches
  double MaximumError = 0;
  CacheUses Caches = Never;
  Light Lighting;
  /// InLight with marched light rays, for this signature and eye; empty: not asked for yet.
  Image Marched;
  glm::dmat4 MarchedEye{ 0 };
  double LookUpError = 0; ///< of plain look-ups, where Marched is known
  Calibration Current;
  int Calibrations = 0;
};

#endif
