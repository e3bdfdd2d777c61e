// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The transmittance from a point to a light, by midpoint marching of what is kept inside the volume.

SPECTRUM lightTransmittance(int number, vec3 point, Light light)
{
  vec3 start = frameBoxPoint(point);
  vec3 along = frameBoxDirection(light.direction);
  float span = min(rayBox(start, along).y, light.distance);
  KeptSteps steps = keptSteps(keptOf(point, light.direction, span), LIGHT_STEPS_LONGEST);
  SPECTRUM sum = SPECTRUM(0.0);
  int i = 0;
  float asked = 0.0;
  while (i < steps.count)
  {
    sum += lightStepsFrom(start, along, steps, i, asked);
  }
  return transmittance(sum);
}
