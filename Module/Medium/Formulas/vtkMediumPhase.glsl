// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Phase functions, normalised to 1 over the sphere. The angle of scattering is given as
// (1 - cosTheta, 1 + cosTheta), where cosTheta is the cosine between the direction in which the light
// travels and the direction towards the eye: (0, 2) is forward scattering, and g > 0 scatters forward.
// Narrow peaks live in the digits that 1 - cosTheta has and cosTheta has not: at g = 0.999 the rounding
// of a float cosine is 12 % of the peak. GLSL and C++ both compile this text; see vtkMediumFormulas.h.

#define PHASE_PI real(3.14159265358979323846)

// |g| and |k| are held below 1: at 1 the functions are a delta and float divides 0 by 0.
#define PHASE_LIMIT real(0.999)

// The angle between two unit vectors, such that it is (0, 2) where they are equal: those from the point
// towards the light and from the eye towards the point. |a -+ b|^2 / 2 is 1 -+ cosTheta without
// cancellation.
vec2 phaseAngle(vec3 towardsLight, vec3 fromEye)
{
  vec3 apart = towardsLight - fromEye;
  vec3 together = towardsLight + fromEye;
  return real(0.5) * vec2(dot(apart, apart), dot(together, together));
}

real phaseCosine(vec2 angle)
{
  return real(0.5) * (angle.y - angle.x);
}

real phaseIsotropic()
{
  return real(0.25) / PHASE_PI;
}

// Henyey and Greenstein (1941): (1 - g^2) / (4 pi (1 + g^2 - 2 g cosTheta)^(3/2)), with the
// denominator written as (1 - |g|)^2 + 2 |g| (1 -+ cosTheta), which does not cancel at the peak.
real phaseHenyeyGreenstein(vec2 angle, real g)
{
  real a = min(abs(g), PHASE_LIMIT);
  real away = g < real(0.0) ? angle.y : angle.x;
  real d = (real(1.0) - a) * (real(1.0) - a) + real(2.0) * a * away;
  return (real(1.0) - a) * (real(1.0) + a) / (real(4.0) * PHASE_PI * d * sqrt(d));
}

// weight parts of a first lobe and 1 - weight parts of a second, as of a forward and a backward
// one.
real phaseDoubleHenyeyGreenstein(vec2 angle, real g, real secondG, real weight)
{
  return weight * phaseHenyeyGreenstein(angle, g) +
    (real(1.0) - weight) * phaseHenyeyGreenstein(angle, secondG);
}

// Rayleigh (1871), for particles much smaller than the wavelength and unpolarised light.
real phaseRayleigh(vec2 angle)
{
  real cosTheta = phaseCosine(angle);
  return real(3.0 / 16.0) / PHASE_PI * (real(1.0) + cosTheta * cosTheta);
}

// Draine (2003), Astrophysical Journal 598, equation 4: Henyey-Greenstein times 1 + alpha
// cosTheta^2, normalised; alpha >= 0. g = 0, alpha = 1 is Rayleigh, alpha = 1 is Cornette and
// Shanks (1992). Its mean cosine is not g unless alpha is 0.
real phaseDraine(vec2 angle, real g, real alpha)
{
  real a = min(abs(g), PHASE_LIMIT);
  real cosTheta = phaseCosine(angle);
  real norm = real(1.0) + alpha * (real(1.0) + real(2.0) * a * a) / real(3.0);
  return phaseHenyeyGreenstein(angle, g) * (real(1.0) + alpha * cosTheta * cosTheta) / norm;
}

// Water droplets of fog and cloud (Jendersie and d'Eon 2023, doi:10.1145/3587421.3595409): weight
// parts of a Draine lobe (g, alpha) and 1 - weight parts of a Henyey-Greenstein lobe (secondG). The
// four parameters follow from the droplet's diameter; vtkParticipatingMedium evaluates that fit.
real phaseDroplets(vec2 angle, real g, real alpha, real secondG, real weight)
{
  return weight * phaseDraine(angle, g, alpha) +
    (real(1.0) - weight) * phaseHenyeyGreenstein(angle, secondG);
}

// Where a table of `size` values at equally spaced cosines -1 to 1 holds an angle: 0 at the first
// value, size - 1 at the last. A linearly filtered texture is sampled at (coordinate + 1/2) / size.
real phaseTableCoordinate(vec2 angle, real size)
{
  return min(real(0.5) * angle.y, real(1.0)) * (size - real(1.0));
}

// The k of Schlick's approximation that comes near to Henyey-Greenstein with mean cosine g (Pharr,
// Jakob and Humphreys, Physically Based Rendering). It exceeds 1 for 0.938 < g < 1 and is held
// there.
real phaseSchlickFromG(real g)
{
  return clamp(real(1.55) * g - real(0.55) * g * g * g, -PHASE_LIMIT, PHASE_LIMIT);
}

// Schlick (Blasi, Le Saec and Schlick 1993): (1 - k^2) / (4 pi (1 - k cosTheta)^2).
real phaseSchlick(vec2 angle, real k)
{
  real a = min(abs(k), PHASE_LIMIT);
  real away = k < real(0.0) ? angle.y : angle.x;
  real d = (real(1.0) - a) + a * away;
  return (real(1.0) - a) * (real(1.0) + a) / (real(4.0) * PHASE_PI * d * d);
}

#ifndef vtkMediumFormulas_h // shaders only
// How a shader calls each function, by its number in vtkParticipatingMedium::PhaseFunctions. phaseLobes
// holds g of the second lobe, the weight of the first, and Draine's alpha.
#define PHASE_0(angle, g) phaseIsotropic()
#define PHASE_1(angle, g) phaseSchlick(angle, phaseSchlickFromG(g))
#define PHASE_2(angle, g) phaseHenyeyGreenstein(angle, g)
#define PHASE_3(angle, g) phaseDoubleHenyeyGreenstein(angle, g, phaseLobes.x, phaseLobes.y)
#define PHASE_4(angle, g) phaseRayleigh(angle)
#define PHASE_5(angle, g) phaseDraine(angle, g, phaseLobes.z)
#define PHASE_6(angle, g) phaseTabulated(angle)
#define PHASE_7(angle, g) phaseDroplets(angle, g, phaseLobes.z, phaseLobes.x, phaseLobes.y)
#define PHASE_8(angle, g) phaseSchlick(angle, g)
#endif
