// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumFold.h"

#include <cstdint>
#include <limits>

namespace
{
//------------------------------------------------------------------------------
std::int64_t Product(const glm::ivec3& v)
{
  return static_cast<std::int64_t>(v.x) * v.y * v.z;
}

//------------------------------------------------------------------------------
std::int64_t Quotient(std::int64_t dividend, std::int64_t divisor) // rounded up
{
  return (dividend + divisor - 1) / divisor;
}
}

//------------------------------------------------------------------------------
vtkMediumFold::vtkMediumFold(const glm::ivec3& dimensions, int limit)
  : Dimensions(dimensions)
{
  const std::vector<Cut> x = FindCuts(dimensions.x, limit);
  const std::vector<Cut> y = FindCuts(dimensions.y, limit);
  const std::vector<Cut> z = FindCuts(dimensions.z, limit);
  vtkMediumFold best;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const Cut& alongX : x)
  {
    for (const Cut& alongY : y)
    {
      for (const Cut& alongZ : z)
      {
        if (this->Place({ alongX, alongY, alongZ }, limit) && Product(this->GetSize()) < least)
        {
          best = *this;
          least = Product(this->GetSize());
        }
      }
    }
  }
  *this = best;
  this->Dimensions = dimensions;
}

//------------------------------------------------------------------------------
// What an axis may be cut into: nothing, or blocks of which a number fits beside one another.
std::vector<vtkMediumFold::Cut> vtkMediumFold::FindCuts(int count, int limit)
{
  std::vector<Cut> cuts;
  if (count <= limit)
  {
    const int extent = std::max(count, 1);
    cuts.push_back({ 1, extent - 1, extent });
    return cuts;
  }
  for (int beside = 1; beside <= MostBeside && limit / beside > 1; ++beside)
  {
    const int longest = limit / beside - 1; // but for the layer that is repeated
    const int blocks = static_cast<int>(Quotient(count - 1, longest));
    const int stride = static_cast<int>(Quotient(count - 1, blocks));
    cuts.push_back({ blocks, stride, stride + 1 });
  }
  return cuts;
}

//------------------------------------------------------------------------------
// False if there is no room.
bool vtkMediumFold::Place(const Cut (&cuts)[3], int limit)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Blocks[axis] = cuts[axis].Blocks;
    this->Stride[axis] = cuts[axis].Stride;
    this->Extent[axis] = cuts[axis].Extent;
  }
  const glm::ivec3 room = limit / this->Extent;
  const std::int64_t blocks = Product(this->Blocks);
  if (Product(room) < blocks)
  {
    return false;
  }
  this->Beside.z = static_cast<int>(Quotient(blocks, static_cast<std::int64_t>(room.x) * room.y));
  this->Beside.y =
    static_cast<int>(Quotient(blocks, static_cast<std::int64_t>(room.x) * this->Beside.z));
  this->Beside.x =
    static_cast<int>(Quotient(blocks, static_cast<std::int64_t>(this->Beside.y) * this->Beside.z));
  return true;
}

//------------------------------------------------------------------------------
bool vtkMediumFold::operator==(const vtkMediumFold& other) const
{
  return this->Dimensions == other.Dimensions && this->Blocks == other.Blocks &&
    this->Stride == other.Stride && this->Beside == other.Beside;
}

//------------------------------------------------------------------------------
glm::ivec3 vtkMediumFold::Fold(const glm::ivec3& value) const
{
  const glm::ivec3 block = glm::min(value / glm::max(this->Stride, 1), this->Blocks - 1);
  const int number = block.x + this->Blocks.x * (block.y + this->Blocks.y * block.z);
  const glm::ivec3 place(number % this->Beside.x, number / this->Beside.x % this->Beside.y,
    number / (this->Beside.x * this->Beside.y));
  return place * this->Extent + value - block * this->Stride;
}

//------------------------------------------------------------------------------
glm::ivec3 vtkMediumFold::Unfold(const glm::ivec3& texel) const
{
  const glm::ivec3 place = texel / this->Extent;
  const int number = place.x + this->Beside.x * (place.y + this->Beside.y * place.z);
  const glm::ivec3 block(number % this->Blocks.x, number / this->Blocks.x % this->Blocks.y,
    number / (this->Blocks.x * this->Blocks.y)); // beyond the last along z where there is none
  if (block.z >= this->Blocks.z)
  {
    return this->Dimensions;
  }
  return block * this->Stride + texel - place * this->Extent;
}
