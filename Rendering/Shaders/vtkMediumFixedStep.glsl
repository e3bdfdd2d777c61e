// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// FixedStep: midpoint marching along the eye ray with a closed form in each segment, and along a light
// ray from each midpoint. Second order in both steps where the medium is smooth.

#ifdef LIT
// Light scattered towards the eye per local unit at a point, by the lights of this draw.
vec3 fixedStepInScatter(vec3 point, vec3 direction, Content content)
{
  vec3 sum = vec3(0.0);
  for (int number = firstLight; number < lastLight; ++number)
  {
    Light light = lightAt(number, point);
    if (light.irradiance != vec3(0.0))
    {
      // cosTheta: the light travels along -light.direction, the eye is along -direction.
      float phase = PHASE(dot(light.direction, direction), content.anisotropy);
      sum += light.irradiance * phase * transmittance(lightRayOpticalDepth(point, light));
    }
  }
  return content.scattering * sum;
}
#endif

#ifdef OUTPUT_TRANSMITTANCE_DEPTH
// Keeps the t where the mean transmittance falls to depthTransmittance, as first and last hit. Inside
// the segment the optical depth grows linearly.
void fixedStepMarkDepth(
  float start, float width, SPECTRUM before, SPECTRUM depth, inout FrameState state)
{
  float entering = SPECTRUM_MEAN(transmittance(before));
  float leaving = SPECTRUM_MEAN(transmittance(before + depth));
  if (!frameHasHit(state) && leaving <= depthTransmittance)
  {
    float fraction = log(entering / depthTransmittance) / log(entering / leaving);
    state.first = state.last = start + clamp(fraction, 0.0, 1.0) * width;
  }
}
#endif

// One segment: constant coefficients and source, taken at its middle. Returns its optical depth.
SPECTRUM fixedStepSegment(
  EyeRay ray, float middle, float width, SPECTRUM depthBefore, inout FrameState state)
{
  vec3 point = ray.origin + middle * ray.direction;
  Content content = contentAt(frameBoxPoint(point));
  COUNT(1);
  SPECTRUM depth = content.extinction * width;
  vec3 source = firstLight == 0 ? content.emission : vec3(0.0);
#ifdef LIT
  if (content.scattering != vec3(0.0))
  {
    source += fixedStepInScatter(point, ray.direction, content);
  }
#endif
  vec3 gathered = transmittance(depthBefore) * segmentMeanTransmittance(depth) * width * source;
  state.radiance += gathered;
#ifdef OUTPUT_MEAN_DEPTH
  state.march.a += middle * dot(gathered, vec3(1.0));
#endif
#ifdef OUTPUT_TRANSMITTANCE_DEPTH
  fixedStepMarkDepth(middle - 0.5 * width, width, depthBefore, depth, state);
#else
  if (SPECTRUM_MEAN(depth) > 0.0)
  {
    state.first = frameHasHit(state) ? state.first : middle - 0.5 * width;
    state.last = middle + 0.5 * width;
  }
#endif
  return depth;
}

void main()
{
  EyeRay ray = eyeRay();
  float span = ray.interval.y - ray.interval.x;
  if (!(span > 0.0))
  {
    discard;
  }
  FrameState state = frameBegin();
  state.rays = 1.0;
  int steps = max(int(ceil(span / eyeStep)), 1);
  float width = span / float(steps);
  // Optical depths are summed in blocks, so that rounding does not build up over a long march.
  SPECTRUM blocks = SPECTRUM_OF(firstStep == 0 ? vec3(0.0) : state.march.rgb);
  SPECTRUM block = SPECTRUM(0.0);
  for (int i = firstStep; i < min(lastStep, steps); ++i)
  {
    SPECTRUM before = blocks + block;
    if (SPECTRUM_MEAN(transmittance(before)) < transmittanceThreshold ||
      (FIRST_HIT_ONLY && frameHasHit(state)))
    {
      break;
    }
    float middle = ray.interval.x + (float(i) + 0.5) * width;
    block += fixedStepSegment(ray, middle, width, before, state);
    if (i % 64 == 63)
    {
      blocks += block;
      block = SPECTRUM(0.0);
    }
  }
  SPECTRUM total = blocks + block;
  state.march = vec4(vec3(total), state.march.a);
  state.alpha = 1.0 - SPECTRUM_MEAN(transmittance(total));
#ifdef OUTPUT_TRANSMITTANCE
  state.radiance = vec3(transmittance(total));
#endif
#ifdef OUTPUT_OPTICAL_DEPTH
  state.radiance = vec3(total);
#endif
#ifdef OUTPUT_MEAN_DEPTH
  float weight = dot(state.radiance, vec3(1.0));
  state.first = state.last = weight > 0.0 ? state.march.a / weight : FRAME_NO_HIT;
#endif
  frameEnd(state);
}
