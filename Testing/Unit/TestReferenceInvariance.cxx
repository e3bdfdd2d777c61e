// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What must not change the reference's result: motions, units and how the geometry is stated.
#include "ReferenceSetting.h"

#include "vtkTransform.h"

#include <gtest/gtest.h>

using namespace ReferenceTests;

namespace
{
double Wavy(const glm::dvec3& box)
{
  return 0.5 + 0.25 * std::sin(9 * box.x + 2 * box.y) + 0.25 * std::cos(7 * box.z - 5 * box.x);
}

double SkewedRadiance(const glm::dvec3& size, vtkMatrix4x4* matrix)
{
  Setting setting(MakeGrid({ 9, 8, 7 }, size, Wavy), 4);
  setting.Medium->SetPhaseFunction(vtkParticipatingMedium::HenyeyGreenstein);
  setting.Medium->SetAnisotropy(0.6);
  setting.Volume->SetUserMatrix(matrix);
  const auto light = setting.AddPointLight({ 0.2, 1.4, 0.3 });
  return setting.Radiance({ -1, 0.2, 0.1 }, { 1, 0.3, 0.4 }).x;
}
}

// However spacing and matrix share the geometry between them, the world is the same.
TEST(ReferenceInvariance, SpacingAndMatrixAreOneGeometry)
{
  vtkNew<vtkMatrix4x4> identity, scale;
  const double truth = SkewedRadiance(glm::dvec3(1), identity);
  for (int axis = 0; axis < 3; ++axis)
  {
    scale->SetElement(axis, axis, axis == 0 ? 1e3 : axis == 1 ? 7 : 1e-6);
  }
  EXPECT_NEAR(SkewedRadiance({ 1e-3, 1 / 7.0, 1e6 }, scale) / truth, 1, 1e-9);
  EXPECT_GT(truth, 0);
}

// Volume, light and eye turned and moved together, also mirrored, which turns a determinant negative.
TEST(ReferenceInvariance, MotionsOfTheWholeScene)
{
  double truth = 0;
  for (int motion = 0; motion < 4; ++motion)
  {
    vtkNew<vtkTransform> transform;
    if (motion > 0)
    {
      transform->Translate(3, -2, 40);
      transform->RotateWXYZ(70 * motion, 1, 2, -0.5);
      transform->Scale(motion == 3 ? -1 : 1, 1, 1);
    }
    Setting setting(MakeGrid({ 9, 8, 7 }, glm::dvec3(1), Wavy), 4);
    setting.Medium->SetPhaseFunction(vtkParticipatingMedium::HenyeyGreenstein);
    setting.Medium->SetAnisotropy(-0.4);
    setting.Volume->SetUserMatrix(transform->GetMatrix());
    glm::dvec3 light(0.2, 1.4, 0.3), origin(-1, 0.2, 0.1), target(0.6, 0.5, 0.4);
    transform->TransformPoint(&light[0], &light[0]);
    transform->TransformPoint(&origin[0], &origin[0]);
    transform->TransformPoint(&target[0], &target[0]);
    setting.AddPointLight(light);
    const double value = setting.Radiance(origin, target - origin).x;
    truth = motion == 0 ? value : truth;
    EXPECT_NEAR(value / truth, 1, 1e-9);
  }
}

// Lengths times s and coefficients / s are the same optics: 1e-12 … 1e12.
TEST(ReferenceInvariance, UnitsOfLength)
{
  double truth = 0;
  for (double s : { 1.0, 1e-12, 1e-3, 1e12 })
  {
    Setting setting(MakeGrid({ 9, 8, 7 }, glm::dvec3(s), Wavy), 4 / s);
    setting.AddDirectionalLight(glm::normalize(glm::dvec3(-1, -2, -1.3)));
    const double value = setting.Radiance(glm::dvec3(-1, 0.2, 0.1) * s, { 1, 0.3, 0.4 }).x;
    truth = s == 1 ? value : truth;
    EXPECT_NEAR(value / truth, 1, 1e-9);
  }
}

// A distance of 2^30 leaves 2^-22 of a unit box to a double: rays start that far off.
TEST(ReferenceInvariance, FarFromTheOrigin)
{
  double truth = 0;
  for (double offset : { 0.0, 1048576.0, 1073741824.0 })
  {
    const auto image = MakeGrid({ 9, 9, 9 }, glm::dvec3(1), Wavy);
    image->SetOrigin(offset, -offset, 2 * offset);
    Setting setting(image, 4);
    setting.AddDirectionalLight(glm::normalize(glm::dvec3(-1, -2, -1.3)));
    const glm::dvec3 origin = glm::dvec3(offset, -offset, 2 * offset) + glm::dvec3(-1, 0.25, 0.125);
    const double value = setting.Radiance(origin, { 1, 0.3, 0.4 }).x;
    truth = offset == 0 ? value : truth;
    EXPECT_NEAR(value / truth, 1, 1e-9 + offset * 1e-15);
  }
}
