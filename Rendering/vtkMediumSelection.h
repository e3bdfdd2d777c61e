// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumSelection
 * @brief Shows a vtkHardwareSelector where the medium is, in the selector's colours.
 *
 * A pixel belongs to the medium where more than Threshold of the light from behind is lost, which is
 * what VTK's own volume mapper asks for. There the passes of the selector get what they expect: the
 * colour of the prop, of the composite index or of the process, or the number of the voxel where the
 * threshold is crossed, with the window depth of that place. Private to the module.
 */
#ifndef vtkMediumSelection_h
#define vtkMediumSelection_h

#include "vtkMediumCompatibility.h"
#include "vtkMediumFrame.h"
#include "vtkMediumPlan.h"
#include "vtkMediumProgram.h"
#include "vtkMediumScene.h"
#include "vtkType.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkHardwareSelector;
class vtkOpenGLRenderWindow;
VTK_ABI_NAMESPACE_END

class vtkMediumSelection
{
public:
  /// 1 - mean transmittance beyond which the medium is hit.
  static constexpr double Threshold = 3.0 / 255;

  /// The settings of the frame that a selection is made from: transmittance and the place where it
  /// falls to the threshold; with Paper, which bounds its medium, the place of the first hit.
  static vtkMediumPlan::Settings FindSettings(const vtkMediumPlan::Settings& shown);

  /// Draws the current pass of the selector from an integrated frame. `points` are the image's numbers
  /// of points along its axes. Returns an empty string, or what the device could not do.
  static std::string Draw(vtkOpenGLRenderWindow* window, vtkMediumProgram& programs,
    vtkMediumFrame& frame, const vtkMediumScene& scene, const glm::ivec3& points,
    vtkHardwareSelector* selector);

private:
  using Texels = std::vector<float>; ///< R, G, B and window depth of each pixel; depth < 0: no hit

  static Texels FindTexels(vtkMediumFrame& frame, const vtkMediumScene& scene,
    const glm::ivec3& points, vtkHardwareSelector* selector);
  static vtkTypeInt64 FindNumber(const glm::dvec3& box, const glm::ivec3& points, bool ofCell);
  static std::string Show(vtkOpenGLRenderWindow* window, vtkMediumProgram& programs,
    const glm::ivec2& size, Texels& texels);
};

#endif
