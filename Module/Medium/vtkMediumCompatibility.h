// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumCompatibility.h
 * @brief What differs between VTK 9.1 and the newest VTK, in one place.
 *
 * VTK 9.2 wraps its classes in an inline namespace, so forward declarations of VTK classes belong
 * inside it; VTK 9.1 has no such namespace.
 */
#ifndef vtkMediumCompatibility_h
#define vtkMediumCompatibility_h

#include "vtkVersionMacros.h"
#if VTK_MAJOR_VERSION > 9 || VTK_MINOR_VERSION >= 2
#include "vtkABINamespace.h"
#endif

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#endif
