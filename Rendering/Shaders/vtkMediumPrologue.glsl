//VTK::System::Dec
// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The first lines of every fragment shader. VTK replaces its two tags by the version and the outputs.
//VTK::Output::Dec
#define real float
