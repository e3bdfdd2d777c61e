// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a scene says that things are, against VTK's own matrices.
#include "vtkMediumScene.h"

#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
constexpr double Rounding = 1e-12; ///< a few hundred double operations on numbers of order 1

void ExpectNear(const glm::dvec3& value, const glm::dvec3& truth, double tolerance)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(value[axis], truth[axis], tolerance) << "axis " << axis;
  }
}

struct Placed
{
  vtkNew<vtkImageData> Image;
  vtkNew<vtkVolume> Volume;
  vtkMediumScene Scene;

  Placed()
  {
    this->Image->SetExtent(3, 7, -2, 9, 10, 14);
    this->Image->SetSpacing(0.5, 2, 0.125);
    this->Image->SetOrigin(1, -3, 2);
  }

  std::string Gather()
  {
    vtkNew<vtkDoubleArray> values;
    values->SetNumberOfTuples(this->Image->GetNumberOfPoints());
    values->Fill(1);
    this->Image->GetPointData()->SetScalars(values);
    return this->Scene.GatherVolume(this->Image, values, false, this->Volume, nullptr, 0);
  }

  // World position of a point of the image, by VTK's own matrices.
  glm::dvec3 World(int i, int j, int k)
  {
    glm::dvec4 at(0, 0, 0, 1);
    double physical[3];
    this->Image->TransformIndexToPhysicalPoint(i, j, k, physical);
    const double in[4] = { physical[0], physical[1], physical[2], 1 };
    this->Volume->GetMatrix()->MultiplyPoint(in, &at[0]);
    return glm::dvec3(at);
  }

  // Every corner, there and back.
  void ExpectCornersInPlace(double tolerance)
  {
    const vtkMediumScene::Box& box = this->Scene.Geometry;
    double longest = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 at(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      const glm::dvec3 world =
        this->World(corner & 1 ? 7 : 3, corner & 2 ? 9 : -2, corner & 4 ? 14 : 10);
      const glm::dvec3 local = box.BoxToLocal(at);
      ExpectNear(box.WorldToLocal(world), local, tolerance);
      ExpectNear(box.LocalToBox(local), at, tolerance);
      longest = std::max(longest, 2 * glm::length(local));
    }
    EXPECT_NEAR(longest, 1, tolerance) << "the longest diagonal is the local unit";
  }
};

vtkSmartPointer<vtkMatrix4x4> Matrix(const double rows[16])
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->DeepCopy(rows);
  return matrix;
}
}

TEST(SceneGeometry, ExtentSpacingAndOriginPlaceTheBox)
{
  Placed placed;
  ASSERT_EQ(placed.Gather(), "");
  placed.ExpectCornersInPlace(Rounding);
  EXPECT_NEAR(placed.Scene.Geometry.VoxelLength, 0.125, Rounding);
}

TEST(SceneGeometry, DirectionMatrixAndVolumesOwnMatrixCompose)
{
  Placed placed;
  placed.Image->SetDirectionMatrix(0, 1, 0, 0, 0, -1, -1, 0, 0);
  placed.Volume->SetPosition(1, 2, 3);
  placed.Volume->SetScale(2, 1, 0.5);
  placed.Volume->SetOrientation(20, 30, 40);
  ASSERT_EQ(placed.Gather(), "");
  placed.ExpectCornersInPlace(Rounding);
}

TEST(SceneGeometry, ShearAndNegativeDeterminantKeepTheirCorners)
{
  const double shear[16] = { 1, 0.5, 0, 4, 0, 1, 0.25, 0, 0, 0, 2, 1, 0, 0, 0, 1 };
  const double mirror[16] = { -1, 0, 0, 0, 0, 1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  for (const double* rows : { shear, mirror })
  {
    Placed placed;
    placed.Volume->SetUserMatrix(Matrix(rows));
    ASSERT_EQ(placed.Gather(), "");
    placed.ExpectCornersInPlace(Rounding);
    const double sign = glm::determinant(placed.Scene.Geometry.BoxToLocalAxes);
    EXPECT_EQ(sign < 0, rows == mirror);
  }
}

// An origin of 1e9 leaves 1e-7 of a unit to world coordinates, and none of that to local ones.
TEST(SceneGeometry, HugeOffsetsStayOutOfLocalSpace)
{
  Placed near, far;
  far.Image->SetOrigin(1 + 1073741824.0, -3 - 1073741824.0, 2);
  ASSERT_EQ(near.Gather(), "");
  ASSERT_EQ(far.Gather(), "");
  const vtkMediumScene::Box &a = near.Scene.Geometry, &b = far.Scene.Geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    ExpectNear(a.BoxToLocalAxes[axis], b.BoxToLocalAxes[axis], Rounding);
  }
  ExpectNear(a.BoxToLocalOrigin, b.BoxToLocalOrigin, Rounding);
  ExpectNear(b.Center - a.Center, { 1073741824.0, -1073741824.0, 0 }, 1e-6);
}

