// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The part of a grid that is not empty, and the grid with half its points.
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFixtures.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace
{
using namespace vtkMediumFixtures;

const glm::ivec3 Points(13, 9, 11);
const glm::dvec3 Size(1.3, 0.4, 2);
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, KnowsThePartThatIsNotEmpty)
{
  const auto image = MakeImage(Smooth, Points, Size);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  values->Fill(0);
  vtkMediumExtinctionGrid grid;
  grid.Build(MakeScene(image, 5, false));
  EXPECT_TRUE(grid.GetOccupiedPart().IsEmpty());
  for (const glm::ivec3& at : { glm::ivec3(2, 8, 3), glm::ivec3(7, 1, 10) })
  {
    values->SetTuple1(at.x + Points.x * (at.y + Points.y * at.z), 1);
  }
  values->Modified();
  grid.Build(MakeScene(image, 5, false));
  EXPECT_EQ(grid.GetOccupiedPart().Begin, glm::ivec3(2, 1, 3));
  EXPECT_EQ(grid.GetOccupiedPart().End, glm::ivec3(8, 9, 11));
  const vtkMediumLatticePart grown = grid.GetOccupiedPart().Grow(2, Points);
  EXPECT_EQ(grown.Begin, glm::ivec3(0, 0, 1));
  EXPECT_EQ(grown.End, glm::ivec3(10, 9, 11));
}

//------------------------------------------------------------------------------
// A linear field is its own mean off the faces; the box stays where it is.
TEST(ExtinctionGrid, HalvesItsPointsAlongEachAxis)
{
  for (bool onCells : { false, true })
  {
    for (const glm::ivec3& points : { Points, glm::ivec3(12, 7, 6), glm::ivec3(2, 3, 2) })
    {
      const auto image = MakeImage(Smooth, points, Size, onCells);
      vtkDataArray* values =
        onCells ? image->GetCellData()->GetScalars() : image->GetPointData()->GetScalars();
      const glm::ivec3 n = onCells ? points - 1 : points;
      for (int i = 0; i < n.x * n.y * n.z; ++i)
      {
        values->SetTuple1(i, 1 + 0.1 * (i % n.x) + 0.2 * (i / n.x % n.y) + 0.05 * (i / n.x / n.y));
      }
      vtkMediumExtinctionGrid fine, coarse;
      fine.Build(MakeScene(image, 5, onCells));
      coarse.BuildCoarser(fine);
      EXPECT_EQ(coarse.GetDimensions(), glm::max((n + 1) / 2, glm::min(n, 2)));
      for (const auto face :
        { &vtkMediumExtinctionGrid::GetLower, &vtkMediumExtinctionGrid::GetUpper })
      {
        const glm::dvec3 apart =
          coarse.LatticeToLocal((coarse.*face)()) - fine.LatticeToLocal((fine.*face)());
        EXPECT_LT(glm::length(apart), 1e-12);
      }
      const glm::ivec3 inside = coarse.GetDimensions() - 2;
      for (int i = 0; i < std::max(inside.x, 0) * std::max(inside.y, 0) * std::max(inside.z, 0);
           ++i)
      {
        const glm::ivec3 at(
          1 + i % inside.x, 1 + i / inside.x % inside.y, 1 + i / inside.x / inside.y);
        const double expected = fine.Interpolate(fine.LocalToLattice(coarse.LatticeToLocal(at)));
        EXPECT_NEAR(
          coarse.GetValues()[coarse.GetIndex(at.x, at.y, at.z)], expected, 1e-2 * expected);
      }
    }
  }
}
