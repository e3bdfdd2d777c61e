// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A lattice folded into one texture: each value is somewhere, neighbours are beside each other, and no
// texture is larger than it may be.
#include "vtkMediumFold.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
struct Lattice
{
  glm::ivec3 Dimensions;
  int Limit;
};

const Lattice Folded[] = {
  { { 40, 7, 6 }, 16 },
  { { 7, 40, 6 }, 16 },
  { { 6, 7, 40 }, 16 },
  { { 40, 1, 1 }, 16 },
  { { 17, 16, 7 }, 16 },
  { { 40, 20, 3 }, 16 }, // only where x is cut finer than it needs to be alone
  { { 40, 18, 3 }, 16 },
  { { 17, 17, 17 }, 32 }, // within the limit: as it is
  { { 9, 9, 2 }, 8 },
  { { 7, 2, 1 }, 3 },
  { { 4, 1, 1 }, 2 },
  { { 160, 4, 4 }, 16 },
  { { 1000, 3, 17 }, 64 },
};

template <typename Body>
void ForEach(const glm::ivec3& size, const Body& body)
{
  for (int z = 0; z < size.z; ++z)
  {
    for (int y = 0; y < size.y; ++y)
    {
      for (int x = 0; x < size.x; ++x)
      {
        body(glm::ivec3(x, y, z));
      }
    }
  }
}

std::size_t IndexOf(const glm::ivec3& at, const glm::ivec3& size)
{
  return at.x + size.x * (at.y + std::size_t(size.y) * at.z);
}

bool IsIn(const glm::ivec3& at, const glm::ivec3& size)
{
  return at == glm::clamp(at, glm::ivec3(0), size - 1);
}
}

//------------------------------------------------------------------------------
TEST(Fold, KeepsToTheLimitAndHoldsEachValue)
{
  for (const auto& [n, limit] : Folded)
  {
    SCOPED_TRACE(testing::Message() << n.x << 'x' << n.y << 'x' << n.z << " in " << limit);
    const vtkMediumFold fold(n, limit);
    ASSERT_TRUE(fold.IsPossible());
    EXPECT_EQ(fold.IsFolded(), n != glm::min(n, limit));
    const glm::ivec3 size = fold.GetSize();
    EXPECT_EQ(size, glm::min(size, limit));
    ForEach(n, [&](const glm::ivec3& value) {
      ASSERT_TRUE(IsIn(fold.Fold(value), size));
      ASSERT_EQ(fold.Unfold(fold.Fold(value)), value);
    });
  }
}

//------------------------------------------------------------------------------
// So that a device interpolates in one block what lies between any two layers.
TEST(Fold, TheNextValueAlongEachAxisIsInTheNextTexel)
{
  for (const auto& [n, limit] : Folded)
  {
    SCOPED_TRACE(testing::Message() << n.x << 'x' << n.y << 'x' << n.z << " in " << limit);
    const vtkMediumFold fold(n, limit);
    ForEach(n, [&, n = n](const glm::ivec3& value) {
      const glm::ivec3 upper = glm::min(value + 1, n - 1);
      const glm::ivec3 texel = fold.Fold(value) + upper - value;
      ASSERT_TRUE(IsIn(texel, fold.GetSize()));
      ASSERT_EQ(fold.Unfold(texel), upper);
    });
  }
}

//------------------------------------------------------------------------------
TEST(Fold, TexelsAreTheValuesAndElseZero)
{
  for (const auto& [n, limit] : Folded)
  {
    SCOPED_TRACE(testing::Message() << n.x << 'x' << n.y << 'x' << n.z << " in " << limit);
    const vtkMediumFold fold(n, limit);
    const glm::ivec3 size = fold.GetSize();
    for (int components : { 1, 3 })
    {
      std::vector<int> values(std::size_t(n.x) * n.y * n.z * components);
      std::iota(values.begin(), values.end(), 1);
      const std::vector<int> texels = fold.Fold(values, components);
      ASSERT_EQ(texels.size(), std::size_t(size.x) * size.y * size.z * components);
      ForEach(size, [&, n = n](const glm::ivec3& texel) {
        const glm::ivec3 value = fold.Unfold(texel);
        for (int c = 0; c < components; ++c)
        {
          ASSERT_EQ(texels[IndexOf(texel, size) * components + c],
            IsIn(value, n) ? values[IndexOf(value, n) * components + c] : 0);
        }
      });
    }
  }
}

//------------------------------------------------------------------------------
TEST(Fold, SmallTexturesRepeatFewLayers)
{
  EXPECT_EQ(vtkMediumFold({ 3, 4, 5 }, 16).GetSize(), glm::ivec3(3, 4, 5)) << "as it is";
  const vtkMediumFold fold({ 4000, 512, 512 }, 2048);
  const glm::dvec3 size(fold.GetSize());
  EXPECT_LT(size.x * size.y * size.z, 1.001 * 4000 * 512 * 512);
}

//------------------------------------------------------------------------------
TEST(Fold, IsRefusedWithoutRoom)
{
  for (const auto& [n, limit] : { Lattice{ { 17, 16, 16 }, 16 }, Lattice{ { 40, 40, 40 }, 16 },
         Lattice{ { 3, 4, 5 }, 0 }, Lattice{ { 3, 4, 5 }, 1 }, Lattice{ { 3, 4, 5 }, -1 } })
  {
    const vtkMediumFold fold(n, limit);
    EXPECT_FALSE(fold.IsPossible()) << n.x << " in " << limit;
    EXPECT_FALSE(fold.IsFolded());
    EXPECT_EQ(fold.GetDimensions(), n);
  }
}

//------------------------------------------------------------------------------
// A lattice of bricks, an eighth of the values along each axis, always has room where the values have.
TEST(Fold, CoarserLatticesHaveRoomToo)
{
  for (const auto& [n, limit] : Folded)
  {
    for (int divisor : { 2, 3, 8 })
    {
      EXPECT_TRUE(vtkMediumFold((n + divisor - 1) / divisor, limit).IsPossible()) << n.x << divisor;
    }
  }
}
