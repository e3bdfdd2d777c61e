// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Light scattered towards the eye by a segment of its ray, or at a point (width 0): what the lights of this
// draw send there, weakened by the medium on its way, turned by the phase function. Per local unit.

#ifdef LIT
// Light from a near lamp comes from `ahead` of the segment's middle and has so much more of the segment to
// pass on its way to the eye. Where more than an optical depth of 1 lies between, the step resolves nothing.
SPECTRUM inScatterPassing(float ahead, Content content)
{
  return transmittance(max(content.extinction * ahead, -1.0));
}

// From one light, without the scattering coefficient.
vec3 inScatterFrom(int number, vec3 middle, vec3 direction, float width, Content content)
{
  Light light = lightAt(number, middle, direction, width);
  vec3 inScattered = vec3(0.0);
  if (light.irradiance != vec3(0.0))
  {
    float phase = PHASE(phaseAngle(light.direction, direction), content.anisotropy);
    vec3 unshadowed = light.irradiance * phase;
#ifdef POSITIONAL_LIGHTS
    unshadowed *= inScatterPassing(dot(light.point - middle, direction), content);
#endif
#ifdef LIGHT_CACHE_ROUGHNESS
    vec3 worth = content.scattering * unshadowed;
    lightImportance = lightSourceWeight * max(max(worth.r, worth.g), worth.b);
#endif
    inScattered = unshadowed * lightTransmittance(number, light.point, light);
    //VTK::Medium::InScatter::Impl
  }
  return inScattered;
}

vec3 inScatter(vec3 middle, vec3 direction, float width, Content content)
{
#ifdef ONE_LIGHT
  return content.scattering * inScatterFrom(0, middle, direction, width, content);
#else
  vec3 sum = vec3(0.0);
  for (int number = firstLight; number < lastLight; ++number)
  {
    sum += inScatterFrom(number, middle, direction, width, content);
  }
  return content.scattering * sum;
#endif
}
#endif

// Emission belongs to the draws of the first lights, so that it is counted once.
vec3 sourceAt(vec3 middle, vec3 direction, float width, Content content)
{
  vec3 source = firstLight == 0 ? content.emission : vec3(0.0);
#ifdef LIT
  if (content.scattering != vec3(0.0))
  {
    source += inScatter(middle, direction, width, content);
  }
#endif
  return source;
}
