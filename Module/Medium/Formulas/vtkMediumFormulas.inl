// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Included twice by vtkMediumFormulas.h, once for each number type.
#include "vtkMediumJitter.glsl"
#include "vtkMediumLight.glsl"
#include "vtkMediumPhase.glsl"
#include "vtkMediumRayBox.glsl"
#include "vtkMediumSegment.glsl"
#include "vtkMediumTransmittance.glsl"
#undef LIGHT_MINIMUM_RADIUS
#undef PHASE_LIMIT
#undef PHASE_PI
#undef RAY_BOX_PARALLEL
