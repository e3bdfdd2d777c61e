// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What a march leaves behind, by output: radiance always, and one of three meanings of hits.

// Takes a segment of the eye ray into the frame: `before` and `depth` are the optical depths in front of
// it and of it, `gathered` is the radiance that it sends to the eye, t counts from the eye.
void outputSegment(float t, float width, SPECTRUM before, SPECTRUM depth, vec3 gathered,
  inout FrameState state)
{
  state.radiance += gathered;
#if defined(OUTPUT_MEAN_DEPTH)
  // The running mean of t, weighted by the light.
  float weight = dot(gathered, vec3(1.0));
  if (weight > 0.0)
  {
    float middle = t + 0.5 * width;
    float share = weight / dot(state.radiance, vec3(1.0));
    state.first = state.last = frameHasHit(state) ? mix(state.last, middle, share) : middle;
  }
#elif defined(OUTPUT_TRANSMITTANCE_DEPTH)
  // Inside the segment the optical depth grows linearly.
  float entering = SPECTRUM_MEAN(transmittance(before));
  float leaving = SPECTRUM_MEAN(transmittance(before + depth));
  if (!frameHasHit(state) && leaving <= depthTransmittance)
  {
    float fraction = log(entering / depthTransmittance) / log(entering / leaving);
    state.first = state.last = t + clamp(fraction, 0.0, 1.0) * width;
  }
#else
  if (SPECTRUM_MEAN(depth) > 0.0)
  {
    state.first = frameHasHit(state) ? state.first : t;
    state.last = t + width;
  }
#endif
}

// Whether the march may stop behind this optical depth.
bool outputIsOver(SPECTRUM depth, FrameState state)
{
  return SPECTRUM_MEAN(transmittance(depth)) < transmittanceThreshold ||
    (FIRST_HIT_ONLY && frameHasHit(state));
}

// Writes the state of a march that has passed this optical depth.
void outputEnd(SPECTRUM depth, FrameState state)
{
#if defined(OUTPUT_TRANSMITTANCE)
  state.radiance = vec3(transmittance(depth));
#elif defined(OUTPUT_OPTICAL_DEPTH)
  state.radiance = vec3(depth);
#endif
  state.radiance = max(state.radiance, 0.0); // prefiltered light caches undershoot a little
  frameEnd(state);
}
