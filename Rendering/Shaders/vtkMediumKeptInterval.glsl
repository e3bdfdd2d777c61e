// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What is kept of a ray, where that is one interval: all of it, or what clipping planes leave. Has the
// same functions as KeptRegions; t counts from the ray's origin, local units.

#define KEPT_OVER 1.0e30 // the t behind everything that is kept

struct Kept
{
  float begin, end; // nothing if begin >= end
};

// Of origin + t direction, 0 <= t <= span; local.
Kept keptOf(vec3 origin, vec3 direction, float span)
{
#ifdef CLIPPING_PLANES
  vec2 interval = clippingInterval(origin, direction, vec2(0.0, span));
  return Kept(interval.x, interval.y);
#else
  return Kept(0.0, span);
#endif
}

// From the first t to the last.
vec2 keptHull(Kept kept)
{
  return vec2(kept.begin, kept.end);
}

// Here, or where the next part begins; KEPT_OVER if there is none.
float keptNext(Kept kept, float t)
{
  return t < kept.end ? max(t, kept.begin) : KEPT_OVER;
}

// Where the part that t lies in ends.
float keptEnd(Kept kept, float t)
{
  return kept.end;
}

// Equal steps that fill what is kept.
struct KeptSteps
{
  float begin, width;
  int count;
};

KeptSteps keptSteps(Kept kept, float longest)
{
  float span = max(kept.end - kept.begin, 0.0);
  float count = ceil(span / longest);
  return KeptSteps(kept.begin, span / max(count, 1.0), int(count));
}

// Where step i begins, and its width.
vec2 keptStep(KeptSteps steps, int i)
{
  return vec2(steps.begin + float(i) * steps.width, steps.width);
}

// The step that t lies in; the number of steps behind the last.
int keptStepAt(KeptSteps steps, float t)
{
  return int(clamp((t - steps.begin) / steps.width, 0.0, float(steps.count)));
}

// How many of so many steps may be taken as one.
int keptJoined(int steps)
{
  return steps;
}
