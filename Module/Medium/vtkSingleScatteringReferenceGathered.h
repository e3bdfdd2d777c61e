// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkSingleScatteringReferenceGathered.h
 * @brief What vtkSingleScatteringReference gathered for the last question, and from which state.
 *
 * Private to the module.
 */
#ifndef vtkSingleScatteringReferenceGathered_h
#define vtkSingleScatteringReferenceGathered_h

#include "vtkMediumReferenceContent.h"
#include "vtkSingleScatteringReference.h"

struct vtkSingleScatteringReference::Gathered
{
  vtkMediumScene Facts;
  vtkMediumReferenceContent Content;
  vtkMTimeType Time = 0;
  bool Lit = false;
};

#endif
