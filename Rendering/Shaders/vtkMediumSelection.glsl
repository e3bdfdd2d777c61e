// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shows a vtkHardwareSelector the colours and depths that vtkMediumSelection found.

in vec2 texCoord; // 0...1 over the viewport
uniform sampler2D selected; // colour and window depth; depth < 0: not the medium's

void main()
{
  vec4 texel = texelFetch(selected, ivec2(texCoord * vec2(textureSize(selected, 0))), 0);
  if (texel.a < 0.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(texel.rgb, 1.0);
  gl_FragDepth = texel.a;
}
