// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Midpoint marching along a light ray, LIGHT_TAPS steps at a time: several look-ups an iteration keep a
// long march within the number of loop iterations that software renderers allow (see
// vtkMediumPlan::Capabilities).

// One of the LIGHT_TAPS look-ups of an iteration. Written out, not looped: Mesa does not unroll such a
// loop inside another, and counts its iterations too.
#if LIGHT_TAPS != 4
#error "LIGHT_TAPS look-ups are written out below; change both"
#endif
#define LIGHT_STEPS_TAP(k)                                                                         \
  part += contentExtinction(start + (segment.x + (float(k) + 0.5) * width) * along);

// The longest that LIGHT_TAPS steps may be together, so that each is at most lightStep. Where extinction
// is the same everywhere, one segment is exact, whatever its length, and looks nothing up.
#ifdef EXTINCTION_CONSTANT
#define LIGHT_STEPS_LONGEST 1.0e30
#define LIGHT_STEPS_LOOK_UPS 0
#else
#define LIGHT_STEPS_LONGEST (lightStep * float(LIGHT_TAPS))
#define LIGHT_STEPS_LOOK_UPS LIGHT_TAPS
#endif

// The optical depth of a segment (begin, width) of the ray; start and along in box coordinates.
SPECTRUM lightSteps(vec3 start, vec3 along, vec2 segment)
{
  float width = segment.y / float(LIGHT_TAPS);
  SPECTRUM part = SPECTRUM(0.0);
  LIGHT_STEPS_TAP(0)
  LIGHT_STEPS_TAP(1)
  LIGHT_STEPS_TAP(2)
  LIGHT_STEPS_TAP(3)
  COUNT(LIGHT_STEPS_LOOK_UPS);
  return part * width;
}

// The optical depth of segment i; i becomes the next segment that may have any. `asked` is until where it is
// known whether bricks are empty, 0 at first.
SPECTRUM lightStepsFrom(vec3 start, vec3 along, KeptSteps steps, inout int i, inout float asked)
{
  vec2 segment = keptStep(steps, i);
  SPECTRUM part = lightSteps(start, along, segment);
#ifdef TILES
  if (part == SPECTRUM(0.0))
  {
    i = emptyBricksNext(steps, i, segment.x, start + segment.x * along, along, asked);
    return part;
  }
#endif
  ++i;
  return part;
}
