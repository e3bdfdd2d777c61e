// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "LightCacheSetting.h"

//------------------------------------------------------------------------------
TEST(LightMarch, HomogeneousBoxGivesSigmaTimesLength)
{
  vtkMediumScene scene = MakeScene(MakeImage(Smooth, Points, Size), 1);
  scene.Content.Fields.clear();
  scene.Content.Extinction.Source = vtkMediumScene::Coefficient::Constant;
  scene.Content.Extinction.Scale = glm::dvec3(Sigma);
  vtkMediumExtinctionGrid grid;
  grid.Build(scene);
  // From the far face back to the near one along the longest edge, which has length 1.
  EXPECT_NEAR(vtkMediumLightOpticalDepth(grid, MakeDirectional({ 1, 0, 0 }), { 1, 0.5, 0.5 }),
    Sigma, 1e-6 * Sigma);
  // A point light one quarter of that edge away.
  const Light light = MakePoint(grid.LatticeToLocal({ 0.75, 0.5, 0.5 }));
  EXPECT_NEAR(vtkMediumLightOpticalDepth(grid, light, { 1, 0.5, 0.5 }), Sigma / 4, 1e-6 * Sigma);
}

//------------------------------------------------------------------------------
TEST(LightMarch, OpticalDepthsAddUpAlongARay)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Cloud);
  for (std::uint32_t i = 0; i < 50; ++i)
  {
    const glm::dvec3 a = glm::dvec3(Points) * (0.5 + RandomDirection(i, 3));
    const glm::dvec3 b = glm::dvec3(Points) * (0.5 + RandomDirection(i, 4));
    const glm::dvec3 middle = glm::mix(a, b, Random(i, 5));
    const double whole = vtkMediumOpticalDepth(grid, a, b);
    EXPECT_NEAR(vtkMediumOpticalDepth(grid, a, middle) + vtkMediumOpticalDepth(grid, middle, b),
      whole, 1e-12 * (1 + whole));
    EXPECT_NEAR(vtkMediumOpticalDepth(grid, b, a), whole, 1e-12 * (1 + whole));
  }
}

//------------------------------------------------------------------------------
TEST(LightStencil, EqualsTheExactMarchForAllDirections)
{
  for (Fields field : { Smooth, Cloud, Binary })
  {
    const vtkMediumExtinctionGrid grid = MakeGrid(field);
    for (const glm::dvec3& direction : Directions())
    {
      ExpectStencilEqualsMarch(grid, direction);
    }
  }
}

//------------------------------------------------------------------------------
TEST(LightStencil, EqualsTheExactMarchOnCellArraysUpToTheFaces)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Smooth, true);
  for (const glm::dvec3& direction : Directions())
  {
    ExpectStencilEqualsMarch(grid, direction);
  }
}

//------------------------------------------------------------------------------
TEST(LightStencil, EqualsTheExactMarchForNearestValues)
{
  for (bool onCells : { false, true })
  {
    vtkMediumScene scene = MakeScene(MakeImage(Binary, Points, Size, onCells), Sigma, onCells);
    scene.Content.Fields[0].Linear = false;
    vtkMediumExtinctionGrid grid;
    grid.Build(scene);
    // Away from directions in which rays run along the borders between values, where both are right.
    for (std::uint32_t i = 0; i < 8; ++i)
    {
      ExpectStencilEqualsMarch(grid, RandomDirection(i, 19));
    }
  }
}

//------------------------------------------------------------------------------
TEST(LightStencil, EqualsTheExactMarchInShearedBoxes)
{
  const glm::dmat3 axes(0.03, 0, 0, 0.011, 0.04, 0, -0.02, 0.01, -0.05);
  vtkMediumExtinctionGrid grid;
  grid.Build(MakeScene(MakeImage(Cloud, Points), Sigma, false, axes));
  for (const glm::dvec3& direction : Directions())
  {
    ExpectStencilEqualsMarch(grid, direction);
  }
}

//------------------------------------------------------------------------------
TEST(LightStencil, WorksOnASingleLayerOfCells)
{
  const auto image = MakeImage(Smooth, { 9, 2, 2 }, Size, true);
  vtkMediumExtinctionGrid grid;
  grid.Build(MakeScene(image, Sigma, true));
  for (const glm::dvec3& direction : Directions())
  {
    ExpectStencilEqualsMarch(grid, direction);
  }
}

//------------------------------------------------------------------------------
TEST(LightStencil, ReachLeavesOutOnlyWhatIsPromisedToBeUnused)
{
  const vtkMediumExtinctionGrid grid = MakeGrid(Binary);
  vtkMediumLightStencil stencil;
  stencil.Build(grid, glm::normalize(glm::dvec3(1, -2, 0.5)));
  std::vector<float> all, some;
  stencil.Apply(grid, -1, all);
  stencil.Apply(grid, 2, some);
  std::size_t skipped = 0;
  for (int k = 0; k < Points.z; ++k)
  {
    for (int j = 0; j < Points.y; ++j)
    {
      for (int i = 0; i < Points.x; ++i)
      {
        bool near = false;
        for (int c = 0; c < 125 && !near; ++c)
        {
          const glm::ivec3 at = glm::ivec3(i, j, k) + glm::ivec3(c % 5, c / 5 % 5, c / 25) - 2;
          near = glm::clamp(at, glm::ivec3(0), Points - 1) == at &&
            grid.GetValues()[grid.GetIndex(at.x, at.y, at.z)] > 0;
        }
        const std::size_t index = grid.GetIndex(i, j, k);
        if (near)
        {
          ASSERT_EQ(some[index], all[index]);
        }
        skipped += some[index] == vtkMediumLightStencil::Unknown ? 1 : 0;
      }
    }
  }
  EXPECT_GT(skipped, 0u) << "nothing was left out, so this test shows nothing";
}
