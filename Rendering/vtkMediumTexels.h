// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumTexels.h
 * @brief A field as the texels of a 3D texture.
 */
#ifndef vtkMediumTexels_h
#define vtkMediumTexels_h

#include "vtkMediumField.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <vector>

/// The field's values scaled to 0…1 over its range, in double before they become float, so that a
/// large offset costs no precision. Counts the values that were NaN or infinite in `nonFinite`.
VTKPARTICIPATINGMEDIARENDERING_EXPORT std::vector<float> vtkMediumTexels(
  const vtkMediumField& field, vtkTypeInt64& nonFinite);

#endif