TEST(SceneGeometry, TinyAndHugeVoxelsHaveTheSameLocalBox)
{
  Placed reference;
  ASSERT_EQ(reference.Gather(), "");
  for (double scale : { 1e-12, 1e12 })
  {
    Placed placed;
    placed.Image->SetSpacing(0.5 * scale, 2 * scale, 0.125 * scale);
    ASSERT_EQ(placed.Gather(), "");
    EXPECT_NEAR(
      placed.Scene.Geometry.Length / reference.Scene.Geometry.Length / scale, 1, Rounding);
    for (int axis = 0; axis < 3; ++axis)
    {
      ExpectNear(placed.Scene.Geometry.BoxToLocalAxes[axis],
        reference.Scene.Geometry.BoxToLocalAxes[axis], Rounding);
    }
  }
}

TEST(SceneGeometry, FlatGridsAndSingularMatricesAreRefused)
{
  Placed flat;
  flat.Image->SetExtent(0, 4, 0, 4, 3, 3);
  EXPECT_NE(flat.Gather().find("two points along each axis"), std::string::npos);
  Placed singular;
  singular.Volume->SetScale(1, 1, 1e-20);
  const double rank2[16] = { 1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1 };
  singular.Volume->SetScale(1, 1, 1);
  singular.Volume->SetUserMatrix(Matrix(rank2));
  EXPECT_NE(singular.Gather().find("singular"), std::string::npos);
  singular.Volume->SetUserMatrix(nullptr);
  EXPECT_EQ(singular.Gather(), "") << "the next valid scene works";
}

// Random settings found a radiance of NaN here: the box's matrix was beyond float.
TEST(SceneGeometry, VolumesThinnerThanFloatsCanSayAreRefused)
{
  for (double scale : { 1e39, 1e-39, 1e-21 })
  {
    Placed thin;
    thin.Volume->SetScale(scale, 1, 1);
    EXPECT_NE(thin.Gather().find("along its shortest edge"), std::string::npos) << scale;
    thin.Volume->SetScale(1, 1, 1);
    EXPECT_EQ(thin.Gather(), "") << "the next valid scene works";
  }
  Placed thick;
  thick.Volume->SetScale(1e15, 1, 1);
  EXPECT_EQ(thick.Gather(), "");
}

TEST(SceneGeometry, PointLatticesEndOnTheFacesAndCellLatticesHalfACellInside)
{
  vtkMediumField field;
  field.Dimensions = { 5, 3, 9 };
  ExpectNear(field.BoxToLattice(glm::dvec3(0)), glm::dvec3(0), Rounding);
  ExpectNear(field.BoxToLattice(glm::dvec3(1)), { 4, 2, 8 }, Rounding);
  field.OnCells = true;
  ExpectNear(field.BoxToLattice(glm::dvec3(0)), glm::dvec3(-0.5), Rounding);
  ExpectNear(field.BoxToLattice(glm::dvec3(1)), { 4.5, 2.5, 8.5 }, Rounding);
  ExpectNear(field.BoxToLattice({ 0.5 / 5, 0.5 / 3, 0.5 / 9 }), glm::dvec3(0), Rounding);
}

