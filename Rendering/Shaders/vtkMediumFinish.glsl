// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The user's last word on the colour of an integrated frame, where its rays met the medium.

in vec2 texCoord; // 0...1 over the viewport
uniform sampler2D radiance;
uniform sampler2D hits;
uniform float worldLength; // world units in a local unit

void main()
{
  ivec2 pixel = ivec2(texCoord * vec2(textureSize(radiance, 0)));
  vec4 color = texelFetch(radiance, pixel, 0);
  vec4 hit = texelFetch(hits, pixel, 0);
  if (hit.x > -1.0e30) // vtkMediumFrame::NoHit
  {
    float first = hit.x * worldLength;
    float last = hit.y * worldLength;
    //VTK::Medium::Color::Impl
  }
  gl_FragData[0] = color;
  gl_FragData[1] = hit;
}
