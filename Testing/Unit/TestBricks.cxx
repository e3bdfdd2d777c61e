// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumBricks.h"
#include "vtkMediumEmptyDistance.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using Coefficient = vtkMediumScene::Coefficient;
using namespace vtkMediumFixtures;

// Everything about one scene.
struct Setting
{
  vtkMediumScene Scene;
  vtkMediumExtinctionGrid Grid;
  vtkMediumBricks Bricks;

  void Build()
  {
    this->Grid.Build(this->Scene);
    this->Bricks.Build(this->Scene, this->Grid);
  }
};

vtkSmartPointer<vtkImageData> MakeFilled(
  const glm::ivec3& points, const std::function<float(const glm::ivec3&)>& value)
{
  auto image = MakeImage(Smooth, points);
  vtkDataArray* density = image->GetPointData()->GetScalars();
  vtkIdType tuple = 0;
  for (int k = 0; k < points.z; ++k)
  {
    for (int j = 0; j < points.y; ++j)
    {
      for (int i = 0; i < points.x; ++i)
      {
        density->SetComponent(tuple++, 0, value({ i, j, k }));
      }
    }
  }
  return image;
}

Setting MakeSetting(vtkImageData* image, bool onCells = false)
{
  Setting setting;
  setting.Scene = MakeScene(image, 10, onCells);
  setting.Build();
  return setting;
}

void UseFunction(vtkMediumScene& scene, const std::function<double(double)>& extinction)
{
  vtkMediumFunction function;
  function.Sample(0, 1, {}, [&](double s) { return glm::dvec4(0, 0, 0, extinction(s)); });
  scene.Content.Functions.assign(1, function);
  scene.Content.Extinction = Coefficient{ Coefficient::FunctionAlpha, 0, 0, -1, glm::dvec3(10) };
}

double Wavy(double s)
{
  return std::max(std::sin(23 * s) * s, 0.0);
}

glm::dvec3 RandomBox(std::uint32_t index, std::uint32_t seed)
{
  return { Random(3 * index, seed), Random(3 * index + 1, seed), Random(3 * index + 2, seed) };
}

std::size_t Occupied(const vtkMediumBricks& bricks)
{
  return bricks.GetNumberOf(vtkMediumBricks::Uniform) + bricks.GetNumberOf(vtkMediumBricks::Mixed);
}

// A camera as vtkMediumScene::View describes it: rays through x right + y up + forward.
vtkMediumScene::View MakeView(
  const glm::dvec3& eye, const glm::dvec3& target, double halfWidth, bool parallel)
{
  const glm::dvec3 forward = glm::normalize(target - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.1, 1, 0.2)));
  const glm::dvec3 up = glm::cross(right, forward);
  vtkMediumScene::View view;
  view.Parallel = parallel;
  view.Direction = forward;
  const glm::dvec4 alongRight(right, -glm::dot(right, eye)), alongUp(up, -glm::dot(up, eye));
  const glm::dvec4 alongForward(forward, -glm::dot(forward, eye));
  const glm::dvec4 rowX = alongRight / halfWidth, rowY = alongUp / halfWidth;
  const glm::dvec4 rowZ = alongForward, rowW = parallel ? glm::dvec4(0, 0, 0, 1) : alongForward;
  view.LocalToClip = glm::transpose(glm::dmat4(rowX, rowY, rowZ, rowW));
  view.ClipZ = rowZ;
  view.ClipW = rowW;
  if (parallel)
  {
    view.Origin = eye - forward * glm::dot(eye, forward);
    view.OriginX = right * halfWidth;
    view.OriginY = up * halfWidth;
  }
  else
  {
    view.Origin = eye;
    view.DirectionX = right * halfWidth;
    view.DirectionY = up * halfWidth;
  }
  return view;
}

// Samples random eye rays; whatever has extinction must be inside its tile's range and the scissor.
// Returns how many samples had any.
int ExpectTilesCoverTheMedium(const Setting& setting, int width, int height)
{
  const vtkMediumScene::View& view = setting.Scene.Eye;
  const vtkMediumBricks::Tiles tiles = setting.Bricks.ProjectToTiles(setting.Scene, width, height);
  int hits = 0;
  for (std::uint32_t i = 0; i < 40000; ++i)
  {
    const glm::dvec2 pixel(Random(3 * i, 41) * width, Random(3 * i + 1, 41) * height);
    const glm::dvec2 at = 2.0 * pixel / glm::dvec2(width, height) - 1.0;
    const glm::dvec3 origin = view.Origin + at.x * view.OriginX + at.y * view.OriginY;
    const glm::dvec3 direction =
      glm::normalize(view.Direction + at.x * view.DirectionX + at.y * view.DirectionY);
    const double t = view.Parallel ? 1.2 * Random(3 * i + 2, 41) - 0.6 : 3 * Random(3 * i + 2, 41);
    const glm::dvec3 box = setting.Scene.Geometry.LocalToBox(origin + t * direction);
    if (glm::clamp(box, 0.0, 1.0) != box || !(setting.Scene.Evaluate(box).Extinction.x > 0))
    {
      continue;
    }
    ++hits;
    const glm::ivec2 tile(pixel / double(tiles.Edge));
    const glm::vec2 range = tiles.Ranges[tile.x + tiles.Count.x * tile.y];
    EXPECT_LE(range.x, t) << "pixel " << pixel.x << " " << pixel.y;
    EXPECT_GE(range.y, t) << "pixel " << pixel.x << " " << pixel.y;
    EXPECT_GE(pixel.x, tiles.Scissor.x);
    EXPECT_GE(pixel.y, tiles.Scissor.y);
    EXPECT_LE(pixel.x, tiles.Scissor.x + tiles.Scissor.z);
    EXPECT_LE(pixel.y, tiles.Scissor.y + tiles.Scissor.w);
    if (testing::Test::HasFailure())
    {
      break;
    }
  }
  return hits;
}
}

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
  EXPECT_EQ(setting.Grid.GetMaximum(), 0) << "no lattice point has extinction";
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
