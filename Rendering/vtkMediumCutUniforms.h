// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumCutUniforms.h
 * @brief The numbers of clipping planes and cropping, as shaders read them.
 *
 * Private to the module.
 */
#ifndef vtkMediumCutUniforms_h
#define vtkMediumCutUniforms_h

#include "vtkMediumCompatibility.h"
#include "vtkMediumCut.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

/// Sets those that the program has: nothing where nothing is cut.
void vtkMediumSetCutUniforms(vtkShaderProgram* program, const vtkMediumCut& cut);

#endif
