// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What arrives of a positional light, before the medium weakens it. Lengths are local units, in
// which the volume's diagonal is 1. GLSL and C++ both compile this text; see vtkMediumFormulas.h.

// Nearer to a light than this, its attenuation stays what it is there, so that an inverse square
// stays finite. Of the power scattered within a distance R of the light this loses 2/3 x 1e-4 / R.
#define LIGHT_MINIMUM_RADIUS real(1.0e-4)

// 1 / (a + b r + c r^2), VTK's attenuation values; (0, 0, 1) is the inverse square. The sum is held
// above zero: coefficients that make it vanish are refused before they come here.
real lightAttenuation(real r, vec3 abc)
{
  real s = max(r, LIGHT_MINIMUM_RADIUS);
  return real(1.0) / max(abc.x + s * (abc.y + s * abc.z), real(1.0e-30));
}

// A segment of the eye ray as a positional light sees it: the mean of 1 / (r^2 + softening) over it, and
// where its mean place is, weighted by that, from its middle along the ray. `offset` is from the middle to
// the light. With D the light's distance from the ray, the integral is the angle under which the light sees
// the segment over D (the equi-angular substitution of Kulla and Fajardo 2012,
// doi:10.1111/j.1467-8659.2012.03148.x), the first moment a logarithm. D is held at the minimum radius.
vec2 lightSegment(vec3 offset, vec3 direction, real width, real softening)
{
  real along = dot(offset, direction);
  vec3 across = offset - along * direction;
  real square = max(
    dot(across, across) + softening, LIGHT_MINIMUM_RADIUS * LIGHT_MINIMUM_RADIUS);
  real apart = sqrt(square);
  real reach = real(0.5) * width;
  real angle = atan(width * apart, square + along * along - reach * reach);
  real before = square + (along + reach) * (along + reach);
  real behind = square + (along - reach) * (along - reach);
  real place = along + real(0.5) * apart * log(behind / before) / angle;
  return vec2(angle / (width * apart), clamp(place, -reach, reach));
}

// cos^exponent inside the cone, 0 outside. cosAngle is the cosine between the light's axis and the
// way to the point. pow(0, 0) and pow of a negative number are undefined in GLSL, and branched
// around.
real lightSpot(real cosAngle, real cosCone, real exponent)
{
  if (cosAngle < cosCone)
  {
    return real(0.0);
  }
  if (exponent == real(0.0))
  {
    return real(1.0);
  }
  return cosAngle > real(0.0) ? pow(min(cosAngle, real(1.0)), exponent) : real(0.0);
}

// offset / |offset|, or the fallback where the offset has no direction.
vec3 lightDirection(vec3 offset, vec3 fallback)
{
  real square = dot(offset, offset);
  return square > real(1.0e-30) ? offset / sqrt(square) : fallback;
}
