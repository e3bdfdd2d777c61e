// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// FixedStep: midpoint marching along the eye ray with a closed form in each segment, and along a light
// ray from each midpoint. Second order in both steps where the medium is smooth.

// What a march has behind it. Optical depths are summed in blocks, so that rounding does not build up.
struct March
{
  SPECTRUM blocks, block;
  int blockBegin;
  int next; // step
};

uniform float eyeStretch;  // steps grow with the transmittance to the power of -eyeStretch; 0: never
uniform float longestStretch;

// How many steps are taken as one segment behind this optical depth. What a segment errs by is seen through
// the medium before it and grows with the cube of its length.
int fixedStepStretch(SPECTRUM before)
{
  float seen = max(SPECTRUM_MEAN(transmittance(before)), 1.0e-30); // a power of 0 is undefined
  return int(min(pow(seen, -eyeStretch), longestStretch) + 1.0e-3);
}

// One segment (begin, width): constant coefficients and source, taken at its middle. Returns its optical
// depth. Nothing of it counts where the width is 0.
SPECTRUM fixedStepSegment(EyeRay ray, vec2 segment, SPECTRUM before, inout FrameState state)
{
  float width = segment.y;
  float middle = segment.x + 0.5 * width;
  vec3 point = ray.origin + middle * ray.direction;
  Content content = contentAt(frameBoxPoint(point));
  COUNT(FIELD_COUNT > 0 && width > 0.0 ? 1 : 0);
  SPECTRUM depth = content.extinction * width;
  SPECTRUM weight = transmittance(before) * segmentMeanTransmittance(depth);
#ifdef LIGHT_CACHE_ROUGHNESS
  lightSourceWeight = weight;
  lightSourceWidth = width;
#endif
  if (width > 0.0)
  {
    vec3 gathered = weight * width * sourceAt(point, ray.direction, width, content);
    outputSegment(ray.offset + segment.x, width, before, depth, gathered, state);
  }
  return depth;
}

// The next segment of the march, which has no width behind step `last`. Returns its optical depth.
SPECTRUM fixedStepTake(EyeRay ray, KeptSteps steps, int stretch, int last, inout March march,
  inout FrameState state)
{
  int joined = clamp(last - march.next, 0, stretch);
  vec2 segment = keptStep(steps, march.next);
  SPECTRUM depth = fixedStepSegment(
    ray, vec2(segment.x, segment.y * float(joined)), march.blocks + march.block, state);
  march.block += depth;
  march.next += joined;
  return depth;
}

#ifndef TILES
#define eyeLeapsFrom 0.0
#endif
// Goes on from the iteration that began with step i and met an optical depth. Leaps are of whole segments,
// so that what follows is divided as if there had been no leap.
void fixedStepGoOn(EyeRay ray, KeptSteps steps, int i, int stretch, SPECTRUM depth, inout March march,
  inout float asked)
{
  if (march.next - march.blockBegin >= 64)
  {
    march.blocks += march.block;
    march.block = SPECTRUM(0.0);
    march.blockBegin = march.next;
  }
#ifdef TILES
  if (depth == SPECTRUM(0.0))
  {
    vec2 segment = keptStep(steps, i);
    float middle = segment.x + 0.5 * segment.y;
    int next = emptyBricksNext(steps, i, middle, frameBoxPoint(ray.origin + middle * ray.direction),
      frameBoxDirection(ray.direction), asked);
    march.next += max(next - march.next, 0) / stretch * stretch;
  }
#endif
}

#ifdef ONLY_ROUGH
#define EYE_RAYS 2.0 // of the pixel, with this one
uniform float pixelTolerance; // radiance

// Whether the pixel is integrated anew; if so, it begins anew with the first draw.
bool fixedStepBeginsRough(inout FrameState state)
{
  bool rough = state.march.a > pixelTolerance;
  if (rough && firstStep == 0 && firstLight == 0)
  {
    state.radiance = vec3(0.0);
    state.first = state.last = FRAME_NO_HIT;
  }
  return rough;
}
#else
#define EYE_RAYS 1.0
#endif

void main()
{
  EyeRay ray = eyeRay();
  if (!(ray.span > 0.0))
  {
    discard;
  }
  FrameState state = frameBegin();
#ifdef ONLY_ROUGH
  if (!fixedStepBeginsRough(state))
  {
    frameEnd(state);
    return;
  }
#endif
  state.rays = EYE_RAYS;
  KeptSteps steps = keptSteps(keptOf(ray.origin, ray.direction, ray.span), eyeStep);
  int last = min(lastStep, steps.count);
  March march = March(SPECTRUM_OF(firstStep == 0 ? vec3(0.0) : state.march.rgb), SPECTRUM(0.0),
    firstStep, firstStep);
  float asked = eyeLeapsFrom;
  while (march.next < last && !outputIsOver(march.blocks + march.block, state))
  {
    int i = march.next;
    int stretch = keptJoined(fixedStepStretch(march.blocks + march.block));
    SPECTRUM depth = fixedStepTake(ray, steps, stretch, last, march, state);
#ifndef MARCHED_LIGHT
    // Where a segment needs no loop of its own, four an iteration cost software renderers less. Written out,
    // not looped, for the reason that LightSteps gives.
    depth += fixedStepTake(ray, steps, stretch, last, march, state);
    depth += fixedStepTake(ray, steps, stretch, last, march, state);
    depth += fixedStepTake(ray, steps, stretch, last, march, state);
#endif
    fixedStepGoOn(ray, steps, i, stretch, depth, march, asked);
  }
  SPECTRUM total = march.blocks + march.block;
  state.march.rgb = vec3(total);
#ifdef LIGHT_CACHE_ROUGHNESS
  state.march.a += lightCacheRoughness;
#endif
  state.alpha = 1.0 - SPECTRUM_MEAN(transmittance(total));
  outputEnd(total, state);
}
