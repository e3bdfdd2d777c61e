// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The transmittance from a point to a light, by midpoint marching of the part inside the volume.

SPECTRUM lightTransmittance(int number, vec3 point, Light light)
{
  vec3 start = frameBoxPoint(point);
  vec3 along = frameBoxDirection(light.direction);
  float span = min(rayBox(start, along).y, light.distance);
  if (!(span > 0.0))
  {
    return SPECTRUM(1.0);
  }
  int iterations = lightStepsCount(span);
  float width = span / float(iterations * LIGHT_TAPS);
  SPECTRUM sum = SPECTRUM(0.0);
  for (int i = 0; i < iterations; ++i)
  {
    sum += lightSteps(start, along, width, i);
  }
  COUNT(iterations * LIGHT_TAPS);
  return transmittance(sum * width);
}
