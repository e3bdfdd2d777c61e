// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The arrays of the input as 3D textures, each scaled to 0...1 over its range.

#if FIELD_COUNT > 0
uniform sampler3D fields[FIELD_COUNT];
uniform vec3 fieldScale[FIELD_COUNT]; // box to texture coordinates
uniform vec3 fieldBias[FIELD_COUNT];
uniform float fieldMinimum[FIELD_COUNT]; // the value of a texel of 0
uniform float fieldRange[FIELD_COUNT];   // the value of a texel of 1, less that

// Macros, because GLSL 1.50 wants the number of a texture to be a constant.
#define fieldTexel(number, box) texture(fields[number], (box) * fieldScale[number] + fieldBias[number])
#define fieldValue(number, box) (fieldTexel(number, box) * fieldRange[number] + fieldMinimum[number])
#endif
