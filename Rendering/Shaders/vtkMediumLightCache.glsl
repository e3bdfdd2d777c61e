// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The transmittance from a point to a light, from the caches that vtkMediumLightCache built: four lights
// a texture. Values are prefiltered, so that trilinear look-ups err to both sides; single ones may lie a
// little outside of 0...1.

uniform sampler3D lightCaches[LIGHT_CACHE_GROUPS];
uniform vec3 lightCacheScale, lightCacheBias; // box to texture coordinates

// GLSL 1.50 wants the number of a texture to be a constant.
float lightTransmittance(int number, vec3 point, Light light)
{
  vec3 at = frameBoxPoint(point) * lightCacheScale + lightCacheBias;
  COUNT(1);
#if LIGHT_CACHE_GROUPS > 1
  int group = number / 4;
  if (group == 1)
  {
    return texture(lightCaches[1], at)[number % 4];
  }
#endif
#if LIGHT_CACHE_GROUPS > 2
  if (group == 2)
  {
    return texture(lightCaches[2], at)[number % 4];
  }
#endif
#if LIGHT_CACHE_GROUPS > 3
  if (group == 3)
  {
    return texture(lightCaches[3], at)[number % 4];
  }
#endif
  return texture(lightCaches[0], at)[number % 4];
}
