// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shows an integrated frame in the window: premultiplied radiance, or a distance as grey.

in vec2 texCoord; // 0...1 over the viewport
uniform sampler2D radiance;
uniform sampler2D hits;
uniform float distanceScale;   // grey = (t - nearest) scaled; 0: show radiance
uniform float distanceNearest; // local units
uniform bool showFirst;        // else the distance from the first to the last point

void main()
{
  ivec2 pixel = ivec2(texCoord * vec2(textureSize(radiance, 0)));
  if (distanceScale == 0.0)
  {
    gl_FragData[0] = texelFetch(radiance, pixel, 0);
    return;
  }
  vec4 hit = texelFetch(hits, pixel, 0);
  if (hit.x <= -1.0e30) // vtkMediumFrame::NoHit
  {
    discard;
  }
  float grey = showFirst ? 1.0 - (hit.x - distanceNearest) * distanceScale
                         : (hit.y - hit.x) * distanceScale;
  gl_FragData[0] = vec4(vec3(clamp(grey, 0.0, 1.0)), 1.0);
}
