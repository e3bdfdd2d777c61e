// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact: cell by cell along the eye ray and along a light ray from each of its points. Optical depths are
// met to rounding. The source has kinks where light rays cross the lattice's edges, so each cell is
// halved until two-point Gauss-Legendre on a part and on its halves agree.

uniform int iterationBudget;  // iterations after which a draw hands over to the next
uniform float exactTolerance; // of the pixel's radiance so far

#define EXACT_DEEPEST 6 // halvings of a cell

// A part of the cell that begins at `t`: the `index`th of 2^level equal ones.
struct ExactPlace
{
  float t;
  int level;
  int index;
};

// Radiance from a to b, seen from a, by two-point Gauss-Legendre, and the optical depth that the same
// points make of it.
vec4 exactGather(EyeRay ray, vec3 start, vec3 along, float a, float b)
{
  vec4 sum = vec4(0.0);
  for (int node = -1; node <= 1; node += 2)
  {
    float t = 0.5 * (a + b) + float(node) * EXACT_GAUSS * (b - a);
    Content content = contentAt(start + t * along);
    COUNT(1);
    sum.a += SPECTRUM_MEAN(content.extinction);
    if (content.scattering + content.emission != vec3(0.0))
    {
      vec3 source = sourceAt(ray.origin + t * ray.direction, ray.direction, 0.0, content);
      sum.rgb += source * transmittance(exactCellDepth(start, along, a, t));
    }
  }
  return 0.5 * (b - a) * sum;
}

// The part that follows an accepted one; `end` is where the cell ends.
ExactPlace exactAdvance(ExactPlace place, float end)
{
  ++place.index;
  while (place.level > 0 && place.index % 2 == 0)
  {
    place.index /= 2;
    --place.level;
  }
  return place.level == 0 ? ExactPlace(end, 0, 0) : place;
}

// Integrates a part, or halves it. Returns its optical depth, 0 if it was halved.
SPECTRUM exactStep(EyeRay ray, Kept kept, vec3 start, vec3 along, SPECTRUM before,
  inout ExactPlace place, inout FrameState state)
{
  float end =
    max(cellWalkNext(start, along, place.t, keptEnd(kept, place.t)), place.t + CELL_WALK_LEAST);
  float width = (end - place.t) / float(1 << place.level);
  float a = place.t + float(place.index) * width;
  float middle = a + 0.5 * width;
  SPECTRUM first = exactCellDepth(start, along, a, middle);
  SPECTRUM second = exactCellDepth(start, along, middle, a + width);
  vec4 whole = exactGather(ray, start, along, a, a + width);
  vec4 nearHalf = exactGather(ray, start, along, a, middle);
  vec4 farHalf = exactGather(ray, start, along, middle, a + width);
  vec3 halves = nearHalf.rgb + transmittance(first) * farHalf.rgb;
  vec3 seen = transmittance(before) * halves;
  vec3 difference = abs(transmittance(before) * (whole.rgb - halves));
  // What lies between all points shows in the optical depth, which misses nothing.
  float missed = abs(nearHalf.a + farHalf.a - SPECTRUM_MEAN(first + second));
  bool agree = place.level > 0 && missed <= 4.0 * exactTolerance &&
    all(lessThanEqual(difference, exactTolerance * (state.radiance + seen)));
  if (!agree && place.level < EXACT_DEEPEST)
  {
    place = ExactPlace(place.t, place.level + 1, place.index * 2);
    return SPECTRUM(0.0);
  }
  outputSegment(ray.offset + a, width, before, first + second, seen, state);
  place = exactAdvance(place, end);
  place.t = place.level == 0 ? keptNext(kept, place.t) : place.t;
  return first + second;
}

void main()
{
  EyeRay ray = eyeRay();
  if (!(ray.span > 0.0))
  {
    discard;
  }
  FrameState state = frameBegin();
  bool begins = firstStep == 0;
  // While the march goes on, march holds the optical depth and t, and alpha which part of the cell.
  SPECTRUM depth = SPECTRUM_OF(begins ? vec3(0.0) : state.march.rgb);
  int code = begins ? 0 : int(state.alpha);
  Kept kept = keptOf(ray.origin, ray.direction, ray.span);
  ExactPlace place = ExactPlace(begins ? keptNext(kept, 0.0) : state.march.a, code / 64, code % 64);
  vec3 start = frameBoxPoint(ray.origin);
  vec3 along = frameBoxDirection(ray.direction);
  bool over = begins ? place.t >= KEPT_OVER : state.rays == 1.0;
  while (!over && exactIterations < iterationBudget)
  {
    exactIterations += 16 * (EXACT_PARTS + 2); // the parts and nodes of one step
    depth += exactStep(ray, kept, start, along, depth, place, state);
    over = place.t >= KEPT_OVER || outputIsOver(depth, state);
  }
  state.rays = over ? 1.0 : FRAME_UNFINISHED;
  state.march = vec4(vec3(depth), place.t);
  state.alpha = over ? 1.0 - SPECTRUM_MEAN(transmittance(depth))
                     : float(place.level * 64 + place.index);
  outputEnd(depth, state);
}
