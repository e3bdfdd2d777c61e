// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Leaps through empty bricks (vtkMediumEmptyBricks). A ray goes on where its steps would: what is left out
// are steps without extinction or emission, so that the picture is the same.

uniform sampler3D emptyBricks; // a brick's reach, of 255
uniform vec3 boxToBricksScale, boxToBricksBias;
uniform vec3 lastBrick; // indices
FOLD(emptyBricksFold)
uniform float eyeLeapsFrom; // t from which eye rays ask; never, where asking costs more than it spares

// Until where a ray need not ask again, from a point of it on, in lengths of its direction: x where it leaves
// the empty bricks around the point, 0 if the point's brick is not empty; y where it leaves either. Both in
// box coordinates.
vec2 emptyBricksAhead(vec3 point, vec3 direction)
{
  COUNT(1);
  vec3 at = point * boxToBricksScale + boxToBricksBias;
  vec3 brick = clamp(floor(at), vec3(0.0), lastBrick);
  float reach = floor(texelFetch(emptyBricks, foldTexel(emptyBricksFold, brick), 0).r * 255.0 + 0.5);
  float around = max(reach, 1.0);
  vec3 speed = direction * boxToBricksScale;
  vec3 faces = brick + mix(vec3(1.0 - around), vec3(around), greaterThan(speed, vec3(0.0)));
  bvec3 still = lessThan(abs(speed), vec3(1.0e-20));
  vec3 ahead = mix((faces - at) / mix(speed, vec3(1.0), still), vec3(1.0e30), still);
  float leaves = max(min(ahead.x, min(ahead.y, ahead.z)), 0.0);
  return vec2(reach > 0.0 ? leaves : 0.0, leaves);
}

// The step after step i, which met nothing at t: the next, or that in which the ray leaves the empty bricks
// around the point. `asked` is until where their reach is known.
int emptyBricksNext(KeptSteps steps, int i, float t, vec3 point, vec3 direction, inout float asked)
{
  if (t < asked)
  {
    return i + 1;
  }
  vec2 ahead = emptyBricksAhead(point, direction);
  asked = t + ahead.y;
  return max(i + 1, keptStepAt(steps, t + ahead.x));
}
