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

float lightTransmittance(int number, vec3 point, Light light)
{
  vec3 start = frameBoxPoint(point);
  vec3 along = frameBoxDirection(light.direction);
  float span = min(rayBox(start, along).y, light.distance);
  KeptSteps steps = keptSteps(keptOf(point, light.direction, span), LIGHT_STEPS_LONGEST);
  float sum = 0.0;
  float passed = 1.0; // transmittance of the marched part
  vec2 rest = steps.count > 0 ? lightCacheRough(number, start) : vec2(1.0, 0.0);
  int i = 0;
  int iterations = 0;
  float asked = 0.0;
  while (i < steps.count && passed * rest.y * lightImportance > lightTolerance)
  {
    sum += lightStepsFrom(start, along, steps, i, asked);
    ++iterations;
    bool over = i >= steps.count;
    if (over || iterations % lightLookUpEvery == 0)
    {
      passed = transmittance(sum);
      rest = over ? vec2(1.0, 0.0)
                  : lightCacheRough(number, start + keptStep(steps, i).x * along);
    }
  }
  return passed * rest.x;
}
