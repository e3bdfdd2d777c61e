// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Evaluates one formula for each pixel of the output. The formulas' own files come before this text.
// The numbers of the cases are those of GpuFormulas::Formula.

in vec2 texCoord; // 0...1 over the output
uniform vec2 outputSize;
uniform sampler2D arguments; // two texels, beside each other, for each evaluation
uniform int formula;

// A whole number up to 2^32 - 1 from its upper and lower 16 bits, which a float holds.
uint wholeNumber(vec2 halves)
{
  return uint(halves.x) * 65536u + uint(halves.y);
}

vec4 evaluate(vec4 a, vec4 b)
{
  switch (formula)
  {
    case 0:
      return vec4(phaseIsotropic());
    case 1:
      return vec4(phaseHenyeyGreenstein(a.xy, a.z));
    case 2:
      return vec4(phaseSchlick(a.xy, a.z));
    case 3:
      return vec4(phaseSchlickFromG(a.x));
    case 4:
      return vec4(phaseDoubleHenyeyGreenstein(a.xy, a.z, a.w, b.x));
    case 5:
      return vec4(phaseRayleigh(a.xy));
    case 6:
      return vec4(phaseDraine(a.xy, a.z, a.w));
    case 7:
      return vec4(phaseDroplets(a.xy, a.z, a.w, b.x, b.y));
    case 8:
      return vec4(phaseTableCoordinate(a.xy, a.z));
    case 9:
      return vec4(segmentMeanTransmittance(a.x), segmentMeanTransmittance(a.xyz));
    case 10:
      return vec4(transmittance(a.x), transmittance(a.xyz));
    case 11:
      return vec4(rayBox(a.xyz, b.xyz), 0.0, 0.0);
    case 12:
      return vec4(lightAttenuation(a.x, b.xyz));
    case 13:
      return vec4(lightSpot(a.x, a.y, a.z));
    case 14:
      return vec4(lightDirection(a.xyz, b.xyz), 0.0);
    case 15:
      return vec4(jitterOffset(wholeNumber(a.xy), wholeNumber(a.zw), wholeNumber(b.xy)));
    case 16:
      return vec4(phaseAngle(a.xyz, b.xyz), 0.0, 0.0);
    case 17:
      return vec4(lightSegment(a.xyz, b.xyz, a.w, b.w), 0.0, 0.0);
#if FIELD_COUNT > 0
    case 18:
      return fieldInterpolate(fields[0], foldPlace(fieldFolds[0], a.xyz));
#endif
  }
  return vec4(-1.0);
}

void main()
{
  ivec2 at = ivec2(texCoord * outputSize);
  vec4 a = texelFetch(arguments, ivec2(2 * at.x, at.y), 0);
  vec4 b = texelFetch(arguments, ivec2(2 * at.x + 1, at.y), 0);
  gl_FragData[0] = evaluate(a, b);
}
