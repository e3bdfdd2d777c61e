// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticipatingMedium.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkParticipatingMedium);

//------------------------------------------------------------------------------
vtkParticipatingMedium::vtkParticipatingMedium() = default;

//------------------------------------------------------------------------------
vtkParticipatingMedium::~vtkParticipatingMedium() = default;

//------------------------------------------------------------------------------
void vtkParticipatingMedium::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
