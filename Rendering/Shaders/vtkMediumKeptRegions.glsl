// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What is kept of a ray under cropping to regions that make no box: six planes cut it into seven pieces, of
// which at most four are apart. Has the same functions as KeptInterval; t counts from the ray's origin,
// local units.

// Distance from the lower and from the upper cropping plane of each axis, local.
uniform vec4 croppingLower[3], croppingUpper[3];
uniform int croppingRegions; // bit x + 3 y + 9 z of each region that is kept

#define KEPT_OVER 1.0e30 // the t behind everything that is kept
#define KEPT_NONE -1.0   // begin and end of parts that there are not

struct Kept
{
  vec4 begin, end; // of up to four parts, in order
};

// The distances of a ray from the planes: at its origin, and per unit of t.
struct KeptPlanes
{
  vec3 lower, upper, slope;
};

KeptPlanes keptPlanes(vec3 origin, vec3 direction)
{
  vec4 at = vec4(origin, 1.0);
  return KeptPlanes(
    vec3(dot(croppingLower[0], at), dot(croppingLower[1], at), dot(croppingLower[2], at)),
    vec3(dot(croppingUpper[0], at), dot(croppingUpper[1], at), dot(croppingUpper[2], at)),
    vec3(dot(croppingLower[0].xyz, direction), dot(croppingLower[1].xyz, direction),
      dot(croppingLower[2].xyz, direction)));
}

bool keptAt(KeptPlanes planes, float t)
{
  vec3 region = step(-planes.lower, t * planes.slope) + step(-planes.upper, t * planes.slope);
  return (croppingRegions >> int(dot(region, vec3(1.0, 3.0, 9.0)) + 0.5) & 1) == 1;
}

// The first plane behind t.
float keptCrossing(vec3 heights, vec3 slope, float t, float end)
{
  vec3 safe = mix(slope, vec3(1.0), lessThan(abs(slope), vec3(1.0e-20)));
  vec3 at = mix(-heights / safe, vec3(KEPT_NONE), lessThan(abs(slope), vec3(1.0e-20)));
  at = mix(vec3(end), at, greaterThan(at, vec3(t)));
  return min(min(at.x, at.y), min(at.z, end));
}

// One of the seven pieces, from t on. Written out, not looped: iterations are what software renderers
// ration.
#define KEPT_PIECE                                                                                 \
  next = keptCrossing(planes.upper, planes.slope, t,                                               \
    keptCrossing(planes.lower, planes.slope, t, interval.y));                                      \
  if (t < next && keptAt(planes, 0.5 * (t + next)))                                                \
  {                                                                                                \
    count += count > 0 && kept.end[count - 1] == t ? 0 : 1;                                        \
    kept.begin[count - 1] = kept.end[count - 1] == t ? kept.begin[count - 1] : t;                  \
    kept.end[count - 1] = next;                                                                    \
  }                                                                                                \
  t = next;

// Of origin + t direction, 0 <= t <= span; local.
Kept keptOf(vec3 origin, vec3 direction, float span)
{
  vec2 interval = vec2(0.0, span);
#ifdef CLIPPING_PLANES
  interval = clippingInterval(origin, direction, interval);
#endif
  KeptPlanes planes = keptPlanes(origin, direction);
  Kept kept = Kept(vec4(KEPT_NONE), vec4(KEPT_NONE));
  int count = 0;
  float t = interval.x, next;
  KEPT_PIECE
  KEPT_PIECE
  KEPT_PIECE
  KEPT_PIECE
  KEPT_PIECE
  KEPT_PIECE
  KEPT_PIECE
  return kept;
}

// From the first t to the last.
vec2 keptHull(Kept kept)
{
  return vec2(kept.begin.x, max(max(kept.end.x, kept.end.y), max(kept.end.z, kept.end.w)));
}

// Here, or where the next part begins; KEPT_OVER if there is none.
float keptNext(Kept kept, float t)
{
  return t < kept.end.x ? max(t, kept.begin.x)
    : t < kept.end.y    ? max(t, kept.begin.y)
    : t < kept.end.z    ? max(t, kept.begin.z)
    : t < kept.end.w    ? max(t, kept.begin.w)
                        : KEPT_OVER;
}

// Where the part that t lies in ends.
float keptEnd(Kept kept, float t)
{
  return t < kept.end.x ? kept.end.x
    : t < kept.end.y    ? kept.end.y
    : t < kept.end.z    ? kept.end.z
                        : kept.end.w;
}

// Equal steps that fill each part.
struct KeptSteps
{
  vec4 begin, width;
  vec4 first; // the number of each part's first step
  int count;
};

KeptSteps keptSteps(Kept kept, float longest)
{
  vec4 span = kept.end - kept.begin;
  vec4 count = ceil(span / longest);
  vec4 first = vec4(0.0, count.x, count.x + count.y, count.x + count.y + count.z);
  return KeptSteps(kept.begin, span / max(count, 1.0), first, int(first.w + count.w));
}

// Where step i begins, and its width.
vec2 keptStep(KeptSteps steps, int i)
{
  float number = float(i);
  int part = number < steps.first.y ? 0 : number < steps.first.z ? 1 : number < steps.first.w ? 2 : 3;
  return vec2(
    steps.begin[part] + (number - steps.first[part]) * steps.width[part], steps.width[part]);
}

// The step that t lies in, or the first behind it; the number of steps behind the last.
int keptStepAt(KeptSteps steps, float t)
{
  vec4 counts = vec4(steps.first.yzw, float(steps.count)) - steps.first;
  vec4 before = clamp((vec4(t) - steps.begin) / max(steps.width, 1.0e-30), vec4(0.0), counts);
  return int(dot(before, vec4(1.0)));
}

// How many of so many steps may be taken as one: what lies between parts is not part of a step.
int keptJoined(int steps)
{
  return 1;
}
