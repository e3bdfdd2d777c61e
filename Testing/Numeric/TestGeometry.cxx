// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Units, origin, orientation and the kind of the data do not change the physics.
#include "ClosedForms.h"
#include "vtkMediumTestMatrix.h"

#include "vtkMatrix3x3.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
constexpr double SameRenderer =
  2e-4; // float rounding of local coordinates, through an extinction of 3

/// A field without symmetry, linear in space, so that the grid's resolution does not matter.
double Slope(const glm::dvec3& box)
{
  return 0.2 + 0.5 * box.x + 0.2 * box.y + 0.1 * box.z;
}

/// The same physical picture in other units and elsewhere.
struct SlopeScene : Scene
{
  SlopeScene(double unit, const glm::dvec3& center, const glm::ivec3& points = glm::ivec3(3),
    bool paper = false)
    : Scene(MakeSlope(unit, center, points), 16)
  {
    this->Mapper->SetIntegrator(
      paper ? vtkSingleScatteringVolumeMapper::Paper : vtkSingleScatteringVolumeMapper::FixedStep);
    this->Mapper->SetTransmittanceThreshold(0);
    this->Medium->SetExtinctionArrayName(paper ? nullptr : "");
    this->Medium->SetExtinctionScale(5 / unit);
    this->Medium->SetExtinction(5 / unit);
    this->SetSteps(0.05 * unit, 0.05 * unit);
    this->Look({ 0.3, 0.2, -1 }, 2.5 * unit, center);
    this->AddBeam({ 1, -0.5, -0.3 });
    vtkSmartPointer<vtkLight> point = this->AddPointLight(center + unit * glm::dvec3(0.2, 1, 0.5));
    point->SetIntensity(unit * unit);
  }

  static vtkSmartPointer<vtkImageData> MakeSlope(
    double unit, const glm::dvec3& center, const glm::ivec3& points)
  {
    const glm::dvec3 size = unit * glm::dvec3(1, 0.75, 0.5);
    auto image =
      MakeImage(points, size, [&](const glm::dvec3& p) { return Slope(p / size + 0.5); });
    glm::dvec3 origin;
    image->GetOrigin(&origin[0]);
    origin += center;
    image->SetOrigin(&origin[0]);
    return image;
  }
};

void ExpectTruthA(Scene& scene, const Box& box, const glm::dvec3& toLight, double sigma)
{
  const Picture picture = scene.Render();
  int hits = 0;
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const std::array<double, 2> t = box.Intersect(ray);
    const double d = std::max(t[1] - t[0], 0.0);
    const double truth = Isotropic * BoxRadiance(box, ray, toLight, sigma);
    hits += d > 0;
    // A float ray meets an oblique face 3 units away to within some 1e-6.
    ASSERT_NEAR(picture.At(x, y, 3), -std::expm1(-sigma * d), 1e-5) << x << ", " << y;
    ASSERT_NEAR(picture.At(x, y), truth, 2e-4 * truth + 2e-6) << x << ", " << y;
  });
  EXPECT_GT(hits, scene.Pixels);
}
}

TEST(Geometry, UnitsDoNotMatter)
{
  for (bool paper : { false, true })
  {
    SlopeScene metre(1, glm::dvec3(0), glm::ivec3(3), paper);
    const Picture reference = metre.Render();
    ASSERT_TRUE(reference.IsLight());
    ASSERT_GT(reference.Mean(), 1e-3);
    for (double unit : { 1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e12 })
    {
      SlopeScene scene(unit, glm::dvec3(0), glm::ivec3(3), paper);
      EXPECT_LT(Difference(reference, scene.Render()), SameRenderer)
        << "unit " << unit << (paper ? ", Paper" : ", FixedStep");
    }
  }
}

TEST(Geometry, OriginDoesNotMatter)
{
  SlopeScene here(1, glm::dvec3(0));
  const Picture reference = here.Render();
  SlopeScene far(1, { 1048576, -2097152, 1048576 }); // exactly representable, ulp 2e-10 in double
  EXPECT_LT(Difference(reference, far.Render()), 1e-3);
}

TEST(Geometry, ResolutionOfALinearFieldDoesNotMatter)
{
  SlopeScene coarse(1, glm::dvec3(0), { 2, 2, 2 });
  SlopeScene fine(1, glm::dvec3(0), { 17, 9, 33 });
  EXPECT_LT(Difference(coarse.Render(), fine.Render()), SameRenderer);
}

