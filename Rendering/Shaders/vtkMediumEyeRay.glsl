// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The eye ray of a pixel, from the rows of the camera's matrix (see vtkMediumScene::View): right for
// any projection, perspective or parallel, on or off axis.

in vec2 texCoord;          // 0...1 over the viewport
uniform vec2 viewportSize; // rays
uniform vec3 eyeOrigin, eyeOriginX, eyeOriginY; // on the plane through the volume's centre, if before it
uniform vec3 eyeDirection, eyeDirectionX, eyeDirectionY;
uniform float eyeReach; // from the eye to that plane, in lengths of the direction
uniform vec4 nearPlane, farPlane; // clip w + z and w - z: > 0 between the planes
uniform sampler2D opaqueDepth; // red: where the rays end; 1 - alpha: where they begin, 0 in textures of depth
#ifdef TILES
uniform sampler2D tiles; // for each square of pixels, the first and last t at which its rays meet a brick
#endif

// The part of the ray inside the volume, from the first point to the last that is not cut away, after the
// near plane and before opaque geometry. Its origin is
// where it starts, so that positions along it stay exact however far the eye is.
struct EyeRay
{
  vec3 origin;    // local
  vec3 direction; // local, unit
  float span;     // local units; <= 0: nothing to see
  float offset;   // from the eye to the origin
};

// Where the ray has a window depth (0 near plane, 1 far plane), which is near / (near + far).
float eyeRayAtDepth(vec3 origin, vec3 direction, float depth)
{
  float towards = (1.0 - depth) * dot(nearPlane.xyz, direction) - depth * dot(farPlane.xyz, direction);
  vec4 point = vec4(origin, 1.0);
  return (depth * dot(farPlane, point) - (1.0 - depth) * dot(nearPlane, point)) / towards;
}

EyeRay eyeRay()
{
  vec2 pixel = floor(texCoord * viewportSize) + 0.5; // its exact centre
  vec2 at = pixel / viewportSize * 2.0 - 1.0;
  vec3 origin = eyeOrigin + at.x * eyeOriginX + at.y * eyeOriginY;
  vec3 along = eyeDirection + at.x * eyeDirectionX + at.y * eyeDirectionY;
  vec3 direction = normalize(along);
  float reach = eyeReach * length(along);
  vec2 interval = rayBox(frameBoxPoint(origin), frameBoxDirection(direction));
  // Several pixels of the window may share the ray.
  ivec2 texel = ivec2(pixel / viewportSize * vec2(textureSize(opaqueDepth, 0)));
  vec4 depths = texelFetch(opaqueDepth, texel, 0);
  interval.x = max(interval.x, eyeRayAtDepth(origin, direction, 1.0 - depths.a));
  if (depths.r < 1.0)
  {
    interval.y = min(interval.y, eyeRayAtDepth(origin, direction, depths.r));
  }
#ifdef TILES
  vec2 tile = texelFetch(tiles, ivec2(pixel) / TILES, 0).rg - reach;
  interval = vec2(max(interval.x, tile.x), min(interval.y, tile.y));
#endif
  origin += interval.x * direction;
  vec2 hull = keptHull(keptOf(origin, direction, interval.y - interval.x));
  return EyeRay(
    origin + hull.x * direction, direction, hull.y - hull.x, reach + interval.x + hull.x);
}
