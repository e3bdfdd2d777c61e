// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What every integrator shares: the volume's place, the steps, the part of the frame that this draw
// integrates, and the values that are carried from draw to draw and written at the end.

uniform mat3 localToBoxAxes; // local to box coordinates
uniform vec3 localToBoxOrigin;
uniform float eyeStep;   // local units
uniform float lightStep; // local units
uniform float transmittanceThreshold;
uniform float depthTransmittance; // where the Depth output marks the depth
uniform int firstLight, lastLight; // the lights of this draw, [first, last)
uniform int firstStep, lastStep;   // the eye steps of this draw, [first, last)

#ifdef CARRY_STATE
uniform sampler2D carriedRadiance;
uniform sampler2D carriedHits;
uniform sampler2D carriedMarch;
#endif

vec3 frameBoxPoint(vec3 local)
{
  return localToBoxAxes * local + localToBoxOrigin;
}

vec3 frameBoxDirection(vec3 local)
{
  return localToBoxAxes * local;
}

#define FRAME_NO_HIT -1.0e30 // vtkMediumFrame::NoHit
#define FRAME_UNFINISHED 0.5  // vtkMediumFrame::Unfinished

struct FrameState
{
  vec3 radiance;
  float alpha;    // 1 - mean transmittance
  float first;    // t of the first point of the medium, local units; FRAME_NO_HIT: none yet
  float last;     // t of the last point of the medium
  float taps;     // look-ups so far
  float rays;     // times that the eye ray was integrated; FRAME_UNFINISHED until its march is over
  vec4 march;     // what the integrator needs to go on; a: what its look-ups of light may err by
};

#ifdef COUNT_TAPS
float frameTaps = 0.0;
#define COUNT(n) frameTaps += float(n)
#else
#define COUNT(n)
#endif

bool frameHasHit(FrameState state)
{
  return state.first > FRAME_NO_HIT;
}

// Whether this draw goes on from the one before.
#ifdef ONLY_ROUGH
#define FRAME_CARRIES true
#else
#define FRAME_CARRIES (firstStep > 0 || firstLight > 0)
#endif

FrameState frameBegin()
{
#ifdef CARRY_STATE
  if (FRAME_CARRIES)
  {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 radiance = texelFetch(carriedRadiance, pixel, 0);
    vec4 hits = texelFetch(carriedHits, pixel, 0);
    vec4 march = texelFetch(carriedMarch, pixel, 0);
    return FrameState(radiance.rgb, radiance.a, hits.x, hits.y, hits.z, hits.w, march);
  }
#endif
  return FrameState(vec3(0.0), 0.0, FRAME_NO_HIT, FRAME_NO_HIT, 0.0, 0.0, vec4(0.0));
}

void frameEnd(FrameState state)
{
#ifdef COUNT_TAPS
  state.taps += frameTaps;
#endif
  gl_FragData[0] = vec4(state.radiance, state.alpha);
  gl_FragData[1] = vec4(state.first, state.last, state.taps, state.rays);
#ifdef CARRY_STATE
  gl_FragData[2] = state.march;
#endif
}
