// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumShaderTexts.h
 * @brief The shader files and formulas as they were built into this library, by name.
 */
#ifndef vtkMediumShaderTexts_h
#define vtkMediumShaderTexts_h

#include <string>

/// The text of vtkMedium<name>.glsl, or an empty one if there is no such file.
std::string vtkMediumShaderText(const std::string& name);

#endif
