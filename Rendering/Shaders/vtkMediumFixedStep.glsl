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

#ifndef TILES
#define eyeLeapsFrom 0.0
#endif
// The step after step i, which had an optical depth.
int fixedStepNext(EyeRay ray, KeptSteps steps, int i, SPECTRUM depth, inout float asked)
{
#ifdef TILES
  if (depth == SPECTRUM(0.0))
  {
    vec2 segment = keptStep(steps, i);
    float middle = segment.x + 0.5 * segment.y;
    return emptyBricksNext(steps, i, middle, frameBoxPoint(ray.origin + middle * ray.direction),
      frameBoxDirection(ray.direction), asked);
  }
#endif
  return i + 1;
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
  int i = firstStep;
  float asked = eyeLeapsFrom;
  while (i < min(lastStep, steps.count) && !outputIsOver(blocks + block, state))
  {
    vec2 segment = keptStep(steps, i);
    SPECTRUM depth = fixedStepSegment(ray, segment, blocks + block, state);
    block += depth;
    if (i % 64 == 63)
    {
      blocks += block;
      block = SPECTRUM(0.0);
    }
    i = fixedStepNext(ray, steps, i, depth, asked);
  }
  SPECTRUM total = blocks + block;
  state.march = vec4(vec3(total), 0.0);
  state.alpha = 1.0 - SPECTRUM_MEAN(transmittance(total));
  outputEnd(total, state);
}
