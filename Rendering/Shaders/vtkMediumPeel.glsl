// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A volume among the layers of translucent geometry that VTK's dual depth peeling takes off the scene. The
// pass (vtkDualDepthPeelingPass) puts its own code in place of its two tags below; that calls castRay at
// most twice, with the window depths between which it wants the medium, and blends what comes back. So the
// same code runs twice: first to note those depths, which end the rays of an integration each, then to hand
// over what was integrated. The names that begin with in_ and g_, initializeRayCast and castRay are the pass's.

in vec2 texCoord;
#define in_inverseWindowSize (texCoord / gl_FragCoord.xy)
const float g_opacityThreshold = 1.0;
int peelCasts = 0; // so far

//VTK::DepthPeeling::Dec

void initializeRayCast()
{
}

#ifdef PEEL_NOTES
// As a ray's ends are read (vtkMediumEyeRay): the far depth, and 1 - the near one. Empty to begin with.
vec4 peelPieces[2] = vec4[2](vec4(0.0, 0.0, 0.0, 1.0), vec4(0.0, 0.0, 0.0, 1.0));

vec4 castRay(float begin, float end)
{
  peelPieces[peelCasts++] = vec4(end, 0.0, 0.0, 1.0 - begin);
  return vec4(0.0);
}
#else
uniform sampler2D firstPiece;
uniform sampler2D secondPiece;

vec4 castRay(float begin, float end)
{
  return peelCasts++ == 0 ? texture(firstPiece, texCoord) : texture(secondPiece, texCoord);
}
#endif

void main()
{
  //VTK::CallWorker::Impl
#ifdef PEEL_NOTES
  gl_FragData[0] = peelPieces[0];
  gl_FragData[1] = peelPieces[1];
#endif
}
