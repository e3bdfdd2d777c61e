// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Beer's law. GLSL and C++ both compile this text; see vtkMediumFormulas.h.

// T = exp(-tau). Beyond an optical depth of 80 the result (2e-35) is held, so that products of it
// stay normal numbers in float.
real transmittance(real tau)
{
  return exp(-min(tau, real(80.0)));
}

vec3 transmittance(vec3 tau)
{
  return exp(-min(tau, vec3(80.0)));
}
