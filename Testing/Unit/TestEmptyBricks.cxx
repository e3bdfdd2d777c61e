// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BrickSetting.h"

#include "vtkMediumEmptyBricks.h"

namespace
{
// By looking at all bricks.
int BruteForceReach(const vtkMediumBricks& bricks, const glm::ivec3& from)
{
  int reach = vtkMediumEmptyBricks::Farthest;
  const glm::ivec3 count = bricks.GetCount();
  for (int z = 0; z < count.z; ++z)
  {
    for (int y = 0; y < count.y; ++y)
    {
      for (int x = 0; x < count.x; ++x)
      {
        const glm::ivec3 to(x, y, z), apart = glm::abs(to - from);
        if (bricks.GetClass(to) != vtkMediumBricks::Empty)
        {
          reach = std::min(reach, std::max(apart.x, std::max(apart.y, apart.z)));
        }
      }
    }
  }
  return reach;
}

void ExpectBruteForce(const vtkMediumBricks& bricks)
{
  vtkMediumEmptyBricks empty;
  empty.Build(bricks);
  const glm::ivec3 count = bricks.GetCount();
  for (int i = 0; i < count.x * count.y * count.z; ++i)
  {
    const glm::ivec3 brick(i % count.x, i / count.x % count.y, i / (count.x * count.y));
    ASSERT_EQ(empty.GetReaches()[bricks.GetIndex(brick)], BruteForceReach(bricks, brick))
      << brick.x << ' ' << brick.y << ' ' << brick.z;
  }
}
}

//------------------------------------------------------------------------------
TEST(EmptyBricks, ReachesAreThoseFoundByLookingAtAllBricks)
{
  for (Fields field : { Cloud, Binary })
  {
    for (bool onCells : { false, true })
    {
      ExpectBruteForce(
        MakeSetting(MakeImage(field, { 90, 61, 77 }, glm::dvec3(1), onCells), onCells).Bricks);
    }
  }
}

//------------------------------------------------------------------------------
TEST(EmptyBricks, AHotVoxelEndsTheReachOnAllSides)
{
  const glm::ivec3 hot(44, 12, 60);
  ExpectBruteForce(MakeSetting(MakeFilled({ 97, 33, 81 }, [&](const glm::ivec3& at) {
    return at == hot ? 1.0f : 0.0f;
  })).Bricks);
}

//------------------------------------------------------------------------------
TEST(EmptyBricks, NothingAnywhereReachesAsFarAsIsTold)
{
  const Setting setting =
    MakeSetting(MakeFilled(glm::ivec3(20), [](const glm::ivec3&) { return 0.0f; }));
  vtkMediumEmptyBricks empty;
  empty.Build(setting.Bricks);
  for (unsigned char reach : empty.GetReaches())
  {
    EXPECT_EQ(reach, vtkMediumEmptyBricks::Farthest);
  }
}
