// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumRange.h
 * @brief Whether doubles hold what is added up along a ray.
 *
 * Private to the module.
 */
#ifndef vtkMediumRange_h
#define vtkMediumRange_h

#include "vtkMediumScene.h"

///@{
/// "" or which of a scene's optical depth, emission or scattered light may be more than a double can say,
/// by their largest values over the volume's diagonal; the last needs the lights, and is asked by the
/// reference, which follows a light to its place.
std::string vtkMediumCheckRange(const vtkMediumScene& scene);
std::string vtkMediumCheckRangeOfLights(const vtkMediumScene& scene);
///@}

#endif
