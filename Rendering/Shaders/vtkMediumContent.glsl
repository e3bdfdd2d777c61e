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

#ifdef EXTINCTION_BETWEEN
uniform sampler2D primitives; // one row a function: its integral from the first value, range 0...1

// A function's integral from a texel of 0 to this one: exact, since the function is linear between its
// samples.
vec4 functionPrimitive(int number, float texel)
{
  int intervals = textureSize(functions, 0).x - 1;
  float position = clamp(texel, 0.0, 1.0) * float(intervals);
  int i = min(int(position), intervals - 1);
  float x = position - float(i);
  vec4 here = texelFetch(functions, ivec2(i, number), 0);
  vec4 there = texelFetch(functions, ivec2(i + 1, number), 0);
  return texelFetch(primitives, ivec2(i, number), 0) +
    (here + 0.5 * x * (there - here)) * x / float(intervals);
}

// The mean of a function over the values between two texels. Where they are so close that the difference of
// the primitive would be rounding, the few linear pieces between them are summed; written out, not looped:
// iterations are what software renderers ration.
#define FUNCTION_PIECE                                                                             \
  {                                                                                                \
    float to = min(floor(from) + 1.0, ends.y);                                                     \
    sum += (to - from) * functionValue(number, 0.5 * (from + to) / intervals);                     \
    from = to;                                                                                     \
  }
vec4 functionMean(int number, float a, float b)
{
  float intervals = float(textureSize(functions, 0).x - 1);
  vec2 ends = clamp(vec2(min(a, b), max(a, b)), 0.0, 1.0) * intervals;
  float from = ends.x, length = ends.y - ends.x;
  if (length > 3.0)
  {
    return (functionPrimitive(number, b) - functionPrimitive(number, a)) / (b - a);
  }
  if (length <= 0.0)
  {
    return functionValue(number, 0.5 * (a + b));
  }
  vec4 sum = vec4(0.0);
  FUNCTION_PIECE
  FUNCTION_PIECE
  FUNCTION_PIECE
  FUNCTION_PIECE
  return sum / length;
}
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

#ifdef USER_COEFFICIENTS
uniform float worldLength; // world units in a local unit

// Code of the user, in voxels that are not masked out. `box` is 0 to 1 over the volume.
void contentAltered(vec3 box, inout vec3 extinction, inout vec3 scattering, inout vec3 emission,
  inout float anisotropy)
{
#ifdef MASK
  if (MASK(box) == 0.0)
  {
    return;
  }
#endif
  //VTK::Medium::Coefficients::Impl
  extinction = max(extinction, 0.0);
}
#endif

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
  float anisotropy = ANISOTROPY(box);
#ifdef USER_COEFFICIENTS
  contentAltered(box, extinction, scattering, emission, anisotropy);
#endif
  return Content(SPECTRUM_OF(extinction), scattering, emission, anisotropy);
}

SPECTRUM contentExtinction(vec3 box)
{
#ifdef USER_COEFFICIENTS
  return contentAt(box).extinction;
#else
  vec3 extinction = EXTINCTION(box);
#ifdef EXTINCTION_IS_ABSORPTION
  extinction += contentScattering(box, extinction);
#endif
  return SPECTRUM_OF(extinction);
#endif
}
