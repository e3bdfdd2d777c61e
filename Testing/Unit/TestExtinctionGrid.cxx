// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFixtures.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkShortArray.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using Coefficient = vtkMediumScene::Coefficient;
using namespace vtkMediumFixtures;

// Values are stored as float: half an ulp of relative error, and as much again for the interpolation.
constexpr double FloatTolerance = 3e-7;

const glm::ivec3 Points(13, 9, 11);
const glm::ivec3 Fine(32, 24, 28);
const glm::dvec3 Size(1.3, 0.4, 2);

glm::dvec3 RandomPoint(std::uint32_t index)
{
  return { Random(3 * index, 7), Random(3 * index + 1, 7), Random(3 * index + 2, 7) };
}

void ExpectGridEqualsScene(const vtkMediumScene& scene, const vtkMediumExtinctionGrid& grid)
{
  const double largest = grid.GetMaximum();
  for (std::uint32_t i = 0; i < 500; ++i)
  {
    const glm::dvec3 box = RandomPoint(i);
    const glm::dvec3 lattice = grid.LocalToLattice(scene.Geometry.BoxToLocal(box));
    EXPECT_NEAR(grid.Interpolate(lattice), scene.Evaluate(box).Extinction.x * scene.Geometry.Length,
      largest * FloatTolerance)
      << "at box " << box.x << " " << box.y << " " << box.z;
  }
}

