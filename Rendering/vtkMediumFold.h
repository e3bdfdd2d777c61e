// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumFold
 * @brief How a lattice lies in one 3D texture, in blocks where an axis is longer than the device allows.
 *
 * An axis that is too long is cut into blocks, which lie beside one another along whatever axes have room.
 * A block begins with the layer of values with which the one before it ends, so that the values around any
 * point lie in one block, and a device's own filter interpolates between them. A lattice within the
 * device's limit is one block, as it is.
 */
#ifndef vtkMediumFold_h
#define vtkMediumFold_h

#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumFold
{
public:
  /// Blocks beside one another along an axis that is cut, at most: thinner ones repeat too many values.
  static constexpr int MostBeside = 16;

  vtkMediumFold() = default;
  /// The smallest texture for a lattice of `dimensions` values, of at most `limit` along each axis.
  vtkMediumFold(const glm::ivec3& dimensions, int limit);

  /// Whether there is such a texture.
  bool IsPossible() const { return this->Blocks.x > 0; }
  bool IsFolded() const { return this->Blocks.x > 1 || this->Blocks.y > 1 || this->Blocks.z > 1; }
  bool operator==(const vtkMediumFold& other) const;

  /// Of the lattice: values along each axis.
  const glm::ivec3& GetDimensions() const { return this->Dimensions; }
  /// Of the texture: texels along each axis.
  glm::ivec3 GetSize() const { return this->Beside * this->Extent; }
  /// Blocks into which each axis is cut.
  const glm::ivec3& GetBlocks() const { return this->Blocks; }
  /// Texels along each axis of a block.
  const glm::ivec3& GetExtent() const { return this->Extent; }
  /// Values from the beginning of a block to that of the next.
  const glm::ivec3& GetStride() const { return this->Stride; }
  /// Places for blocks along each axis of the texture; they are filled in order of x, y, z.
  const glm::ivec3& GetBeside() const { return this->Beside; }

  /// The texel of a value; of the two of a layer that is repeated, that which begins a block.
  glm::ivec3 Fold(const glm::ivec3& value) const;
  /// The value of a texel; beyond the lattice, in a component, where the texel holds none.
  glm::ivec3 Unfold(const glm::ivec3& texel) const;
  /// The values of a lattice, x fastest, as texels; those that hold none are 0.
  template <typename Value>
  std::vector<Value> Fold(std::vector<Value> values, int components) const;

private:
  struct Cut
  {
    int Blocks = 0, Stride = 0, Extent = 0;
  };
  static std::vector<Cut> FindCuts(int count, int limit);
  bool Place(const Cut (&cuts)[3], int limit);

  glm::ivec3 Dimensions{ 0 };
  glm::ivec3 Blocks{ 0 };
  glm::ivec3 Stride{ 0 };
  glm::ivec3 Extent{ 0 };
  glm::ivec3 Beside{ 0 };
};

//------------------------------------------------------------------------------
template <typename Value>
std::vector<Value> vtkMediumFold::Fold(std::vector<Value> values, int components) const
{
  if (!this->IsFolded())
  {
    return values;
  }
  const glm::ivec3 size = this->GetSize(), n = this->Dimensions;
  std::vector<Value> texels(static_cast<std::size_t>(size.x) * size.y * size.z * components);
  for (int z = 0; z < size.z; ++z)
  {
    for (int y = 0; y < size.y; ++y)
    {
      for (int x = 0; x < size.x; x += this->Extent.x)
      {
        const glm::ivec3 first = this->Unfold({ x, y, z });
        if (first == glm::min(first, n - 1)) // else nothing of this row is in the lattice
        {
          const std::size_t from =
            first.x + n.x * (first.y + static_cast<std::size_t>(n.y) * first.z);
          const std::size_t to = x + size.x * (y + static_cast<std::size_t>(size.y) * z);
          const std::size_t count = std::min(this->Extent.x, n.x - first.x);
          std::copy_n(
            values.data() + from * components, count * components, texels.data() + to * components);
        }
      }
    }
  }
  return texels;
}

#endif
