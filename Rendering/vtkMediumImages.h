// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumImages
 * @brief What users see of an integrated frame: distances in world units, depths, counts.
 */
#ifndef vtkMediumImages_h
#define vtkMediumImages_h

#include "vtkMediumCompatibility.h"
#include "vtkMediumFrame.h"
#include "vtkMediumScene.h"
#include "vtkType.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

class vtkMediumImages
{
public:
  /// How a frame of this output is shown in the window.
  static vtkMediumFrame::Shown FindShown(const vtkMediumScene& scene, int output);

  /// The values of an output as RGBA, in their own units, with alpha 1 where a ray has one: distances
  /// to the first hit count from the eye, in parallel projection from the near plane.
  static std::vector<float> Values(const std::vector<float>& radiance,
    const std::vector<float>& hits, const vtkMediumScene& scene, int output);

  /// The error of a frame of second order, from one of twice its steps, as RGBA with alpha 1 where a ray
  /// met the volume.
  static std::vector<float> Errors(const std::vector<float>& radiance,
    const std::vector<float>& coarser, const std::vector<float>& hits);

  /// The point at t on the eye ray of a pixel, local.
  static glm::dvec3 FindPoint(
    const vtkMediumScene::View& eye, const glm::ivec2& size, const glm::ivec2& pixel, double t);

  /// Window depths, 0 to 1, of the first hits; 1 where there is none.
  static std::vector<float> WindowDepths(
    const std::vector<float>& hits, const vtkMediumScene::View& eye, const glm::ivec2& size);

  /// What the pixels counted, summed.
  struct Counts
  {
    vtkTypeInt64 Taps = 0;
    vtkTypeInt64 Rays = 0;    ///< that met the volume
    vtkTypeInt64 Refined = 0; ///< of those, integrated twice
  };
  static Counts Count(const std::vector<float>& hits);

  /// Copies pixels into a float image of the given size, origin 0 and spacing 1.
  static void Copy(
    const std::vector<float>& pixels, int components, const glm::ivec2& size, vtkImageData* image);
};

#endif
