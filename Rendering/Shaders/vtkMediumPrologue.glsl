//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The first lines of every fragment shader. VTK replaces its first two tags
// by the version and the outputs; the others are for a user (vtkMediumUserCode).
//VTK::Output::Dec
#define real float
//VTK::CustomUniforms::Dec
//VTK::Medium::Dec
