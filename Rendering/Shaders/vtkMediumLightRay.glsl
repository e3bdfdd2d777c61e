// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The optical depth from a point to a light, by midpoint marching.

// The part of the light ray inside the volume is cut into equal steps of at most lightStep, a multiple
// of LIGHT_TAPS of them: several look-ups an iteration keep a long march within the number of loop
// iterations that software renderers allow (see vtkMediumPlan::Capabilities).
SPECTRUM lightRayOpticalDepth(vec3 point, Light light)
{
  vec3 start = frameBoxPoint(point);
  vec3 along = frameBoxDirection(light.direction);
  float span = min(rayBox(start, along).y, light.distance);
  if (!(span > 0.0))
  {
    return SPECTRUM(0.0);
  }
  int iterations = int(ceil(span / (lightStep * float(LIGHT_TAPS))));
  float width = span / float(iterations * LIGHT_TAPS);
  SPECTRUM sum = SPECTRUM(0.0);
  for (int i = 0; i < iterations; ++i)
  {
    SPECTRUM part = SPECTRUM(0.0);
    for (int k = 0; k < LIGHT_TAPS; ++k)
    {
      float t = (float(i * LIGHT_TAPS + k) + 0.5) * width;
      part += contentExtinction(start + t * along);
    }
    sum += part;
  }
  COUNT(iterations * LIGHT_TAPS);
  return sum * width;
}
