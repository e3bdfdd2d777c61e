// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The numbers of phase functions that have more than one lobe, and the table of a tabulated one.

uniform vec4 phaseLobes; // g of the second lobe, weight of the first, Draine's alpha, unused
uniform sampler2D phaseTable;

float phaseTabulated(vec2 angle)
{
  float size = float(textureSize(phaseTable, 0).x);
  return texture(phaseTable, vec2((phaseTableCoordinate(angle, size) + 0.5) / size, 0.5)).r;
}
