// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The caches of the lights' transmittance that vtkMediumLightCache built, several lights a texture. Values
// are prefiltered, so that trilinear look-ups err to both sides; single ones may lie a little outside of
// 0...1.

uniform sampler3D lightCaches[LIGHT_CACHE_TEXTURES];
uniform vec3 lightCacheScale, lightCacheBias; // box to what foldPlace takes
FOLD(lightCacheFold)

// GLSL 1.50 wants the number of a texture to be a constant.
vec4 lightCacheTexel(int number, vec3 at)
{
#if LIGHT_CACHE_TEXTURES > 1
  if (number == 1)
  {
    return texture(lightCaches[1], at);
  }
#endif
#if LIGHT_CACHE_TEXTURES > 2
  if (number == 2)
  {
    return texture(lightCaches[2], at);
  }
#endif
#if LIGHT_CACHE_TEXTURES > 3
  if (number == 3)
  {
    return texture(lightCaches[3], at);
  }
#endif
  return texture(lightCaches[0], at);
}

vec4 lightCacheAt(int light, vec3 box)
{
  COUNT(1);
  return lightCacheTexel(light / LIGHTS_PER_CACHE_TEXTURE,
    foldPlace(lightCacheFold, box * lightCacheScale + lightCacheBias));
}

#ifdef LIGHT_CACHE_ROUGHNESS
// The part of a segment's source that reaches the eye, and its width; the integrator sets them.
float lightSourceWeight = 1.0;
float lightSourceWidth = 0.0;
// The same part for the light that is being followed, unshadowed; inScatter sets it.
float lightImportance = 1.0;
// What look-ups may err by, so far: radiance.
float lightCacheRoughness = 0.0;

// Transmittance and roughness.
vec2 lightCacheRough(int number, vec3 box)
{
  vec4 texel = lightCacheAt(number, box);
  return number % 2 == 0 ? texel.xy : texel.zw;
}
#endif

#ifndef ONLY_ROUGH
// The transmittance from a point to a light, by one look-up.
float lightTransmittance(int number, vec3 point, Light light)
{
#ifdef LIGHT_CACHE_ROUGHNESS
  vec2 rough = lightCacheRough(number, frameBoxPoint(point));
  lightCacheRoughness += rough.y * lightImportance * lightSourceWidth;
  return rough.x;
#else
  return lightCacheAt(number, frameBoxPoint(point))[number % LIGHTS_PER_CACHE_TEXTURE];
#endif
}
#endif
