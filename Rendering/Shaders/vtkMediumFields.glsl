// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The arrays of the input as 3D textures. A texel is scaled to 0...1 over the array's range.

#if FIELD_COUNT > 0
uniform sampler3D fields[FIELD_COUNT];
uniform vec3 fieldScale[FIELD_COUNT]; // box to what foldPlace takes
uniform vec3 fieldBias[FIELD_COUNT];
FOLD(fieldFolds[FIELD_COUNT])
uniform float fieldTexelScale[FIELD_COUNT]; // the texture's value to that
uniform float fieldMinimum[FIELD_COUNT]; // the value of a texel of 0, in the field's unit
uniform float fieldRange[FIELD_COUNT];   // the value of a texel of 1, less that

#ifdef COARSE_FILTER
// Trilinear interpolation in float, where the device's filter rounds its weights (to 1/256 on GPUs).
vec4 fieldInterpolate(sampler3D field, vec3 coordinate)
{
  vec3 size = vec3(textureSize(field, 0));
  vec3 at = clamp(coordinate * size - 0.5, vec3(0.0), size - 1.0);
  ivec3 low = ivec3(at);
  ivec3 high = min(low + 1, ivec3(size) - 1);
  vec3 f = at - vec3(low);
  vec4 z0 = mix(
    mix(texelFetch(field, low, 0), texelFetch(field, ivec3(high.x, low.yz), 0), f.x),
    mix(texelFetch(field, ivec3(low.x, high.y, low.z), 0),
      texelFetch(field, ivec3(high.xy, low.z), 0), f.x), f.y);
  vec4 z1 = mix(
    mix(texelFetch(field, ivec3(low.xy, high.z), 0),
      texelFetch(field, ivec3(high.x, low.y, high.z), 0), f.x),
    mix(texelFetch(field, ivec3(low.x, high.yz), 0), texelFetch(field, high, 0), f.x), f.y);
  return mix(z0, z1, f.z);
}
#else
#define fieldInterpolate texture
#endif

// Macros, because GLSL 1.50 wants the number of a texture to be a constant.
#define fieldPlace(number, box)                                                                    \
  foldPlace(fieldFolds[number], (box) * fieldScale[number] + fieldBias[number])
#define fieldTexel(number, box)                                                                    \
  (fieldInterpolate(fields[number], fieldPlace(number, box)) * fieldTexelScale[number])
// Of a mask: its texel, whose border is that of its voxel.
#define fieldNearest(number, box)                                                                  \
  (texture(fields[number], fieldPlace(number, box)).r * fieldTexelScale[number])
#define fieldValue(number, box) (fieldTexel(number, box) * fieldRange[number] + fieldMinimum[number])
#endif
