// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "BrickSetting.h"

//------------------------------------------------------------------------------
namespace
{
// Distance from a lattice coordinate to the nearest cell that may hold medium, by looking at all.
double BruteForceDistance(const glm::dvec3& at, const std::vector<glm::ivec3>& occupiedCells)
{
  double nearest = 1e300;
  for (const glm::ivec3& cell : occupiedCells)
  {
    const glm::dvec3 to = glm::clamp(at, glm::dvec3(cell), glm::dvec3(cell + 1)) - at;
    nearest = std::min(nearest, glm::dot(to, to));
  }
  return std::sqrt(nearest);
}

double InterpolateDistance(
  const vtkMediumEmptyDistance& distance, const vtkMediumExtinctionGrid& grid, const glm::dvec3& at)
{
  const glm::ivec3 cell(at);
  double value = 0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 bit(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 w = glm::mix(1.0 - glm::fract(at), glm::fract(at), glm::dvec3(bit));
    value += w.x * w.y * w.z *
      distance.GetValues()[grid.GetIndex(cell.x + bit.x, cell.y + bit.y, cell.z + bit.z)];
  }
  return value;
}
}

//------------------------------------------------------------------------------
TEST(EmptyDistance, InterpolatedValuesNeverLeapIntoTheMedium)
{
  const glm::ivec3 points(24, 19, 27);
  const std::function<double(double)> functions[] = { [](double s) { return s; },
    [](double s) { return std::max(0.1 - std::abs(s - 0.5), 0.0); } };
  for (Fields field : { Cloud, Binary })
  {
    for (const auto& function : functions)
    {
      Setting setting = MakeSetting(MakeImage(field, points));
      UseFunction(setting.Scene, function);
      setting.Build();
      vtkMediumEmptyDistance distance;
      distance.Build(setting.Scene, setting.Grid, setting.Bricks);
      ASSERT_TRUE(distance.CanLeap());

      // A cell holds medium if its scalars span a value with extinction: between 0.4 and 0.6 for the
      // peak, above 0 for the ramp; the table of the function spreads the peak by one interval.
      std::vector<glm::ivec3> occupied, atMost;
      const vtkMediumField& scalars = setting.Scene.Content.Fields[0];
      for (int c = 0; c < (points.x - 1) * (points.y - 1) * (points.z - 1); ++c)
      {
        const glm::ivec3 cell(c % (points.x - 1), c / (points.x - 1) % (points.y - 1),
          c / (points.x - 1) / (points.y - 1));
        double least = 1, largest = 0;
        for (int corner = 0; corner < 8; ++corner)
        {
          const double value = scalars.GetValue(
            cell.x + (corner & 1), cell.y + (corner >> 1 & 1), cell.z + (corner >> 2));
          least = std::min(least, value);
          largest = std::max(largest, value);
        }
        const bool ramp = &function == &functions[0];
        if (ramp ? largest > 0 : largest > 0.4 && least < 0.6)
        {
          occupied.push_back(cell);
        }
        const double spread = 1.0 / vtkMediumFunction::DefaultIntervals;
        if (ramp ? largest > 0 : largest > 0.4 - spread && least < 0.6 + spread)
        {
          atMost.push_back(cell);
        }
      }
      int leaps = 0;
      for (std::uint32_t i = 0; i < 1500; ++i)
      {
        const glm::dvec3 at = RandomBox(i, 59) * glm::dvec3(points - 1) * 0.999;
        const double exact = BruteForceDistance(at, occupied);
        const double value = InterpolateDistance(distance, setting.Grid, at);
        ASSERT_LE(value, exact + 1e-6);
        // No looser than the two halves of a cell's diagonal and the rounding take.
        ASSERT_GE(value, BruteForceDistance(at, atMost) * (1 - 1.0 / 1024) - 1.7333);
        leaps += value > 0 ? 1 : 0;
      }
      EXPECT_GT(leaps, 50);
    }
  }
}

//------------------------------------------------------------------------------
TEST(EmptyDistance, MediumBetweenTwoEmptyLatticePointsIsSeen)
{
  Setting setting =
    MakeSetting(MakeFilled(glm::ivec3(20), [](const glm::ivec3& at) { return at.x < 10 ? 0 : 1; }));
  UseFunction(setting.Scene, [](double s) { return std::max(0.1 - std::abs(s - 0.5), 0.0); });
  setting.Build();
  EXPECT_GT(setting.Grid.GetMaximum(), 0) << "the shell casts a shadow, in caches too";
  vtkMediumEmptyDistance distance;
  distance.Build(setting.Scene, setting.Grid, setting.Bricks);
  EXPECT_EQ(distance.GetValues()[setting.Grid.GetIndex(9, 5, 5)], 0);
  EXPECT_EQ(distance.GetValues()[setting.Grid.GetIndex(10, 5, 5)], 0);
  EXPECT_NEAR(distance.GetValues()[setting.Grid.GetIndex(4, 5, 5)], 5 - 0.8661, 5.0 / 1024 + 1e-6);
}

//------------------------------------------------------------------------------
TEST(EmptyDistance, EmptyLatticesLeapFarAndFullOnesNotAtAll)
{
  const Setting empty =
    MakeSetting(MakeFilled(glm::ivec3(12), [](const glm::ivec3&) { return 0.0f; }));
  vtkMediumEmptyDistance distance;
  distance.Build(empty.Scene, empty.Grid, empty.Bricks);
  EXPECT_TRUE(distance.CanLeap());
  EXPECT_GT(distance.GetValues()[7], 1000);
  const Setting full = MakeSetting(MakeImage(Smooth, glm::ivec3(12)));
  distance.Build(full.Scene, full.Grid, full.Bricks);
  EXPECT_FALSE(distance.CanLeap());
}