TEST(Geometry, ThinGridOfExtremeSpacingEqualsTheNormalised)
{
  // A spacing ratio of 1:1000, undone by the volume's scale.
  SlopeScene reference(1, glm::dvec3(0));
  SlopeScene scene(1, glm::dvec3(0));
  vtkImageData* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput());
  glm::dvec3 spacing, origin;
  image->GetSpacing(&spacing[0]);
  image->GetOrigin(&origin[0]);
  const glm::dvec3 ratio(1000, 1, 1e-3);
  spacing *= ratio;
  origin *= ratio;
  image->SetSpacing(&spacing[0]);
  image->SetOrigin(&origin[0]);
  scene.Volume->SetScale(1 / ratio.x, 1 / ratio.y, 1 / ratio.z);
  EXPECT_LT(Difference(reference.Render(), scene.Render()), SameRenderer);
}

TEST(Geometry, RotatedShearedAndMirroredBoxesAreTruthA)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const glm::dmat3 matrices[] = {
    glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1),            // rotation about z
    glm::dmat3(1, 0, 0, 0.6, 1, 0, 0.2, -0.4, 1),      // shear
    glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1),            // mirror, negative determinant
    glm::dmat3(-2 * c, s, 0.3, 0, 0.5, 0, -s, 0, 0.8), // all of it
  };
  int number = 0;
  for (const glm::dmat3& matrix : matrices)
  {
    SCOPED_TRACE(testing::Message() << "matrix " << number++);
    const glm::dvec3 shift(0.1, -0.2, 0.05);
    Scene scene(MakeBox(), 16);
    scene.Mapper->SetTransmittanceThreshold(0);
    scene.Medium->SetExtinction(2);
    scene.SetSteps(0.004, 0.2);
    scene.Look({ 0.3, 0.2, -1 }, 3);
    const glm::dvec3 beam = glm::normalize(glm::dvec3(1, -0.7, -0.4));
    scene.AddBeam(beam);
    SetUserMatrix(scene.Volume, matrix, shift);
    Box box(glm::dvec3(1));
    box.Axes = matrix * box.Axes;
    box.Origin = matrix * box.Origin + shift;
    ExpectTruthA(scene, box, -beam, 2);
  }
}

TEST(Geometry, TheDensityTurnsWithTheMatrix)
{
  // Mirrored in x, the density that grows with x grows with -x: the mirror image of the whole scene.
  SlopeScene scene(1, glm::dvec3(0));
  scene.Renderer->RemoveAllLights();
  scene.AddBeam({ 0, -1, -0.5 });
  scene.Look({ 0, 0.1, -1 }, 2.5);
  const Picture picture = scene.Render();
  SetUserMatrix(scene.Volume, glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), glm::dvec3(0));
  Picture mirrored = scene.Render();
  EXPECT_GT(Difference(picture, mirrored), 0.05); // there is something to mirror
  for (int y = 0; y < 16; ++y)
  {
    for (int x = 0; x < 16; ++x)
    {
      ASSERT_NEAR(mirrored.At(15 - x, y), picture.At(x, y), 1e-5) << x << ", " << y;
    }
  }
}

TEST(Geometry, DirectionMatrixOfTheImageEqualsThatOfTheVolume)
{
  SlopeScene byVolume(1, glm::dvec3(0)), byImage(1, glm::dvec3(0));
  const glm::dmat3 turn(0, 1, 0, 0, 0, -1, -1, 0, 0); // a permutation with a reflection
  vtkImageData* image = vtkImageData::SafeDownCast(byImage.Mapper->GetDataObjectInput());
  vtkNew<vtkMatrix3x3> direction;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      direction->SetElement(row, column, turn[column][row]);
    }
  }
  glm::dvec3 origin;
  image->GetOrigin(&origin[0]);
  origin = turn * origin; // the direction matrix turns about the origin of the image
  image->SetOrigin(&origin[0]);
  image->SetDirectionMatrix(direction);
  SetUserMatrix(byVolume.Volume, turn, glm::dvec3(0));
  EXPECT_LT(Difference(byVolume.Render(), byImage.Render()), SameRenderer);
}