TEST(SceneGeometry, InterpolationMeetsItsValuesAndIsConstantInTheBorderHalfCell)
{
  vtkNew<vtkDoubleArray> values;
  for (int i = 0; i < 2 * 3 * 4; ++i)
  {
    values->InsertNextValue(i * i);
  }
  vtkMediumField field;
  field.Array = values;
  field.Dimensions = { 2, 3, 4 };
  ASSERT_TRUE(field.FindRange());
  for (bool onCells : { false, true })
  {
    field.OnCells = onCells;
    for (bool linear : { false, true })
    {
      field.Linear = linear;
      for (int i = 0; i < 24; ++i)
      {
        const glm::dvec3 at(i % 2, i / 2 % 3, i / 6), n(field.Dimensions);
        const glm::dvec3 box = onCells ? (at + 0.5) / n : at / (n - 1.0);
        EXPECT_NEAR(field.Interpolate(box).x, i * i, 1e-10);
      }
      if (onCells)
      {
        EXPECT_NEAR(field.Interpolate({ 0, 0.5 / 3, 0.5 / 4 }).x, 0, 1e-10);
        EXPECT_NEAR(field.Interpolate({ 0.2, 0, 0.1 }).x, 0, 1e-10);
      }
    }
    // Halfway between two values linear interpolation is their mean.
    field.Linear = true;
    const double y = onCells ? 0.5 / 3 : 0, z = onCells ? 0.5 / 4 : 0;
    EXPECT_NEAR(field.Interpolate({ 0.5, y, z }).x, 0.5, 1e-10);
  }
}

namespace
{
// The scene's ray through (x, y) must pass the points that the camera's inverse matrix gives, from the
// near one to the far one.
void ExpectRaysOfCamera(vtkCamera* camera, double aspect, double tolerance)
{
  Placed placed;
  placed.Volume->SetOrientation(10, -20, 30);
  ASSERT_EQ(placed.Gather(), "");
  vtkMatrix4x4* toClip = camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  ASSERT_EQ(placed.Scene.GatherView(toClip), "");
  const vtkMediumScene::View& eye = placed.Scene.Eye;
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(toClip, inverse);
  for (int sample = 0; sample < 9; ++sample)
  {
    const double x = sample % 3 - 0.9, y = 0.8 - sample / 3;
    const glm::dvec3 origin = eye.Origin + x * eye.OriginX + y * eye.OriginY;
    const glm::dvec3 direction =
      glm::normalize(eye.Direction + x * eye.DirectionX + y * eye.DirectionY);
    double before = -1e300;
    for (double depth : { -1.0, 0.3, 0.9 })
    {
      const double clip[4] = { x, y, depth, 1 };
      glm::dvec4 world;
      inverse->MultiplyPoint(clip, &world[0]);
      const glm::dvec3 way =
        placed.Scene.Geometry.WorldToLocal(glm::dvec3(world) / world.w) - origin;
      const double along = glm::dot(way, direction);
      EXPECT_NEAR(glm::length(way - along * direction), 0, tolerance);
      EXPECT_GT(along, before) << "rays run away from the eye";
      before = along;
    }
  }
  EXPECT_EQ(eye.Parallel, camera->GetParallelProjection() != 0);
}
}

TEST(SceneView, RaysOfEveryProjectionPassWhereTheCameraSeesThem)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(4, -5, 30);
  camera->SetFocalPoint(2, 1, 2);
  camera->SetViewUp(0.2, 1, 0.1);
  camera->SetClippingRange(1, 60);
  ExpectRaysOfCamera(camera, 1.7, 1e-11);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(9);
  ExpectRaysOfCamera(camera, 0.6, 1e-11);
  camera->SetWindowCenter(0.4, -0.7);
  ExpectRaysOfCamera(camera, 1, 1e-11);
  camera->ParallelProjectionOff();
  ExpectRaysOfCamera(camera, 1, 1e-11);
  camera->UseOffAxisProjectionOn(); // a head-tracked screen
  camera->SetScreenBottomLeft(-1, -1, -1);
  camera->SetScreenBottomRight(1.5, -1, -1);
  camera->SetScreenTopRight(1.5, 1, -1);
  ExpectRaysOfCamera(camera, 1, 1e-11);
}

// The eye inside the volume, and a mirrored view as of a reflection pass.
TEST(SceneView, RaysStartAtTheEyeInsideAndMirrored)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(3.5, 4, 3.5);
  camera->SetFocalPoint(2, 1, 2);
  camera->SetClippingRange(0.01, 60);
  ExpectRaysOfCamera(camera, 1.3, 1e-10);
  vtkNew<vtkTransform> mirror;
  mirror->Scale(-1, 1, 1);
  camera->SetUserViewTransform(mirror);
  ExpectRaysOfCamera(camera, 1.3, 1e-10);
}

TEST(SceneView, SingularMatricesAreRefused)
{
  Placed placed;
  ASSERT_EQ(placed.Gather(), "");
  vtkNew<vtkMatrix4x4> zero;
  zero->Zero();
  EXPECT_NE(placed.Scene.GatherView(zero).find("singular"), std::string::npos);
}