void UseFunction(
  vtkMediumScene& scene, double (*extinction)(double), std::vector<double> knots = {})
{
  vtkMediumFunction function;
  function.Sample(scene.Content.Fields[0].Minimum, scene.Content.Fields[0].Maximum, knots,
    [&](double value) { return glm::dvec4(0, 0, 0, extinction(value)); });
  scene.Content.Functions.assign(1, function);
  scene.Content.Extinction = Coefficient{ Coefficient::FunctionAlpha, 0, 0, -1, glm::dvec3(3) };
}
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, InterpolatesToTheSceneOnPointsAndCellsAndInShearedBoxes)
{
  for (bool onCells : { false, true })
  {
    const auto image = MakeImage(Smooth, Points, Size, onCells);
    const glm::dmat3 axes(0.1, 0, 0, 0.02, 0.05, 0, -0.03, 0.01, 0.2);
    for (const vtkMediumScene& scene :
      { MakeScene(image, 5, onCells), MakeScene(image, 5, onCells, axes) })
    {
      vtkMediumExtinctionGrid grid;
      grid.Build(scene);
      EXPECT_TRUE(grid.IsAffine());
      EXPECT_EQ(grid.IsOnCells(), onCells);
      ExpectGridEqualsScene(scene, grid);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, LatticeReachesTheFacesOfTheBox)
{
  for (bool onCells : { false, true })
  {
    const vtkMediumScene scene = MakeScene(MakeImage(Smooth, Points, Size, onCells), 5, onCells);
    vtkMediumExtinctionGrid grid;
    grid.Build(scene);
    const glm::dvec3 first = scene.Geometry.BoxToLocal(glm::dvec3(0));
    const glm::dvec3 last = scene.Geometry.BoxToLocal(glm::dvec3(1));
    EXPECT_LT(glm::length(grid.LatticeToLocal(grid.GetLower()) - first), 1e-14);
    EXPECT_LT(glm::length(grid.LatticeToLocal(grid.GetUpper()) - last), 1e-14);
    EXPECT_LT(glm::length(grid.LocalToLattice(last) - grid.GetUpper()), 1e-12);
  }
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, NearestFieldsStayNearest)
{
  vtkMediumScene scene = MakeScene(MakeImage(Cloud, Points, Size), 5);
  scene.Content.Fields[0].Linear = false;
  UseFunction(scene, [](double s) { return s * s; });
  vtkMediumExtinctionGrid grid;
  grid.Build(scene);
  EXPECT_FALSE(grid.IsLinear());
  EXPECT_TRUE(grid.IsAffine()) << "classification commutes with nearest-neighbour interpolation";
  ExpectGridEqualsScene(scene, grid);
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, KnowsWhereFunctionsAreAffine)
{
  vtkMediumScene scene = MakeScene(MakeImage(Smooth, Points, Size), 5);
  vtkMediumExtinctionGrid grid;
  UseFunction(scene, [](double s) { return 0.25 + 2 * s; });
  grid.Build(scene);
  EXPECT_TRUE(grid.IsAffine());
  ExpectGridEqualsScene(scene, grid);

  UseFunction(scene, [](double s) { return s * s; });
  grid.Build(scene);
  EXPECT_FALSE(grid.IsAffine());

  // A kink outside the range of the data does no harm; one inside does.
  UseFunction(scene, [](double s) { return std::max(s - 2, 0.0) + s; });
  grid.Build(scene);
  EXPECT_TRUE(grid.IsAffine());
  UseFunction(scene, [](double s) { return std::max(s - 0.4, 0.0); });
  grid.Build(scene);
  EXPECT_FALSE(grid.IsAffine());
}

//------------------------------------------------------------------------------
// Optical depths of rays through interpolated extinctions, against those of the extinction of interpolated
// scalars: classified values err to one side, the values of the grid to both and by less.
TEST(ExtinctionGrid, NonAffineFunctionsCastTheRightShadows)
{
  vtkMediumScene scene = MakeScene(MakeImage(Smooth, Fine, Size), 5);
  struct Case
  {
    double (*Function)(double);
    double Improvement;
  };
  const Case cases[] = { { [](double s) { return std::max(s - 0.4, 0.0); }, 0.75 },
    { [](double s) { return s > 0.5 ? 1.0 : 0.0; },
      1 }, // between lattice points nobody knows where
    { [](double s) { return s * s * s * s; }, 0.5 } };
  for (const Case& row : cases)
  {
    UseFunction(scene, row.Function);
    vtkMediumExtinctionGrid grid;
    grid.Build(scene);
    auto atCorners = [&](const glm::dvec3& lattice) {
      const glm::ivec3 cell = glm::min(glm::ivec3(lattice), Fine - 2);
      const glm::dvec3 f = lattice - glm::dvec3(cell);
      double value = 0;
      for (int corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 bit(corner & 1, corner >> 1 & 1, corner >> 2);
        const glm::dvec3 w = glm::mix(1.0 - f, f, glm::dvec3(bit));
        value += w.x * w.y * w.z *
          scene.Evaluate(glm::dvec3(cell + bit) / glm::dvec3(Fine - 1)).Extinction.x;
      }
      return scene.Geometry.Length * value;
    };
    double errors[2] = { 0, 0 };
    const int rays = 60, steps = 200;
    for (int ray = 0; ray < rays; ++ray)
    {
      const glm::dvec3 from = RandomPoint(2 * ray), to = RandomPoint(2 * ray + 1);
      double difference[2] = { 0, 0 };
      for (int step = 0; step < steps; ++step)
      {
        const glm::dvec3 box = glm::mix(from, to, (step + 0.5) / steps);
        const glm::dvec3 lattice = box * glm::dvec3(Fine - 1);
        const double right = scene.Geometry.Length * scene.Evaluate(box).Extinction.x;
        difference[0] += atCorners(lattice) - right;
        difference[1] += grid.Interpolate(lattice) - right;
      }
      for (int i = 0; i < 2; ++i)
      {
        errors[i] += difference[i] * difference[i];
      }
    }
    EXPECT_LT(std::sqrt(errors[1] / errors[0]), row.Improvement);
    EXPECT_GE(grid.GetMinimum(), 0);
  }
}

//------------------------------------------------------------------------------
// Random settings found NaN here. Doubles far from zero, or beyond float, cast the shadows of 0 to 1.
TEST(ExtinctionGrid, ShadowsDoNotDependOnTheUnitOfTheScalar)
{
  const auto values = [](double offset, double scale) {
    auto image = MakeImage(Cloud, Points, Size);
    vtkNew<vtkDoubleArray> scalars;
    vtkDataArray* cloud = image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < cloud->GetNumberOfTuples(); ++i)
    {
      scalars->InsertNextValue(offset + scale * cloud->GetTuple1(i));
    }
    image->GetPointData()->SetScalars(scalars);
    vtkMediumScene scene = MakeScene(image, 1);
    const double first = scene.Content.Fields[0].Minimum;
    const double range = scene.Content.Fields[0].Maximum - first;
    vtkMediumFunction function;
    function.Sample(first, first + range, {}, [&](double value) {
      const double part = (value - first) / range;
      return glm::dvec4(part * part);
    });
    scene.Content.Functions.assign(1, function);
    scene.Content.Extinction = Coefficient{ Coefficient::FunctionAlpha, 0, 0, -1, glm::dvec3(3) };
    vtkMediumExtinctionGrid grid;
    grid.Build(scene);
    EXPECT_FALSE(grid.IsAffine());
    return grid.GetValues();
  };
  const std::vector<float> expected = values(0, 1);
  for (const glm::dvec2& unit : { glm::dvec2(0, 1e-300), { 0, 1e300 }, { 1e9, 1 } })
  {
    const std::vector<float> found = values(unit.x, unit.y);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      // 1e9 + 1 keeps seven digits of the 1.
      ASSERT_NEAR(found[i], expected[i], 1e-5) << i << " of " << unit.x << " + " << unit.y;
    }
  }
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, HomogeneousMediaNeedEightValues)
{
  vtkMediumScene scene = MakeScene(MakeImage(Smooth, Points, Size), 5);
  scene.Content.Fields.clear();
  scene.Content.Extinction = Coefficient{ Coefficient::Constant, -1, -1, -1, glm::dvec3(1, 2, 3) };
  vtkMediumExtinctionGrid grid;
  grid.Build(scene, 1);
  EXPECT_EQ(grid.GetDimensions(), glm::ivec3(2));
  EXPECT_TRUE(grid.IsAffine());
  EXPECT_FLOAT_EQ(grid.GetMinimum(), static_cast<float>(2 * scene.Geometry.Length));
  EXPECT_FLOAT_EQ(grid.GetMaximum(), static_cast<float>(2 * scene.Geometry.Length));
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, AbsorptionAndScatteringAddUp)
{
  const auto absorption = MakeImage(Cloud, Points, Size);
  const auto scattering = MakeImage(Smooth, Points, Size);
  vtkMediumScene scene = MakeScene(absorption, 5);
  scene.Content.Fields.push_back(MakeScene(scattering, 1).Content.Fields[0]);
  scene.Content.ExtinctionIsAbsorption = true;
  scene.Content.ScatteringIsAlbedo = false;
  scene.Content.Scattering = Coefficient{ Coefficient::Field, 1, -1, 0, glm::dvec3(2) };
  vtkMediumExtinctionGrid grid;
  grid.Build(scene);
  EXPECT_TRUE(grid.IsAffine());
  ExpectGridEqualsScene(scene, grid);
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, DensityScaleIsLeftOut)
{
  vtkMediumScene scene = MakeScene(MakeImage(Smooth, Points, Size), 5);
  vtkMediumExtinctionGrid one, two;
  one.Build(scene);
  scene.Content.DensityScale = 2;
  two.Build(scene);
  EXPECT_EQ(one.GetValues(), two.GetValues());
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, NonFiniteValuesFollowTheField)
{
  const auto image = MakeImage(Smooth, Points, Size);
  vtkDataArray* density = image->GetPointData()->GetScalars();
  density->SetComponent(3, 0, std::numeric_limits<double>::quiet_NaN());
  density->SetComponent(40, 0, std::numeric_limits<double>::infinity());
  const vtkMediumScene scene = MakeScene(image, 5);
  vtkMediumExtinctionGrid grid;
  grid.Build(scene);
  const double scale = 5 * scene.Geometry.Length;
  EXPECT_NEAR(grid.GetValues()[3], scale * scene.Content.Fields[0].Minimum, scale * FloatTolerance);
  EXPECT_NEAR(
    grid.GetValues()[40], scale * scene.Content.Fields[0].Maximum, scale * FloatTolerance);
  ExpectGridEqualsScene(scene, grid);
}

