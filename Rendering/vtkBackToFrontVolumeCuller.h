// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkBackToFrontVolumeCuller
 * @brief Has a renderer draw its volumes back to front; it culls nothing.
 *
 * A vtkRenderer draws its volumes in the order in which they were added to it, wherever the camera is, and
 * each is blended over what is drawn already. So that several volumes show as one scene from every side,
 * add this culler, after those that are there:
 *
 *     renderer->GetCullers()->AddItem(culler);
 *
 * A volume whose bounds cannot hide another's is drawn before it: two boxes, with faces along the world's
 * axes, that a plane along these axes parts are put in the right order from every eye, in perspective and
 * in parallel projection, whatever their sizes. Where bounds overlap, or hide each other in a circle, the
 * volume whose centre is farther is drawn first; where media overlap, no order is right. (The order of
 * vtkFrustumCoverageCuller::SetSortingStyleToBackToFront goes by centres alone, which is wrong where a long
 * volume is beside a short one.) Other props keep their places among each other.
 *
 * @sa vtkSingleScatteringVolumeMapper
 */
#ifndef vtkBackToFrontVolumeCuller_h
#define vtkBackToFrontVolumeCuller_h

#include "vtkCuller.h"
#include "vtkMediumCompatibility.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkBackToFrontVolumeCuller : public vtkCuller
{
public:
  static vtkBackToFrontVolumeCuller* New();
  vtkTypeMacro(vtkBackToFrontVolumeCuller, vtkCuller);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Called by the renderer: orders the volumes of the list for its active camera, and returns the sum of
  /// the props' RenderTimeMultiplier, which are 1 where no culler before set them.
  double Cull(
    vtkRenderer* renderer, vtkProp** props, int& numberOfProps, int& initialized) override;

protected:
  vtkBackToFrontVolumeCuller();
  ~vtkBackToFrontVolumeCuller() override;

private:
  vtkBackToFrontVolumeCuller(const vtkBackToFrontVolumeCuller&) = delete;
  void operator=(const vtkBackToFrontVolumeCuller&) = delete;
};

#endif
