// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shows an integrated frame in the window: premultiplied radiance, or another output as grey.

in vec2 texCoord; // 0...1 over the viewport
uniform sampler2D radiance;
uniform sampler2D coarserRadiance; // the same frame in steps of twice the length
uniform sampler2D hits;
uniform int shown; // vtkMediumFrame::Shown::Content
uniform float nearest; // the value shown as 0...
uniform float scale;   // ...and 1 / (the value shown as 1, less that)

#define SHOW_RADIANCE 0
#define SHOW_TRANSMITTANCE 1
#define SHOW_OPTICAL_DEPTH 2
#define SHOW_FIRST_HIT 3
#define SHOW_DISTANCE 4
#define SHOW_ERROR 6

void main()
{
  ivec2 pixel = ivec2(texCoord * vec2(textureSize(radiance, 0)));
  if (shown == SHOW_RADIANCE)
  {
    gl_FragData[0] = texture(radiance, texCoord); // between rays that are some pixels apart, too
    return;
  }
  vec4 light = texelFetch(radiance, pixel, 0);
  vec4 hit = texelFetch(hits, pixel, 0);
  bool distances = shown == SHOW_FIRST_HIT || shown == SHOW_DISTANCE;
  if (hit.w == 0.0 || (distances && hit.x <= -1.0e30)) // vtkMediumFrame::NoHit
  {
    discard;
  }
  vec3 grey = vec3((hit.z - nearest) * scale);
  vec3 change = abs(light.rgb - texelFetch(coarserRadiance, pixel, 0).rgb);
  grey = shown == SHOW_ERROR ? change / 3.0 * scale : grey;
  grey = shown == SHOW_TRANSMITTANCE ? light.rgb : grey;
  grey = shown == SHOW_OPTICAL_DEPTH ? 1.0 - exp(-light.rgb) : grey;
  grey = shown == SHOW_FIRST_HIT ? vec3(1.0 - (hit.x - nearest) * scale) : grey;
  grey = shown == SHOW_DISTANCE ? vec3((hit.y - hit.x) * scale) : grey;
  gl_FragData[0] = vec4(clamp(grey, 0.0, 1.0), 1.0);
}
