// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumReferenceRange.h
 * @brief Whether doubles hold what the reference adds up along a ray.
 *
 * Private to the module.
 */
#ifndef vtkMediumReferenceRange_h
#define vtkMediumReferenceRange_h

#include "vtkMediumScene.h"

///@{
/// "" or which of a scene's optical depth, emission or scattered light may be more than a double can say,
/// by their largest values over the volume's diagonal; the last needs the lights.
std::string vtkMediumCheckRange(const vtkMediumScene& scene);
std::string vtkMediumCheckRangeOfLights(const vtkMediumScene& scene);
///@}

#endif
