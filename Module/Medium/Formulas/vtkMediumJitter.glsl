// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A pseudo-random offset for each pixel, equal on every driver and on the CPU because it is made of
// 32-bit integers. GLSL and C++ both compile this text; see vtkMediumFormulas.h.

// A bijective mixer of 32 bits with low bias (two rounds of xorshift and multiplication; the
// constants are those of lowbias32, C. Wellons, Prospecting for Hash Functions, 2018).
uint jitterMix(uint x)
{
  x = (x ^ (x >> 16u)) * 0x7feb352du;
  x = (x ^ (x >> 15u)) * 0x846ca68bu;
  return x ^ (x >> 16u);
}

// A number in [0, 1), a multiple of 2^-24, from a pixel's coordinates and a seed.
real jitterOffset(uint x, uint y, uint seed)
{
  uint mixed = jitterMix(x + jitterMix(y + jitterMix(seed + 0x9e3779b9u)));
  return real(mixed >> 8u) * real(1.0 / 16777216.0);
}
