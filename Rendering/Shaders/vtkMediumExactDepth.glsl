// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Optical depth to the accuracy of float: cell by cell, each in closed form.

#define EXACT_GAUSS 0.28867513459481287 // half the distance of two-point Gauss-Legendre's nodes, / width

// Over a to b inside one cell. There the field along the ray is a cubic: two Gauss-Legendre points are
// exact where the extinction is affine in it. Where the extinction is a function of the field, the
// function's mean over the values that a part of the segment spans is exact for a field that is linear
// along the part, whatever knots and steps the function has; shifted by how far the field bends, it is
// exact for a parabola where the function is linear.
SPECTRUM exactCellDepth(vec3 start, vec3 along, float a, float b)
{
#ifdef EXTINCTION_BETWEEN
  float last = EXTINCTION_TEXEL(start + a * along);
  SPECTRUM sum = SPECTRUM(0.0);
  float width = (b - a) / float(EXACT_PARTS);
  for (int part = 1; part <= EXACT_PARTS; ++part)
  {
    float t = a + float(part) * width;
    float middle = EXTINCTION_TEXEL(start + (t - 0.5 * width) * along);
    float here = EXTINCTION_TEXEL(start + t * along);
    // Simpson's mean of the field, less that of the straight line.
    float bend = 2.0 / 3.0 * (middle - 0.5 * (last + here));
    sum += SPECTRUM_OF(EXTINCTION_BETWEEN(last + bend, here + bend));
    last = here;
  }
  COUNT(2 * EXACT_PARTS + 1);
#ifdef MASK
  sum *= MASK(start + 0.5 * (a + b) * along); // the same in all of a cell
#endif
  return sum * (b - a) / float(EXACT_PARTS);
#else
  float middle = 0.5 * (a + b);
  float reach = EXACT_GAUSS * (b - a);
  COUNT(2);
  return 0.5 * (b - a) *
    (contentExtinction(start + (middle - reach) * along) +
      contentExtinction(start + (middle + reach) * along));
#endif
}

int exactIterations = 0; // loop iterations that this draw has spent on light rays

#ifdef LIT
// From a point to a light.
SPECTRUM lightTransmittance(int number, vec3 point, Light light)
{
  vec3 start = frameBoxPoint(point);
  vec3 along = frameBoxDirection(light.direction);
  float span = min(rayBox(start, along).y, light.distance);
  Kept kept = keptOf(point, light.direction, span);
  SPECTRUM sum = SPECTRUM(0.0);
  float t = keptNext(kept, 0.0);
  while (t < KEPT_OVER)
  {
    float next = max(cellWalkNext(start, along, t, keptEnd(kept, t)), t + CELL_WALK_LEAST);
    sum += exactCellDepth(start, along, t, next);
    t = keptNext(kept, next);
    exactIterations += EXACT_PARTS + 2; // this loop's and those of the parts, with their ends
  }
  return transmittance(sum);
}
#endif
