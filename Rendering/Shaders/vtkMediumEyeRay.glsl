// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The eye ray of a pixel, from the rows of the camera's matrix (see vtkMediumScene::View): right for
// any projection, perspective or parallel, on or off axis.

in vec2 texCoord;          // 0...1 over the viewport
uniform vec2 viewportSize; // pixels
uniform vec3 eyeOrigin, eyeOriginX, eyeOriginY;
uniform vec3 eyeDirection, eyeDirectionX, eyeDirectionY;
uniform vec4 clipZ, clipW; // rows of the local-to-clip matrix
uniform sampler2D opaqueDepth;
#ifdef TILES
uniform sampler2D tiles; // for each square of pixels, the first and last t at which its rays meet a brick
#endif

// The part of the ray inside the volume, after the near plane and before opaque geometry. Its origin is
// where it starts, so that positions along it stay exact however far the eye is.
struct EyeRay
{
  vec3 origin;    // local
  vec3 direction; // local, unit
  float span;     // local units; <= 0: nothing to see
  float offset;   // from the eye to the origin
};

// Where the ray has the normalised depth z (-1 near plane, 1 far plane): solves clipZ.p = z clipW.p.
float eyeRayAtDepth(vec3 origin, vec3 direction, float z)
{
  float numerator = dot(clipZ.xyz, origin) + clipZ.w - z * (dot(clipW.xyz, origin) + clipW.w);
  return numerator / (z * dot(clipW.xyz, direction) - dot(clipZ.xyz, direction));
}

EyeRay eyeRay()
{
  vec2 pixel = floor(texCoord * viewportSize) + 0.5; // its exact centre
  vec2 at = pixel / viewportSize * 2.0 - 1.0;
  vec3 origin = eyeOrigin + at.x * eyeOriginX + at.y * eyeOriginY;
  vec3 direction = normalize(eyeDirection + at.x * eyeDirectionX + at.y * eyeDirectionY);
  vec2 interval = rayBox(frameBoxPoint(origin), frameBoxDirection(direction));
  interval.x = max(interval.x, eyeRayAtDepth(origin, direction, -1.0));
  float depth = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  if (depth < 1.0)
  {
    interval.y = min(interval.y, eyeRayAtDepth(origin, direction, depth * 2.0 - 1.0));
  }
#ifdef TILES
  vec2 tile = texelFetch(tiles, ivec2(pixel) / TILES, 0).rg;
  interval = vec2(max(interval.x, tile.x), min(interval.y, tile.y));
#endif
  return EyeRay(
    origin + interval.x * direction, direction, interval.y - interval.x, interval.x);
}