//------------------------------------------------------------------------------
TEST(ExtinctionGrid, ReadsOneComponentOfIntegerArrays)
{
  const auto image = MakeImage(Smooth, Points, Size);
  vtkNew<vtkShortArray> pairs;
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    pairs->SetTypedComponent(i, 0, -100);
    pairs->SetTypedComponent(i, 1, static_cast<short>(i));
  }
  vtkMediumScene scene = MakeScene(image, 5);
  vtkMediumField& field = scene.Content.Fields[0];
  field.Array = pairs;
  field.FirstComponent = 1;
  field.FindRange();
  vtkMediumExtinctionGrid grid;
  grid.Build(scene);
  EXPECT_FLOAT_EQ(grid.GetValues()[17], static_cast<float>(17 * 5 * scene.Geometry.Length));
  ExpectGridEqualsScene(scene, grid);
}

//------------------------------------------------------------------------------
// The lattice's sum is the volume that is kept, and each value is about the share of its voxel.
TEST(ExtinctionGrid, CutAwayLeavesTheShareOfEachVoxelThatIsKept)
{
  const auto image = MakeImage(Smooth, glm::ivec3(40), glm::dvec3(1), true);
  image->GetCellData()->GetScalars()->Fill(1);
  vtkMediumScene scene = MakeScene(image, 1, true);
  vtkMediumCut& cut = scene.Cut;
  cut.Planes.push_back({ glm::normalize(glm::dvec3(1, 0.4, -0.3)), 0.04 });
  for (int axis = 0; axis < 3; ++axis)
  {
    cut.Lower[axis].Normal = cut.Upper[axis].Normal = glm::dvec3(0);
    cut.Lower[axis].Normal[axis] = cut.Upper[axis].Normal[axis] = 1;
    cut.Lower[axis].Offset = 0.103;
    cut.Upper[axis].Offset = -0.057;
  }
  cut.Regions = 0x2ebfeba; // a fence
  vtkMediumExtinctionGrid whole, left;
  whole.Build(scene);
  left.Build(scene);
  left.CutAway(cut);
  const glm::ivec3 n = left.GetDimensions();
  double sum = 0, kept = 0, largest = 0;
  for (std::size_t i = 0; i < left.GetValues().size(); ++i)
  {
    const int x = static_cast<int>(i % n.x), y = static_cast<int>(i / n.x % n.y),
              z = static_cast<int>(i / n.x / n.y);
    double samples = 0; // of 4 x 4 x 4 points of the voxel
    for (int s = 0; s < 64; ++s)
    {
      const glm::dvec3 at =
        glm::dvec3(x, y, z) + (glm::dvec3(s % 4, s / 4 % 4, s / 16) - 1.5) / 4.0;
      samples += cut.Keeps(left.LatticeToLocal(at)) ? 1.0 / 64 : 0;
    }
    const double share = left.GetValues()[i] / whole.GetValues()[i];
    largest = std::max(largest, std::abs(share - samples));
    sum += share;
    kept += samples;
  }
  EXPECT_LT(largest, 0.4); // several planes in one voxel, and the samples' own error
  EXPECT_NEAR(sum / kept, 1, 0.01);
  EXPECT_LT(left.GetOccupiedFraction(), 0.8 * whole.GetOccupiedFraction());
}
