// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BrickSetting.h"

//------------------------------------------------------------------------------
TEST(Bricks, AHotVoxelOnABorderOccupiesAllBricksItTouches)
{
  struct
  {
    glm::ivec3 Voxel;
    std::size_t Bricks;
  } cases[] = { { { 8, 8, 8 }, 8 }, { { 8, 4, 4 }, 2 }, { { 4, 16, 8 }, 4 }, { { 4, 4, 4 }, 1 },
    { { 0, 0, 0 }, 1 }, { { 24, 24, 24 }, 1 } };
  for (const auto& hot : cases)
  {
    const Setting setting = MakeSetting(
      MakeFilled(glm::ivec3(25), [&](const glm::ivec3& at) { return at == hot.Voxel ? 1 : 0; }));
    ASSERT_EQ(setting.Bricks.GetCount(), glm::ivec3(3));
    EXPECT_EQ(setting.Bricks.GetNumberOf(vtkMediumBricks::Mixed), hot.Bricks)
      << hot.Voxel.x << " " << hot.Voxel.y << " " << hot.Voxel.z;
    EXPECT_EQ(setting.Bricks.GetNumberOf(vtkMediumBricks::Empty), 27 - hot.Bricks);
  }
}

//------------------------------------------------------------------------------
TEST(Bricks, CheckerboardsAreMixedFromZeroToTheLargest)
{
  const Setting setting = MakeSetting(MakeFilled(
    { 20, 17, 9 }, [](const glm::ivec3& at) { return (at.x + at.y + at.z) % 2 ? 1 : 0; }));
  ASSERT_EQ(setting.Bricks.GetCount(), glm::ivec3(3, 2, 1));
  EXPECT_EQ(setting.Bricks.GetNumberOf(vtkMediumBricks::Mixed), 6u);
  EXPECT_EQ(setting.Bricks.GetRange({ 2, 1, 0 }), glm::vec2(0, setting.Grid.GetMaximum()));
}

//------------------------------------------------------------------------------
TEST(Bricks, ConstantDataAreUniformAndZeroIsEmpty)
{
  EXPECT_EQ(MakeSetting(MakeFilled(glm::ivec3(20), [](const glm::ivec3&) { return 0.3f; }))
              .Bricks.GetNumberOf(vtkMediumBricks::Uniform),
    27u);
  EXPECT_EQ(MakeSetting(MakeFilled(glm::ivec3(20), [](const glm::ivec3&) { return 0.0f; }))
              .Bricks.GetNumberOf(vtkMediumBricks::Empty),
    27u);
}

//------------------------------------------------------------------------------
TEST(Bricks, EmissionAloneIsNotEmpty)
{
  Setting setting = MakeSetting(MakeFilled(glm::ivec3(9), [](const glm::ivec3&) { return 0.0f; }));
  EXPECT_EQ(setting.Bricks.GetNumberOf(vtkMediumBricks::Empty), 1u);
  setting.Scene.Content.Emission.Scale = glm::dvec3(0, 1, 0);
  setting.Build();
  EXPECT_EQ(setting.Bricks.GetNumberOf(vtkMediumBricks::Empty), 0u);
}

//------------------------------------------------------------------------------
TEST(Bricks, ANewFunctionReclassifiesWithoutReadingVoxels)
{
  Setting setting = MakeSetting(MakeImage(Smooth, glm::ivec3(33)));
  EXPECT_EQ(setting.Bricks.GetNumberOfReads(), 1);
  const std::size_t before = Occupied(setting.Bricks);
  UseFunction(setting.Scene, [](double s) { return std::max(s - 0.6, 0.0); });
  setting.Build();
  EXPECT_EQ(setting.Bricks.GetNumberOfReads(), 1);
  const std::size_t after = Occupied(setting.Bricks);
  EXPECT_LT(after, before);
  EXPECT_GT(after, 0u);

  setting.Build();
  EXPECT_EQ(setting.Bricks.GetNumberOfReads(), 1);
  setting.Scene.Content.Fields[0].Array->Modified();
  setting.Build();
  EXPECT_EQ(setting.Bricks.GetNumberOfReads(), 2);
  EXPECT_EQ(Occupied(setting.Bricks), after);
}

//------------------------------------------------------------------------------
TEST(Bricks, RangesBoundWhatInterpolationGives)
{
  for (bool onCells : { false, true })
  {
    const auto image = MakeImage(Cloud, { 33, 21, 27 }, glm::dvec3(1), onCells);
    Setting setting = MakeSetting(image, onCells);
    for (bool wavy : { false, true })
    {
      if (wavy)
      {
        UseFunction(setting.Scene, Wavy);
        setting.Build();
        EXPECT_FALSE(setting.Grid.IsAffine());
      }
      for (std::uint32_t i = 0; i < 20000; ++i)
      {
        const glm::dvec3 box = RandomBox(i, 43);
        const glm::dvec3 lattice =
          setting.Grid.LocalToLattice(setting.Scene.Geometry.BoxToLocal(box));
        const glm::ivec3 brick = glm::clamp(
          glm::ivec3(glm::floor(lattice / 8.0)), glm::ivec3(0), setting.Bricks.GetCount() - 1);
        const glm::dvec3 lower = setting.Bricks.GetLower(brick);
        const glm::dvec3 upper = setting.Bricks.GetUpper(brick);
        ASSERT_TRUE(glm::all(glm::lessThanEqual(lower, lattice + 1e-9)));
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(upper, lattice - 1e-9)));
        const double value =
          setting.Scene.Evaluate(box).Extinction.x * setting.Scene.Geometry.Length;
        const glm::vec2 range = setting.Bricks.GetRange(brick);
        ASSERT_LE(range.x, value * (1 + 1e-6) + 1e-6); // ranges are rounded to float
        ASSERT_GE(range.y, value * (1 - 1e-6) - 1e-6);
      }
    }
  }
}

//------------------------------------------------------------------------------
TEST(CoefficientBounds, AreThoseOfAllValuesInTheInterval)
{
  vtkMediumScene scene = MakeScene(MakeImage(Smooth, glm::ivec3(5)), 1);
  UseFunction(scene, Wavy);
  vtkMediumCoefficientBounds bounds;
  bounds.Build(scene.Content, scene.Content.Extinction);
  for (std::uint32_t i = 0; i < 300; ++i)
  {
    const double a = 1.2 * Random(2 * i, 47) - 0.1; // beyond the function's range too
    const double b = a + std::pow(Random(2 * i + 1, 47), 4);
    glm::dvec2 expected(1e300, -1e300);
    constexpr int Steps = 20000;
    for (int step = 0; step <= Steps; ++step)
    {
      const double value = 10 * scene.Content.Functions[0].Evaluate(a + (b - a) * step / Steps).w;
      expected = { std::min(expected.x, value), std::max(expected.y, value) };
    }
    const glm::dvec2 range = bounds.Evaluate({ a, b });
    EXPECT_LE(range.x, expected.x + 1e-12);
    EXPECT_GE(range.y, expected.y - 1e-12);
    // The brute force may miss the extreme sample by one of its own steps: slope 240 at most.
    EXPECT_NEAR(range.x, expected.x, 240 * (b - a) / Steps + 1e-12);
    EXPECT_NEAR(range.y, expected.y, 240 * (b - a) / Steps + 1e-12);
  }
}
