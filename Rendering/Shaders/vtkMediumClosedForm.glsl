// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A homogeneous box in directional light, in closed form: no step, no texture of the medium. Along the eye
// ray, the way to a light leaves the box by one face after another. The lengths of the ways to the faces
// are linear, and so is the least of them but for the three places where two of them meet; between those
// the exponent of eye and light ray together is linear, whatever the optical depth.

#ifdef LIT
// Shorter than this, local units, a way to a face is rounding: the point is on the face. At large optical
// depths that is all that is seen.
#define CLOSED_FORM_ON_FACE 5.0e-7
#define CLOSED_FORM_NEVER 1.0e30

float closedFormWay(float at, float along)
{
  if (abs(along) < RAY_BOX_PARALLEL)
  {
    return CLOSED_FORM_NEVER;
  }
  float way = ((along > 0.0 ? 1.0 : 0.0) - at) / along;
  return way < CLOSED_FORM_ON_FACE ? 0.0 : way;
}

// Lengths of the ways from a point to the faces towards a light; box coordinates, local lengths.
vec3 closedFormWays(vec3 at, vec3 along)
{
  return vec3(closedFormWay(at.x, along.x), closedFormWay(at.y, along.y),
    closedFormWay(at.z, along.z));
}

// Where in 0...1 a linear function is 0, from its values at both ends; 1 where it is nowhere.
float closedFormRoot(float first, float last)
{
  return (first < 0.0) != (last < 0.0) ? first / (first - last) : 1.0;
}

// The mean, over the part a...b of the eye ray's 0...1, of what is left of a light on its way to the eye.
SPECTRUM closedFormPart(SPECTRUM depth, SPECTRUM extinction, vec3 first, vec3 last, float a, float b)
{
  vec3 begin = mix(first, last, a);
  vec3 end = mix(first, last, b);
  return (b - a) *
    segmentMeanTransmittance(a * depth + extinction * min(min(begin.x, begin.y), begin.z),
      b * depth + extinction * min(min(end.x, end.y), end.z));
}

// The same over the whole eye ray, `depth` its optical depth, towards a light in direction `along`.
SPECTRUM closedFormLight(EyeRay ray, SPECTRUM depth, SPECTRUM extinction, vec3 along)
{
  vec3 first = closedFormWays(frameBoxPoint(ray.origin), along);
  vec3 last = closedFormWays(frameBoxPoint(ray.origin + ray.span * ray.direction), along);
  vec3 apart = first - first.yzx;
  vec3 thenApart = last - last.yzx;
  float x = closedFormRoot(apart.x, thenApart.x);
  float y = closedFormRoot(apart.y, thenApart.y);
  float z = closedFormRoot(apart.z, thenApart.z);
  float least = min(min(x, y), z);
  float most = max(max(x, y), z);
  float middle = max(min(x, y), min(max(x, y), z));
  return closedFormPart(depth, extinction, first, last, 0.0, least) +
    closedFormPart(depth, extinction, first, last, least, middle) +
    closedFormPart(depth, extinction, first, last, middle, most) +
    closedFormPart(depth, extinction, first, last, most, 1.0);
}

// What the lights send to the eye, the mean over the ray; per local unit.
vec3 closedFormInScatter(EyeRay ray, SPECTRUM depth, Content content)
{
  vec3 sum = vec3(0.0);
  for (int number = firstLight; number < lastLight; ++number)
  {
    Light light = lightAt(number, ray.origin, ray.direction, ray.span);
    float phase = PHASE(phaseAngle(light.direction, ray.direction), content.anisotropy);
    sum += phase * light.irradiance *
      closedFormLight(ray, depth, content.extinction, frameBoxDirection(light.direction));
  }
  return content.scattering * sum;
}
#endif

void main()
{
  EyeRay ray = eyeRay();
  if (!(ray.span > 0.0))
  {
    discard;
  }
  FrameState state = frameBegin();
  state.rays = 1.0;
  Content content = contentAt(vec3(0.5));
  SPECTRUM depth = content.extinction * ray.span;
  // Emission belongs to the draws of the first lights, so that it is counted once.
  vec3 mean = firstLight == 0 ? segmentMeanTransmittance(depth) * content.emission : vec3(0.0);
#ifdef LIT
  mean += closedFormInScatter(ray, depth, content);
#endif
  outputSegment(ray.offset, ray.span, SPECTRUM(0.0), depth, ray.span * mean, state);
  state.alpha = 1.0 - SPECTRUM_MEAN(transmittance(depth));
  outputEnd(depth, state);
}
