// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumOpenGL.h
 * @brief OpenGL's functions, from the loader that this VTK has: glad since 9.4, glew before.
 */
#ifndef vtkMediumOpenGL_h
#define vtkMediumOpenGL_h

#if VTK_MODULE_ENABLE_VTK_glad
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
