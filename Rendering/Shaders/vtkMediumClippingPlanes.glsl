// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of a ray on the kept side of every clipping plane: half-spaces leave one interval.

uniform vec4 clippingPlanes[CLIPPING_PLANES_MOST]; // local: kept where dot(xyz, point) + w >= 0

// The part of an interval, (first, last) t, where height + t slope >= 0.
vec2 clippingPlane(vec2 interval, float height, float slope)
{
  if (abs(slope) < 1.0e-20)
  {
    return height < 0.0 ? vec2(interval.x) : interval;
  }
  float t = -height / slope;
  return slope > 0.0 ? vec2(max(interval.x, t), interval.y) : vec2(interval.x, min(interval.y, t));
}

// Written out, not looped: iterations are what software renderers ration.
#define CLIPPING_PLANE(n)                                                                          \
  if (n < CLIPPING_PLANES)                                                                         \
  {                                                                                                \
    vec4 plane = clippingPlanes[n];                                                                \
    interval = clippingPlane(                                                                      \
      interval, dot(plane.xyz, origin) + plane.w, dot(plane.xyz, direction));                      \
  }

vec2 clippingInterval(vec3 origin, vec3 direction, vec2 interval)
{
#if CLIPPING_PLANES_MOST != 16
#error "the planes are written out below; change both"
#endif
  CLIPPING_PLANE(0)
  CLIPPING_PLANE(1)
  CLIPPING_PLANE(2)
  CLIPPING_PLANE(3)
  CLIPPING_PLANE(4)
  CLIPPING_PLANE(5)
  CLIPPING_PLANE(6)
  CLIPPING_PLANE(7)
  CLIPPING_PLANE(8)
  CLIPPING_PLANE(9)
  CLIPPING_PLANE(10)
  CLIPPING_PLANE(11)
  CLIPPING_PLANE(12)
  CLIPPING_PLANE(13)
  CLIPPING_PLANE(14)
  CLIPPING_PLANE(15)
  return interval;
}
