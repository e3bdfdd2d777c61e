// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumPackedTexels.h
 * @brief A field of integers as the texels of a normalised 16-bit texture: half the bytes of float, exact.
 *
 * Integers whose range is at most 65535 are multiplied by the largest integer factor that keeps them
 * within 16 bits, so that no value is rounded: a texel is (value - minimum) x factor / 65535.
 */
#ifndef vtkMediumPackedTexels_h
#define vtkMediumPackedTexels_h

#include "vtkMediumField.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <cstdint>
#include <vector>

/// The factor for a field; 0 where it cannot be packed: not integers, a range that is too large, or none.
VTKPARTICIPATINGMEDIARENDERING_EXPORT int vtkMediumPackingFactor(const vtkMediumField& field);

/// The texels, component by component, of a field with a factor > 0.
VTKPARTICIPATINGMEDIARENDERING_EXPORT std::vector<std::uint16_t> vtkMediumPackedTexels(
  const vtkMediumField& field);

/// By what a texture's value is multiplied to run from 0 to 1 over the field's range; 1 where the field
/// cannot be packed.
VTKPARTICIPATINGMEDIARENDERING_EXPORT double vtkMediumTexelScale(const vtkMediumField& field);

#endif
