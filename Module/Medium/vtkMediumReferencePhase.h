// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumReferencePhase.h
 * @brief The phase functions in double, written from their definitions.
 *
 * Private to the module. Shares nothing with the shaders' formulas, so that each can be held to the
 * other.
 */
#ifndef vtkMediumReferencePhase_h
#define vtkMediumReferencePhase_h

#include "vtkMediumScene.h"

/// The phase function of the medium, per steradian; it integrates to 1 over the sphere. `cosine` is
/// that between the way the light travels and the way to the eye: 1 is forward scattering.
/// `anisotropy` is the medium's g (or k) at the point.
double vtkMediumReferencePhase(
  const vtkMediumScene::Medium& medium, double anisotropy, double cosine);

#endif
