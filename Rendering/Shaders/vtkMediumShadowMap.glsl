// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The shadows that opaque geometry casts into the medium: the depth of the nearest surface as each light
// sees it, in views side by side in one texture. Four depths around a point are compared and the answers
// interpolated, so that a shadow's edge is as wide as a texel.

uniform sampler2DShadow shadowMap;
uniform sampler2D shadowViews; // a row for each face of each light: the rows of local to texture coordinates

// Of a cube around a light, the face that the way from it goes through; any, if there is one view only.
int shadowMapFace(vec3 way)
{
  vec3 size = abs(way);
  if (size.x >= size.y && size.x >= size.z)
  {
    return way.x > 0.0 ? 0 : 1;
  }
  return size.y >= size.z ? (way.y > 0.0 ? 2 : 3) : (way.z > 0.0 ? 4 : 5);
}

// The part of a light that is not blocked on its way to a point; `way` is the vector from it to the point.
float shadowMapLit(int number, vec3 point, vec3 way)
{
  int row = 6 * number + shadowMapFace(way);
  vec4 at = vec4(point, 1.0);
  float w = dot(texelFetch(shadowViews, ivec2(3, row), 0), at);
  if (!(w > 0.0))
  {
    return 1.0; // no view: there is no medium
  }
  vec3 place = vec3(dot(texelFetch(shadowViews, ivec2(0, row), 0), at),
    dot(texelFetch(shadowViews, ivec2(1, row), 0), at),
    dot(texelFetch(shadowViews, ivec2(2, row), 0), at)) / w;
  return textureLod(shadowMap, place, 0.0);
}
