// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact: cell by cell along the eye ray and along a light ray from each of its points. Optical depths are
// met to rounding. The source has kinks where light rays cross the lattice's edges, and jumps where a
// transfer function has: each cell is halved until what is left of the error is small.

uniform int iterationBudget;  // iterations after which a draw hands over to the next
uniform float exactTolerance; // of the pixel's radiance so far

#define EXACT_DEEPEST 11   // halvings of a cell
#define EXACT_INDICES 2048 // 2^EXACT_DEEPEST
// Nothing but the samples tells of the shadows of opaque geometry, so parts are no wider than that, local
// units: of a shadow that is narrower than 1/400 of the volume's diagonal they may tell nothing.
#define EXACT_WIDEST_SHADOWED (1.0 / 128.0)

// Where a part is sampled, -1...1 over it: near its ends, in its middle, and at the nodes of two-point
// Gauss-Legendre on its halves, whose sum is the integral. Two combinations of the samples vanish for every
// cubic: that sum less the three-point rule of the ends and the middle, and an odd one. Gauss-Legendre on
// the whole is no such check, since all of its nodes, and those of the halves, lie on one side of a kink
// near an end; with the ends, the error of one kink or one jump anywhere is at most 1.4 times the greater of
// the first and 0.2 of the second.
const float exactAt[7] = float[](
  -0.99, -0.788675135, -0.211324865, 0.0, 0.211324865, 0.788675135, 0.99);
const float exactHalves[7] = float[](0.0, 0.5, 0.5, 0.0, 0.5, 0.5, 0.0);
const float exactEnds[7] = float[](
  0.340101350, 0.0, 0.0, 1.319797300, 0.0, 0.0, 0.340101350);
const float exactOdd[7] = float[](
  -0.2, 0.406765810, -0.581124610, 0.0, 0.581124610, -0.406765810, 0.2);

// A part of the cell that begins at `t`: the `index`th of 2^level equal ones.
struct ExactPlace
{
  float t;
  int level;
  int index;
};

// What a part sends to where it begins, and how far that may be off.
struct ExactPart
{
  vec3 radiance;
  vec3 doubt;
  float depth; // optical depth by the samples alone
};

// Whether anything comes from a point: without light rays, no scattering does.
bool exactSends(Content content)
{
#ifdef LIT
  return content.scattering + content.emission != vec3(0.0);
#else
  return content.emission != vec3(0.0);
#endif
}

ExactPart exactGather(EyeRay ray, vec3 start, vec3 along, float a, float width)
{
  vec3 halves = vec3(0.0), ends = vec3(0.0), odd = vec3(0.0);
  float depth = 0.0;
  for (int k = 0; k < 7; ++k)
  {
    float t = a + 0.5 * width * (1.0 + exactAt[k]);
    Content content = contentAt(start + t * along);
    COUNT(1);
    depth += exactHalves[k] * SPECTRUM_MEAN(content.extinction);
    if (exactSends(content))
    {
      vec3 source = sourceAt(ray.origin + t * ray.direction, ray.direction, 0.0, content) *
        transmittance(exactCellDepth(start, along, a, t));
      halves += exactHalves[k] * source;
      ends += exactEnds[k] * source;
      odd += exactOdd[k] * source;
    }
  }
  float scale = 0.5 * width;
  return ExactPart(scale * halves, scale * max(abs(halves - ends), abs(odd)), scale * depth);
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
  ExactPart part = exactGather(ray, start, along, a, width);
  vec3 seen = transmittance(before) * part.radiance;
  // What lies between all points shows in the optical depth, which misses nothing.
  float missed = abs(part.depth - SPECTRUM_MEAN(first + second));
  bool agree = missed <= 4.0 * exactTolerance &&
    all(lessThanEqual(
      transmittance(before) * part.doubt, exactTolerance * (state.radiance + seen)));
#ifdef OPAQUE_SHADOWS
  agree = agree && width <= EXACT_WIDEST_SHADOWED;
#endif
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
  ExactPlace place = ExactPlace(
    begins ? keptNext(kept, 0.0) : state.march.a, code / EXACT_INDICES, code % EXACT_INDICES);
  vec3 start = frameBoxPoint(ray.origin);
  vec3 along = frameBoxDirection(ray.direction);
  bool over = begins ? place.t >= KEPT_OVER : state.rays == 1.0;
  while (!over && exactIterations < iterationBudget)
  {
    exactIterations += 16 * (EXACT_PARTS + 2); // more than the parts and samples of one step
    depth += exactStep(ray, kept, start, along, depth, place, state);
    over = place.t >= KEPT_OVER || outputIsOver(depth, state);
  }
  state.rays = over ? 1.0 : FRAME_UNFINISHED;
  state.march = vec4(vec3(depth), place.t);
  state.alpha = over ? 1.0 - SPECTRUM_MEAN(transmittance(depth))
                     : float(place.level * EXACT_INDICES + place.index);
  outputEnd(depth, state);
}
