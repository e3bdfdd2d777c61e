// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The lights, four texels each. There may be any number of them in a texture; a single light needs none.

#ifdef ONE_LIGHT
uniform vec4 oneLight[4];
#define lightTexel(column, number) oneLight[column]
#else
uniform sampler2D lights;
#define lightTexel(column, number) texelFetch(lights, ivec2(column, number), 0)
#endif

struct Light
{
  vec3 point;      // from which the light is seen; local
  vec3 direction;  // unit, from the point towards the light; local
  float distance;  // to the light, local units; huge if directional
  vec3 irradiance; // on a plane normal to the beam, without the medium; 0 behind opaque geometry
};

#define LIGHT_DIRECTIONAL 0.0
#define LIGHT_SPOT 2.0
// Nearer than so many lengths of a segment, a light's attenuation is averaged over it. Beyond, the value in
// its middle is within 1e-3 of the mean: (1/2 / 16)^2.
#define LIGHT_NEAR 16.0

#ifdef POSITIONAL_LIGHTS
// Sets what a positional light sends to a segment along `direction`, of the width, in whose middle
// light.point is; to that point if the width is 0. Near an inverse square, the light is seen from the mean
// place of what the segment scatters.
void lightReach(vec3 position, vec3 abc, vec3 direction, float width, inout Light light)
{
  vec3 offset = position - light.point;
  float reach = LIGHT_NEAR * width;
  bool near = abc.y == 0.0 && abc.z > 0.0 && dot(offset, offset) < reach * reach;
  if (near)
  {
    vec2 segment = lightSegment(offset, direction, width, abc.x / abc.z);
    light.irradiance *= segment.x / abc.z;
    light.point += segment.y * direction;
    offset -= segment.y * direction;
  }
  light.distance = length(offset);
  light.direction = light.distance > 0.0 ? offset / light.distance : vec3(0.0, 0.0, 1.0);
  light.irradiance *= near ? 1.0 : lightAttenuation(light.distance, abc);
}
#endif

// Light `number` as seen from a segment of the eye ray. Texels: (position or direction towards the light,
// type), (colour x intensity, cosine of the cone), (attenuation a b c, exponent), (spot axis, unused).
Light lightAt(int number, vec3 middle, vec3 direction, float width)
{
  vec4 place = lightTexel(0, number);
  vec4 colour = lightTexel(1, number);
  Light light = Light(middle, place.xyz, 1.0e30, colour.rgb);
#ifdef POSITIONAL_LIGHTS
  if (place.w != LIGHT_DIRECTIONAL)
  {
    vec4 attenuation = lightTexel(2, number);
    lightReach(place.xyz, attenuation.xyz, direction, width, light);
#ifdef SPOT_LIGHTS
    if (place.w == LIGHT_SPOT)
    {
      vec3 axis = lightTexel(3, number).xyz;
      light.irradiance *= lightSpot(-dot(light.direction, axis), colour.a, attenuation.w);
    }
#endif
  }
#endif
#ifdef OPAQUE_SHADOWS
  if (light.irradiance != vec3(0.0))
  {
    vec3 way = place.w == LIGHT_DIRECTIONAL ? vec3(0.0) : light.point - place.xyz;
    light.irradiance *= shadowMapLit(number, light.point, way);
  }
#endif
  return light;
}
