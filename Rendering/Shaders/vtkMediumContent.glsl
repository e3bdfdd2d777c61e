// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The medium's coefficients at a point. EXTINCTION, SCATTERING, EMISSION and ANISOTROPY are expressions
// that vtkMediumStructure writes from the scene; each is a scale, a field or a function of a field.
// Coefficients are per local unit.

uniform vec3 extinctionScale, scatteringScale, emissionScale, anisotropyScale;

#if FUNCTION_COUNT > 0
uniform sampler2D functions; // one row a function
uniform vec2 functionScale;  // field texel to texture coordinate: scale and bias

#define functionValue(number, texel)                                                               \
  texture(functions, vec2((texel) * functionScale.x + functionScale.y,                             \
    (float(number) + 0.5) / float(FUNCTION_COUNT)))
#endif

// Grey extinction is one number, so that its transmittance is one exponential.
#ifdef CHROMATIC_EXTINCTION
#define SPECTRUM vec3
#define SPECTRUM_OF(rgb) (rgb)
#define SPECTRUM_MEAN(s) (((s).r + (s).g + (s).b) / 3.0)
#else
#define SPECTRUM float
#define SPECTRUM_OF(rgb) (rgb).r
#define SPECTRUM_MEAN(s) (s)
#endif

vec3 contentScattering(vec3 box, vec3 extinction)
{
#ifdef SCATTERING_IS_ALBEDO
  return extinction * SCATTERING(box);
#else
  return SCATTERING(box);
#endif
}

SPECTRUM contentExtinction(vec3 box)
{
  vec3 extinction = EXTINCTION(box);
#ifdef EXTINCTION_IS_ABSORPTION
  extinction += contentScattering(box, extinction);
#endif
  return SPECTRUM_OF(extinction);
}

struct Content
{
  SPECTRUM extinction;
  vec3 scattering;
  vec3 emission;
  float anisotropy;
};

Content contentAt(vec3 box)
{
  vec3 extinction = EXTINCTION(box);
  vec3 scattering = contentScattering(box, extinction);
#ifdef EXTINCTION_IS_ABSORPTION
  extinction += scattering;
#endif
#ifdef EMISSION
  vec3 emission = EMISSION(box);
#else
  vec3 emission = vec3(0.0);
#endif
  return Content(SPECTRUM_OF(extinction), scattering, emission, ANISOTROPY(box));
}
