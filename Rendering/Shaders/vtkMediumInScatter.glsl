// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Light scattered towards the eye at a point: what the lights of this draw send there, weakened by the
// medium on its way, turned by the phase function. Per local unit.

#ifdef LIT
vec3 inScatter(vec3 point, vec3 direction, Content content)
{
  vec3 sum = vec3(0.0);
  for (int number = firstLight; number < lastLight; ++number)
  {
    Light light = lightAt(number, point);
    if (light.irradiance != vec3(0.0))
    {
      float phase = PHASE(phaseAngle(light.direction, direction), content.anisotropy);
      vec3 unshadowed = light.irradiance * phase;
#ifdef LIGHT_CACHE_ROUGHNESS
      vec3 worth = content.scattering * unshadowed;
      lightImportance = lightSourceWeight * max(max(worth.r, worth.g), worth.b);
#endif
      sum += unshadowed * lightTransmittance(number, point, light);
    }
  }
  return content.scattering * sum;
}
#endif

// Emission belongs to the draws of the first lights, so that it is counted once.
vec3 sourceAt(vec3 point, vec3 direction, Content content)
{
  vec3 source = firstLight == 0 ? content.emission : vec3(0.0);
#ifdef LIT
  if (content.scattering != vec3(0.0))
  {
    source += inScatter(point, direction, content);
  }
#endif
  return source;
}
