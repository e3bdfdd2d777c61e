// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The part of a ray inside the unit box. GLSL and C++ both compile this text; see
// vtkMediumFormulas.h.

// A direction component below this never crosses the box (t would exceed 1e30) and counts as zero;
// some GPUs flush denormals to zero in a division but not in a comparison.
#define RAY_BOX_PARALLEL real(1.0e-30)

// The interval of one axis. A direction component of zero is a branch of its own: 1/0 times an
// origin on the face would be NaN.
vec2 rayBoxAxis(real origin, real direction)
{
  if (abs(direction) < RAY_BOX_PARALLEL)
  {
    bool inside = origin >= real(0.0) && origin <= real(1.0);
    return inside ? vec2(-3.0e38, 3.0e38) : vec2(3.0e38, -3.0e38);
  }
  real a = -origin / direction;
  real b = (real(1.0) - origin) / direction;
  return vec2(min(a, b), max(a, b));
}

// (first, last) t of origin + t direction in [0,1]^3; the ray misses the box where first >= last.
vec2 rayBox(vec3 origin, vec3 direction)
{
  vec2 x = rayBoxAxis(origin.x, direction.x);
  vec2 y = rayBoxAxis(origin.y, direction.y);
  vec2 z = rayBoxAxis(origin.z, direction.z);
  return vec2(max(max(x.x, y.x), z.x), min(min(x.y, y.y), z.y));
}
