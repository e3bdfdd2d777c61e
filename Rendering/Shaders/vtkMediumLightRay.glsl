// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The transmittance from a point to a light, by midpoint marching.

// One of the LIGHT_TAPS look-ups of an iteration. Written out, not looped: Mesa does not unroll such a
// loop inside another, and counts its iterations too.
#if LIGHT_TAPS != 4
#error "LIGHT_TAPS look-ups are written out below; change both"
#endif
#define LIGHT_RAY_TAP(k)                                                                           \
  part += contentExtinction(start + (float(i * LIGHT_TAPS + k) + 0.5) * width * along);

// The part of the light ray inside the volume is cut into equal steps of at most lightStep, a multiple
// of LIGHT_TAPS of them: several look-ups an iteration keep a long march within the number of loop
// iterations that software renderers allow (see vtkMediumPlan::Capabilities).
SPECTRUM lightTransmittance(int number, vec3 point, Light light)
{
  vec3 start = frameBoxPoint(point);
  vec3 along = frameBoxDirection(light.direction);
  float span = min(rayBox(start, along).y, light.distance);
  if (!(span > 0.0))
  {
    return SPECTRUM(1.0);
  }
  int iterations = int(ceil(span / (lightStep * float(LIGHT_TAPS))));
  float width = span / float(iterations * LIGHT_TAPS);
  SPECTRUM sum = SPECTRUM(0.0);
  for (int i = 0; i < iterations; ++i)
  {
    SPECTRUM part = SPECTRUM(0.0);
    LIGHT_RAY_TAP(0)
    LIGHT_RAY_TAP(1)
    LIGHT_RAY_TAP(2)
    LIGHT_RAY_TAP(3)
    sum += part;
  }
  COUNT(iterations * LIGHT_TAPS);
  return transmittance(sum * width);
}
