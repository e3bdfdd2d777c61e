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
  state.radiance += transmittance(depthBefore) * segmentMeanTransmittance(depth) * width * source;
  if (SPECTRUM_MEAN(depth) > 0.0)
  {
    state.first = frameHasHit(state) ? state.first : middle - 0.5 * width;
    state.last = middle + 0.5 * width;
  }
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
  state.march = vec4(vec3(total), 0.0);
  state.alpha = 1.0 - SPECTRUM_MEAN(transmittance(total));
  frameEnd(state);
}
