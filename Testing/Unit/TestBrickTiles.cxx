// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BrickSetting.h"

//------------------------------------------------------------------------------
TEST(BrickTiles, NoSampleWithExtinctionIsOutside)
{
  const glm::dmat3 sheared(0.03, 0, 0, 0.011, 0.04, 0, -0.02, 0.01, -0.05);
  const auto points = MakeImage(Binary, { 33, 27, 40 });
  const auto cells = MakeImage(Binary, { 33, 27, 40 }, glm::dvec3(1), true);
  Setting settings[] = { MakeSetting(points), MakeSetting(cells, true), Setting() };
  settings[2].Scene = MakeScene(points, 10, false, sheared);
  settings[2].Build();
  const glm::dvec3 target(0.02, -0.03, 0.05);
  for (Setting& setting : settings)
  {
    for (bool parallel : { false, true })
    {
      setting.Scene.Eye = MakeView({ 0.7, 0.9, -1.1 }, target, parallel ? 0.4 : 0.3, parallel);
      EXPECT_GT(ExpectTilesCoverTheMedium(setting, 200, 150), 100);
    }
    // Close by with a wide view, so that bricks straddle the plane through the eye; and inside.
    setting.Scene.Eye = MakeView({ 0.1, 0.3, 0.2 }, { 0, 0.1, -0.3 }, 1.5, false);
    EXPECT_GT(ExpectTilesCoverTheMedium(setting, 200, 150), 100);
    for (std::uint32_t i = 0; i < 12; ++i)
    {
      const glm::dvec3 eye = setting.Scene.Geometry.BoxToLocal(RandomBox(i, 53));
      setting.Scene.Eye = MakeView(eye, eye + RandomDirection(i, 53), 0.4 + 0.2 * i, false);
      ExpectTilesCoverTheMedium(setting, 97, 61);
    }
  }
}

//------------------------------------------------------------------------------
TEST(BrickTiles, AreTightEnoughToBeWorthIt)
{
  Setting setting = MakeSetting(MakeFilled(
    glm::ivec3(65), [](const glm::ivec3& at) { return at == glm::ivec3(36, 36, 36) ? 1 : 0; }));
  setting.Scene.Eye = MakeView({ 0, 0, -2 }, glm::dvec3(0), 0.3, false);
  const vtkMediumBricks::Tiles tiles = setting.Bricks.ProjectToTiles(setting.Scene, 256, 256);
  int occupied = 0;
  const double edge = 8.0 / 64 / std::sqrt(3.0); // of a brick, local units
  for (const glm::vec2& range : tiles.Ranges)
  {
    if (range.x <= range.y)
    {
      ++occupied;
      EXPECT_LT(range.y - range.x, 2 * std::sqrt(3.0) * edge) << "near to far of a ball around it";
    }
  }
  // The brick is edge / (2 x 0.3 x 2) of the view wide: 2 tiles, with 1 for each cut border.
  EXPECT_GE(occupied, 4);
  EXPECT_LE(occupied, 25);
  EXPECT_LE(tiles.Scissor.z, 32);
  EXPECT_LE(tiles.Scissor.w, 32);
}

//------------------------------------------------------------------------------
TEST(BrickTiles, NothingInViewGivesAnEmptyScissor)
{
  Setting setting = MakeSetting(MakeImage(Binary, glm::ivec3(17)));
  setting.Scene.Eye = MakeView({ 0, 0, -2 }, { 0, 0, -3 }, 0.3, false); // looks away
  EXPECT_EQ(setting.Bricks.ProjectToTiles(setting.Scene, 64, 64).Scissor.z, 0);
  setting.Scene.Eye = MakeView({ 0, 0, -2 }, { 3, 0, -2 }, 0.3, false); // looks past
  const vtkMediumBricks::Tiles tiles = setting.Bricks.ProjectToTiles(setting.Scene, 64, 64);
  EXPECT_EQ(tiles.Scissor.z, 0);
  for (const glm::vec2& range : tiles.Ranges)
  {
    EXPECT_GT(range.x, range.y);
  }
}

//------------------------------------------------------------------------------
// What is cut away narrows the tiles, and what is kept is still covered.
TEST(BrickTiles, LeaveOutBricksThatAreCutAway)
{
  Setting setting = MakeSetting(MakeImage(Smooth, glm::ivec3(65)));
  setting.Scene.Eye = MakeView({ 0, 0.1, -2 }, glm::dvec3(0), 0.3, false);
  const vtkMediumBricks::Tiles whole = setting.Bricks.ProjectToTiles(setting.Scene, 128, 128);
  EXPECT_EQ(whole.CutAway, 0u);
  vtkMediumCut& cut = setting.Scene.Cut;
  cut.Planes.push_back({ glm::dvec3(1, 0, 0), -0.05 });
  const vtkMediumBricks::Tiles half = setting.Bricks.ProjectToTiles(setting.Scene, 128, 128);
  EXPECT_GT(half.CutAway, 200u); // of 512
  EXPECT_LT(half.Scissor.z, 0.7 * whole.Scissor.z);

  for (int axis = 0; axis < 3; ++axis) // regions as well: the octant below is left
  {
    cut.Lower[axis].Normal = cut.Upper[axis].Normal = glm::dvec3(0);
    cut.Lower[axis].Normal[axis] = cut.Upper[axis].Normal[axis] = 1;
    cut.Lower[axis].Offset = 0.03;
    cut.Upper[axis].Offset = -0.05;
  }
  cut.Planes.clear();
  cut.Regions = 1 | 1 << 26; // and the one above
  const vtkMediumBricks::Tiles corners = setting.Bricks.ProjectToTiles(setting.Scene, 128, 128);
  EXPECT_GT(corners.CutAway, 300u);
  for (std::uint32_t i = 0; i < 20000; ++i)
  {
    const glm::dvec3 at = setting.Scene.Geometry.BoxToLocal(RandomBox(i, 7));
    const glm::dvec4 clip = setting.Scene.Eye.LocalToClip * glm::dvec4(at, 1);
    const glm::dvec2 pixel = 64.0 * (glm::dvec2(clip) / clip.w + 1.0);
    if (!cut.Keeps(at) || glm::clamp(pixel, 0.0, 128.0) != pixel)
    {
      continue;
    }
    const glm::ivec2 tile(pixel / double(corners.Edge));
    const glm::vec2 range = corners.Ranges[tile.x + corners.Count.x * tile.y];
    ASSERT_LE(range.x, glm::length(at - setting.Scene.Eye.Origin));
    ASSERT_GE(range.y, glm::length(at - setting.Scene.Eye.Origin));
  }
}
