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
  for (int i = 0; i < steps.count; ++i)
  {
    sum += lightSteps(start, along, keptStep(steps, i));
  }
  COUNT(steps.count * LIGHT_STEPS_LOOK_UPS);
  return transmittance(sum);
}
