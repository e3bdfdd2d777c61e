// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The paper's searches in the 0/1 volume (Han, Ki and Oh, section 4.2): a linear search brackets a
// surface, a binary search refines it.

uniform float paperThreshold; // of the field's texel

bool paperFilled(vec3 box)
{
  COUNT(1);
#ifdef MASK
  if (MASK(box) < 0.5)
  {
    return false;
  }
#endif
  return fieldTexel(0, box).r >= paperThreshold;
}

// One halving of the bracket (a, b), where the volume is `filled` at b and not at a, or the reverse.
// Written out, not looped: iterations are what software renderers ration.
#define PAPER_HALVE(n)                                                                             \
  if (n < BINARY_SEARCH_ITERATIONS)                                                                \
  {                                                                                                \
    float middle = 0.5 * (a + b);                                                                  \
    bool past = paperFilled(start + middle * along) == filled;                                     \
    a = past ? a : middle;                                                                         \
    b = past ? middle : b;                                                                         \
  }

float paperBisect(vec3 start, vec3 along, float a, float b, bool filled)
{
  PAPER_HALVE(0)
  PAPER_HALVE(1)
  PAPER_HALVE(2)
  PAPER_HALVE(3)
  PAPER_HALVE(4)
  PAPER_HALVE(5)
  PAPER_HALVE(6)
  PAPER_HALVE(7)
  PAPER_HALVE(8)
  PAPER_HALVE(9)
  return 0.5 * (a + b);
}
