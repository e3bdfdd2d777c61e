// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumTargetClones.h
 * @brief A mark for the few loops that gain from wide vectors, compiled for several processors.
 *
 * GCC from 12 on picks the version when the library is loaded (needs glibc's indirect functions), by what the
 * processor can do: a version for a named processor would pass over those of other makers. Elsewhere the
 * mark is empty and the loop is what the compiler's own flags make of it. Results differ by rounding.
 */
#ifndef vtkMediumTargetClones_h
#define vtkMediumTargetClones_h

#if defined(__GNUC__) && __GNUC__ >= 12 && !defined(__clang__) && defined(__x86_64__) &&           \
  defined(__gnu_linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define VTK_MEDIUM_TARGET_CLONES                                                                   \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define VTK_MEDIUM_TARGET_CLONES
#endif

#endif
