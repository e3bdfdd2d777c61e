// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumReferenceEyeRay.h
 * @brief The eye ray of a pixel.
 *
 * Private to the module. All in local units.
 */
#ifndef vtkMediumReferenceEyeRay_h
#define vtkMediumReferenceEyeRay_h

#include "vtkMediumScene.h"

struct vtkMediumReferenceEyeRay
{
  glm::dvec3 Origin;
  glm::dvec3 Direction; ///< unit
  double Begin;         ///< where the near plane is, or 0
};

/// The ray through the centre of pixel (i, j) of an image of `size` pixels.
vtkMediumReferenceEyeRay vtkMediumReferenceEyeRayOf(
  const vtkMediumScene::View& eye, const int size[2], int i, int j);

#endif
