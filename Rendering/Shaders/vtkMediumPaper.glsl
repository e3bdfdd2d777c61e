// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Paper: the algorithm of Han, Ki and Oh, "GPU Ray Marching for Real-Time Rendering of Participating
// Media": a homogeneous medium fills the voxels at or above a threshold. Linear search along the eye
// ray finds where it enters, samples at equal steps from there gather scattered light, and a search
// along the light ray from each of them finds the way that the light came through the medium.
// ASSUME_CONVEX ends each ray at its first exit, as the paper does; else it goes on through every
// filled interval, which the paper's section 6 wishes for.

uniform vec3 paperExtinction, paperScattering; // per local unit
uniform float paperAnisotropy;
#ifdef JITTER
uniform float paperJitter;      // the largest start, as a fraction of a step
uniform sampler2D jitterTable;  // random numbers in [0, 1)
uniform ivec2 firstPixel;       // of the target in the viewport, of which it may be a tile
#endif

#ifdef LIT
// The length of the light ray inside the medium, from a point in it to where the ray leaves the volume
// or meets the light.
float paperLightPath(vec3 point, Light light)
{
  vec3 start = frameBoxPoint(point);
  vec3 along = frameBoxDirection(light.direction);
  float span = min(rayBox(start, along).y, light.distance);
  Kept kept = keptOf(point, light.direction, span);
  float path = 0.0;
  float base = keptNext(kept, 0.0), entry = base, before = base;
  bool inside = true;
  for (int k = 1; before < KEPT_OVER; ++k)
  {
    float end = keptEnd(kept, before);
    float t = min(base + float(k) * lightStep, end);
    bool filled = paperFilled(start + t * along);
    if (filled != inside)
    {
      float crossing = paperBisect(start, along, before, t, filled);
#ifdef ASSUME_CONVEX
      return crossing - entry;
#endif
      path += inside ? crossing - entry : 0.0;
      entry = crossing;
      inside = filled;
    }
    before = t;
    if (t >= end) // the volume's or that of a part that is kept
    {
      path += inside ? end - entry : 0.0;
      base = entry = before = keptNext(kept, end);
      k = 0;
      inside = before < KEPT_OVER && paperFilled(start + before * along);
#ifdef ASSUME_CONVEX
      return path;
#endif
    }
  }
  return path;
}

// Light scattered towards the eye per local unit at a point, by the lights of this draw.
vec3 paperInScatter(vec3 point, vec3 direction)
{
  vec3 sum = vec3(0.0);
  for (int number = firstLight; number < lastLight; ++number)
  {
    Light light = lightAt(number, point, direction, 0.0);
    float phase = PHASE(phaseAngle(light.direction, direction), paperAnisotropy);
    sum += light.irradiance * phase * transmittance(paperExtinction * paperLightPath(point, light));
  }
  return paperScattering * sum;
}
#endif

// Where the march stands: at base + steps * eyeStep, with `path` of the medium behind `base`.
struct PaperMarch
{
  float base, steps, path, place;
};

#define PAPER_OUTSIDE 0.0
#define PAPER_INSIDE 1.0
#define PAPER_DONE 2.0

// At the first point of the next part of the ray that is kept: t and place.
PaperMarch paperEnter(EyeRay ray, vec3 start, vec3 along, Kept kept, PaperMarch march, float t,
  inout FrameState state)
{
  march.base = keptNext(kept, t);
  march.steps = 0.0;
  march.place = PAPER_DONE;
  if (march.base < KEPT_OVER)
  {
    bool filled = paperFilled(start + march.base * along);
    state.first = filled && !frameHasHit(state) ? ray.offset + march.base : state.first;
    march.place = filled ? PAPER_INSIDE : PAPER_OUTSIDE;
  }
  return march;
}

PaperMarch paperBegin(
  EyeRay ray, vec3 start, vec3 along, Kept kept, inout FrameState state)
{
  if (firstStep > 0)
  {
    return PaperMarch(state.march.x, state.march.y, state.march.z, state.march.w);
  }
  PaperMarch march = PaperMarch(0.0, 0.0, 0.0, PAPER_OUTSIDE);
  return paperEnter(ray, start, along, kept, march, 0.0, state);
}

// One linear step: find its end, gather light if it is inside, then move on.
void paperStep(EyeRay ray, vec3 start, vec3 along, Kept kept, float jitter,
  inout PaperMarch march, inout FrameState state)
{
  bool inside = march.place == PAPER_INSIDE;
  float t = march.base + march.steps * eyeStep;
  float partEnd = keptEnd(kept, t);
  float next = min(t + eyeStep, partEnd);
  bool filled = paperFilled(start + next * along);
  bool crossed = filled != inside;
  float end = crossed ? paperBisect(start, along, t, next, filled) : next;
#ifdef LIT
  if (inside)
  {
    // A whole step has its own length: the difference of two places is rounded to their last digit.
    float size = crossed || next == partEnd ? end - t : eyeStep;
    float at = t + jitter * size;
    vec3 source = paperInScatter(ray.origin + at * ray.direction, ray.direction);
    vec3 depth = paperExtinction * (march.path + at - march.base);
    state.radiance += transmittance(depth) * source * size;
  }
#endif
  bool over = next >= partEnd && (!crossed || end >= partEnd);
  if (crossed || over)
  {
    march.path += inside ? end - march.base : 0.0;
    state.last = inside ? ray.offset + end : state.last;
    state.first = filled && !frameHasHit(state) ? ray.offset + end : state.first;
    march.base = end;
    march.steps = 0.0;
    march.place = filled ? PAPER_INSIDE : PAPER_OUTSIDE;
    if (over)
    {
      march = paperEnter(ray, start, along, kept, march, end, state);
    }
#ifdef ASSUME_CONVEX
    march.place = inside ? PAPER_DONE : march.place;
#endif
    return;
  }
  march.steps += 1.0;
}

// 1 - mean transmittance of the medium that the march has passed.
float paperAlpha(PaperMarch march)
{
  float here = march.place == PAPER_INSIDE ? march.steps * eyeStep : 0.0;
  return 1.0 - dot(transmittance(paperExtinction * (march.path + here)), vec3(1.0 / 3.0));
}

void main()
{
  EyeRay ray = eyeRay();
  if (!(ray.span > 0.0))
  {
    discard;
  }
  FrameState state = frameBegin();
  vec3 start = frameBoxPoint(ray.origin);
  vec3 along = frameBoxDirection(ray.direction);
#ifdef JITTER
  ivec2 entry = (ivec2(gl_FragCoord.xy) + firstPixel) % textureSize(jitterTable, 0);
  float jitter = paperJitter * texelFetch(jitterTable, entry, 0).r;
#else
  float jitter = 0.0;
#endif
  state.rays = 1.0;
  Kept kept = keptOf(ray.origin, ray.direction, ray.span);
  PaperMarch march = paperBegin(ray, start, along, kept, state);
  for (int i = firstStep; i < lastStep && march.place != PAPER_DONE; ++i)
  {
    paperStep(ray, start, along, kept, jitter, march, state);
    state.alpha = paperAlpha(march);
    if (1.0 - state.alpha < transmittanceThreshold || (FIRST_HIT_ONLY && frameHasHit(state)))
    {
      march.place = PAPER_DONE;
    }
  }
  state.march = vec4(march.base, march.steps, march.path, march.place);
  frameEnd(state);
}
