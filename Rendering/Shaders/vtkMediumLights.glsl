// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The lights, four texels each in one texture, so that there may be any number of them.

uniform sampler2D lights;

struct Light
{
  vec3 direction;  // unit, from the point towards the light; local
  float distance;  // to the light, local units; huge if directional
  vec3 irradiance; // on a plane normal to the beam, without the medium
};

#define LIGHT_DIRECTIONAL 0.0
#define LIGHT_SPOT 2.0

// Light `number` as seen from a point. Texels: (position or direction towards the light, type),
// (colour x intensity, cosine of the cone), (attenuation a b c, exponent), (spot axis, unused).
Light lightAt(int number, vec3 point)
{
  vec4 place = texelFetch(lights, ivec2(0, number), 0);
  vec4 colour = texelFetch(lights, ivec2(1, number), 0);
  Light light = Light(place.xyz, 1.0e30, colour.rgb);
#ifdef POSITIONAL_LIGHTS
  if (place.w != LIGHT_DIRECTIONAL)
  {
    vec4 attenuation = texelFetch(lights, ivec2(2, number), 0);
    vec3 offset = place.xyz - point;
    light.distance = length(offset);
    light.direction = light.distance > 0.0 ? offset / light.distance : vec3(0.0, 0.0, 1.0);
    light.irradiance *= lightAttenuation(light.distance, attenuation.xyz);
#ifdef SPOT_LIGHTS
    if (place.w == LIGHT_SPOT)
    {
      vec3 axis = texelFetch(lights, ivec2(3, number), 0).xyz;
      light.irradiance *= lightSpot(-dot(light.direction, axis), colour.a, attenuation.w);
    }
#endif
  }
#endif
  return light;
}
