// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The transmittance from a point to a light, by marching until the cache of that light is accurate enough
// for what the look-up is worth in the image: its roughness (vtkMediumLightCache), weakened by the part
// that was marched, times the radiance that full light would add to the pixel along a unit of length.

uniform float lightTolerance; // radiance per local unit
// Iterations from look-up to look-up: some voxels, whatever the step, since the place with the smallest
// roughness of many is not as accurate as it looks.
uniform int lightLookUpEvery;

// The part of a source at the point that reaches the eye; the integrator sets it.
float lightSourceWeight = 1.0;
// The same for the light that is being followed, unshadowed; inScatter sets it.
float lightImportance = 1.0;

// Transmittance and roughness.
vec2 lightMarchLookUp(int number, vec3 box)
{
  vec4 texel = lightCacheAt(number, box);
  return number % 2 == 0 ? texel.xy : texel.zw;
}

float lightTransmittance(int number, vec3 point, Light light)
{
  vec3 start = frameBoxPoint(point);
  vec3 along = frameBoxDirection(light.direction);
  float span = min(rayBox(start, along).y, light.distance);
  if (!(span > 0.0))
  {
    return 1.0;
  }
  int iterations = lightStepsCount(span);
  float width = span / float(iterations * LIGHT_TAPS);
  float sum = 0.0;
  float passed = 1.0; // transmittance of the marched part
  vec2 rest = lightMarchLookUp(number, start);
  int i = 0;
  while (i < iterations && passed * rest.y * lightImportance > lightTolerance)
  {
    int last = min(i + lightLookUpEvery, iterations);
    COUNT((last - i) * LIGHT_TAPS);
    for (; i < last; ++i)
    {
      sum += lightSteps(start, along, width, i);
    }
    passed = transmittance(sum * width);
    rest = i < iterations
      ? lightMarchLookUp(number, start + float(i * LIGHT_TAPS) * width * along)
      : vec2(1.0, 0.0);
  }
  return passed * rest.x;
}
