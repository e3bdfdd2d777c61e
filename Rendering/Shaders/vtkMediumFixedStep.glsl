// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// FixedStep: midpoint marching along the eye ray with a closed form in each segment, and along a light
// ray from each midpoint. Second order in both steps where the medium is smooth.

// One segment (begin, width): constant coefficients and source, taken at its middle. Returns its optical
// depth.
SPECTRUM fixedStepSegment(EyeRay ray, vec2 segment, SPECTRUM before, inout FrameState state)
{
  float width = segment.y;
  float middle = segment.x + 0.5 * width;
  vec3 point = ray.origin + middle * ray.direction;
  Content content = contentAt(frameBoxPoint(point));
  COUNT(FIELD_COUNT > 0 ? 1 : 0);
  SPECTRUM depth = content.extinction * width;
  SPECTRUM weight = transmittance(before) * segmentMeanTransmittance(depth);
#ifdef LIGHT_CACHE_ROUGHNESS
  lightSourceWeight = weight;
#endif
  vec3 gathered = weight * width * sourceAt(point, ray.direction, width, content);
  outputSegment(ray.offset + segment.x, width, before, depth, gathered, state);
  return depth;
}

void main()
{
  EyeRay ray = eyeRay();
  if (!(ray.span > 0.0))
  {
    discard;
  }
  FrameState state = frameBegin();
  state.rays = 1.0;
  KeptSteps steps = keptSteps(keptOf(ray.origin, ray.direction, ray.span), eyeStep);
  // Optical depths are summed in blocks, so that rounding does not build up over a long march.
  SPECTRUM blocks = SPECTRUM_OF(firstStep == 0 ? vec3(0.0) : state.march.rgb);
  SPECTRUM block = SPECTRUM(0.0);
  for (int i = firstStep; i < min(lastStep, steps.count); ++i)
  {
    SPECTRUM before = blocks + block;
    if (outputIsOver(before, state))
    {
      break;
    }
    block += fixedStepSegment(ray, keptStep(steps, i), before, state);
    if (i % 64 == 63)
    {
      blocks += block;
      block = SPECTRUM(0.0);
    }
  }
  SPECTRUM total = blocks + block;
  state.march = vec4(vec3(total), 0.0);
  state.alpha = 1.0 - SPECTRUM_MEAN(transmittance(total));
  outputEnd(total, state);
}
