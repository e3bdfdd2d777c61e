// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumFrameBudget
 * @brief What a frame gives up to be done in the time that the window has for it.
 *
 * A render window that is being interacted with wants frames at a rate, and hands each volume its share
 * of the time (vtkProp::GetAllocatedRenderTime); one at rest has all the time there is. In a hurry,
 * nothing is calibrated, light comes from the caches alone, those of lights that moved have half the points
 * along each axis, steps are up to twice as long and pixels up to eight times as wide: just as much of it as
 * the last frames say is needed. Scattering stays on.
 *
 * The time of a frame is taken to be proportional to its samples. Estimates follow what was measured
 * slowly upwards and at once downwards, so that one slow frame (a compile, another program) does not
 * make the next ones coarse.
 */
#ifndef vtkMediumFrameBudget_h
#define vtkMediumFrameBudget_h

#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumFrameBudget
{
public:
  /// What a frame gives up; the defaults: nothing.
  struct Economy
  {
    bool Hurried = false;
    double StepFactor = 1; ///< by which steps are longer, 1 to LongestStep
    int PixelEdge = 1;     ///< pixels that share a ray, along each axis, 1 to WidestPixel
  };

  static constexpr double LongestStep = 2;
  static constexpr int WidestPixel = 8;
  /// A window that has more time than this, in seconds, for a frame is at rest.
  static constexpr double AtRest = 1;

  /// For a frame that may take `seconds`, with `pixels` pixels in view, of which building caches has spent
  /// some; a quarter of the time is always left to the rays.
  Economy Plan(double seconds, double pixels, double spent = 0) const;

  /// What a hurried frame took, to learn from.
  void Learn(const Economy& economy, double pixels, double seconds);

  /// Seconds a pixel at full quality, as far as is known; 0: nothing is.
  double GetSecondsPerPixel() const { return this->SecondsPerPixel; }

private:
  double SecondsPerPixel = 0;
};

#endif
