// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumSettings.h
 * @brief What a user set on the mapper, as a plan reads it.
 */
#ifndef vtkMediumSettings_h
#define vtkMediumSettings_h

#include "vtkMediumPlan.h"

class vtkSingleScatteringVolumeMapper;

vtkMediumPlan::Settings vtkMediumSettingsOf(vtkSingleScatteringVolumeMapper* mapper);

#endif
