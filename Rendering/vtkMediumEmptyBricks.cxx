// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumEmptyBricks.h"

#include <glm/common.hpp>

#include <algorithm>

namespace
{
/// A brick's neighbours that come before it in order of index; those behind it are their opposites.
constexpr int Before = 13;

//------------------------------------------------------------------------------
glm::ivec3 NeighbourBefore(int number)
{
  return { number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1 };
}
}

//------------------------------------------------------------------------------
void vtkMediumEmptyBricks::Build(const vtkMediumBricks& bricks)
{
  const glm::ivec3 count = bricks.GetCount();
  const int number = count.x * count.y * count.z;
  this->Reaches.assign(number, Farthest);
  for (int pass : { 1, -1 }) // in order of index, and against it
  {
    for (int i = 0; i < number; ++i)
    {
      const int index = pass > 0 ? i : number - 1 - i;
      const glm::ivec3 brick(
        index % count.x, index / count.x % count.y, index / (count.x * count.y));
      int reach = this->Reaches[index];
      for (int k = 0; k < Before; ++k)
      {
        const glm::ivec3 other = brick + pass * NeighbourBefore(k);
        if (other == glm::clamp(other, glm::ivec3(0), count - 1))
        {
          reach = std::min(reach, this->Reaches[bricks.GetIndex(other)] + 1);
        }
      }
      const bool empty = bricks.GetClass(brick) == vtkMediumBricks::Empty;
      this->Reaches[index] = static_cast<unsigned char>(empty ? reach : 0);
    }
  }
}