TEST(Geometry, ExtentThatDoesNotStartAtZeroIsOnlyALabel)
{
  SlopeScene reference(1, glm::dvec3(0)), shifted(1, glm::dvec3(0));
  vtkImageData* image = vtkImageData::SafeDownCast(shifted.Mapper->GetDataObjectInput());
  glm::dvec3 spacing, origin;
  image->GetSpacing(&spacing[0]);
  image->GetOrigin(&origin[0]);
  image->SetExtent(-7, -5, 100, 102, 3, 5);
  origin -= spacing * glm::dvec3(-7, 100, 3);
  image->SetOrigin(&origin[0]);
  EXPECT_LT(Difference(reference.Render(), shifted.Render()), SameRenderer);
}

TEST(Geometry, ConstantCellAndPointDataAreTruthA)
{
  for (bool onCells : { false, true })
  {
    SCOPED_TRACE(onCells ? "cells" : "points");
    const glm::dvec3 size(1, 0.7, 0.5);
    Scene scene(MakeBox(size, onCells), 16);
    scene.Mapper->SetTransmittanceThreshold(0);
    scene.Medium->SetExtinctionArrayName("density");
    scene.Medium->SetExtinctionScale(2);
    scene.SetSteps(0.004, 0.2);
    scene.Look({ 0.3, 0.2, -1 }, 2);
    const glm::dvec3 beam = glm::normalize(glm::dvec3(1, -0.7, -0.4));
    scene.AddBeam(beam);
    ExpectTruthA(scene, Box(size), -beam, 2);
  }
}

TEST(Geometry, CellsAreSampledAtTheirCentres)
{
  // One dense layer of cells, 1/4 of the box, nearest interpolation: a slab with exact faces.
  Scene scene(MakeImage(
                { 2, 2, 5 }, glm::dvec3(1),
                [](const glm::dvec3& p) { return p.z > 0 && p.z < 0.25 ? 1.0 : 0.0; }, true),
    8);
  scene.Property->SetInterpolationTypeToNearest();
  scene.Medium->SetExtinctionArrayName("density");
  scene.Medium->SetExtinctionScale(3);
  scene.LookParallel({ 0, 0, -1 }, 2, 0.3);
  scene.SetSteps(0.25, 0.25); // one sample in each layer
  EXPECT_NEAR(scene.Render().At(4, 4, 3), -std::expm1(-0.75), 1e-5);
}

TEST(Geometry, ScalarTypesDoNotMatter)
{
  Picture reference;
  for (int type : { VTK_FLOAT, VTK_DOUBLE, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE })
  {
    // Whole numbers 7 to 107, which every type holds.
    auto image = MakeImage(
      glm::ivec3(6), glm::dvec3(1),
      [](const glm::dvec3& p) {
        return 7 + std::round(20 * (p.x + 0.5)) * 3 + std::round(40 * std::abs(p.y * p.z) * 4);
      },
      false, type);
    Scene scene(image, 16);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0, 0);
    opacity->AddPoint(110, 0.95);
    scene.Property->SetScalarOpacity(opacity);
    scene.Mapper->SetMedium(nullptr);
    scene.AddBeam({ 1, -1, -0.3 });
    scene.Look({ 0.3, 0.2, -1 }, 2);
    const Picture picture = scene.Render();
    ASSERT_TRUE(picture.IsLight());
    if (reference.Values.empty())
    {
      reference = picture;
      EXPECT_GT(reference.Mean(3), 0.1);
    }
    // Whole numbers of 16 bits are uploaded as such, others as float fractions of the range.
    EXPECT_LT(Difference(reference, picture), 1e-6) << "type " << type;
  }
}

TEST(Geometry, LargeOffsetsOfTheValuesDoNotMatter)
{
  auto picture = [](double offset, double scale) {
    Scene scene(
      MakeImage(
        glm::ivec3(5), glm::dvec3(1),
        [&](const glm::dvec3& p) { return offset + scale * (p.x + 0.5); }, false, VTK_DOUBLE),
      16);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(offset, 0);
    opacity->AddPoint(offset + scale, 0.95);
    vtkNew<vtkPiecewiseFunction> white;
    white->AddPoint(0, 1);
    scene.Property->SetScalarOpacity(opacity);
    scene.Mapper->SetMedium(nullptr);
    scene.AddBeam({ 1, -1, -0.3 });
    scene.Property->SetColor(white);
    return scene.Render();
  };
  const Picture reference = picture(0, 1);
  ASSERT_GT(reference.Mean(), 1e-3);
  // 2^27 + 2^-10 x: exact in double, all the same in float.
  EXPECT_LT(Difference(reference, picture(134217728, 1.0 / 1024)), SameRenderer);
  EXPECT_LT(Difference(reference, picture(0, 1e300)), SameRenderer);
}
