// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The reference asked from far away, and from no place at all. Random bytes found it searching without end here.
#include "ReferenceSetting.h"

#include "vtkLightCollection.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <limits>

using namespace ReferenceTests;

namespace
{
double Wavy(const glm::dvec3& box)
{
  return 1 + 0.5 * std::sin(7 * box.x + 3 * box.y) * std::cos(5 * box.z);
}

struct WavySetting : Setting
{
  WavySetting()
    : Setting(MakeGrid({ 9, 8, 7 }, glm::dvec3(1), Wavy), 4)
  {
    this->AddDirectionalLight(glm::normalize(glm::dvec3(-1, -2, -1.3)));
    this->AddPointLight({ 0.3, 1.5, 0.4 });
  }
};

const double NoNumbers[] = { 1e200, -1e300, std::numeric_limits<double>::infinity(), std::nan("") };
}

// Along an axis no digit is lost.
TEST(ReferencePlaces, ARayIsTheSameFromHoweverFarItComes)
{
  WavySetting setting;
  const glm::dvec4 near = setting.Radiance({ -1, 0.3, 0.6 }, { 1, 0, 0 });
  ASSERT_GT(near.x, 0.001);
  for (double distance : { 3.0, 1e4, 1e12, 1e17, 1e80, 1e149 })
  {
    const glm::dvec4 far = setting.Radiance({ -distance, 0.3, 0.6 }, { 1, 0, 0 });
    EXPECT_NEAR(glm::length(far - near), 0, 1e-12) << distance;
    const glm::dvec4 away = setting.Radiance({ -distance, 0.3, 0.6 }, { -1, 0, 0 });
    EXPECT_EQ(away, glm::dvec4(0)) << distance;
    const glm::dvec4 beside = setting.Radiance({ -distance, 0.3, 1.01 }, { 1, 0, 0 });
    EXPECT_EQ(beside, glm::dvec4(0)) << distance;
  }
}

// A direction's last digit, 1e-16, is 1e-8 of a diagonal at the end of 1e8 of them.
TEST(ReferencePlaces, AnObliqueRayIsTheSameWithinTheDigitsOfItsDirection)
{
  WavySetting setting;
  const glm::dvec3 target(0.4, 0.6, 0.5), way(0.3, -0.7, 0.4);
  const double near = setting.Radiance(target - 2.0 * way, way).x;
  for (double distance : { 1e2, 1e5, 1e8 })
  {
    EXPECT_NEAR(
      setting.Radiance(target - distance * way, way).x / near, 1, 1e-14 * (1e2 + distance));
  }
}

TEST(ReferencePlaces, OpticalDepthBetweenANearPlaceAndAFarOne)
{
  WavySetting setting;
  const glm::dvec3 inside(0.4, 0.6, 0.5);
  const double near = setting.OpticalDepth(inside, { -1, 0.6, 0.5 });
  ASSERT_GT(near, 0.1);
  for (double distance : { 1e4, 1e17, 1e149 })
  {
    const glm::dvec3 far(-distance, 0.6, 0.5);
    EXPECT_NEAR(setting.OpticalDepth(inside, far), near, 1e-12) << distance;
    EXPECT_NEAR(setting.OpticalDepth(far, inside), near, 1e-12) << distance;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(&far[0]);
    const auto lamp = setting.AddPointLight(inside);
    vtkNew<vtkDoubleArray> passed;
    ASSERT_TRUE(setting.Reference->LightTransmittance(lamp, points, passed));
    EXPECT_NEAR(passed->GetValue(0), std::exp(-near), 1e-12) << distance;
  }
}

// Parallel rays come from the near plane, wherever it is.
TEST(ReferencePlaces, AParallelCameraSeesTheSameFromHoweverFar)
{
  WavySetting setting;
  setting.Reference->SetImageSize(5, 4);
  vtkCamera* camera = setting.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.7);
  vtkNew<vtkImageData> near, far;
  for (double distance : { 2.0, 1e6 })
  {
    camera->SetFocalPoint(0.5, 0.5, 0.5);
    camera->SetPosition(0.5, 0.5, 0.5 + distance);
    camera->SetClippingRange(distance - 1, distance + 1);
    ASSERT_TRUE(setting.Reference->GetColorImage(distance == 2 ? near : far));
  }
  for (vtkIdType value = 0; value < 4 * 20; ++value)
  {
    const auto at = [value](vtkImageData* image) {
      return static_cast<double*>(image->GetScalarPointer())[value];
    };
    EXPECT_NEAR(at(far), at(near), 1e-9) << value; // the matrix keeps 1e-16 of 1e6
  }
}

TEST(ReferencePlaces, NoPlaceIsRefusedByOneErrorAndTheNextCallWorks)
{
  WavySetting setting;
  vtkSingleScatteringReference* reference = setting.Reference;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(1);
  vtkNew<vtkDoubleArray> passed;
  for (double none : NoNumbers)
  {
    const double here[3] = { 0.5, 0.5, 0.5 }, far[3] = { 0, none, 0 };
    points->SetPoint(0, far);
    double rgba[4];
    const std::function<bool()> questions[] = {
      [&]() { return reference->Radiance(far, here, rgba); },
      [&]() { return !std::isnan(reference->OpticalDepth(here, far)); },
      [&]() { return !std::isnan(reference->Transmittance(far, here)); },
      [&]() {
        return reference->LightTransmittance(
          vtkLight::SafeDownCast(setting.Renderer->GetLights()->GetItemAsObject(0)), points,
          passed);
      },
    };
    for (const auto& question : questions)
    {
      Errors errors(reference);
      EXPECT_FALSE(question());
      EXPECT_TRUE(errors.IsOne("give a point near the volume")) << none;
    }
    EXPECT_EQ(passed->GetNumberOfTuples(), 0);
  }
  EXPECT_GT(setting.Radiance({ -1, 0.3, 0.6 }, { 1, 0, 0 }).x, 0.001);
}

TEST(ReferencePlaces, DirectionsOfAnyFiniteLength)
{
  WavySetting setting;
  const glm::dvec3 origin(-1, 0.3, 0.6);
  const double truth = setting.Radiance(origin, { 1, 0.25, 0 }).x;
  for (double length : { 1e-300, 1e-170, 1e170, 1e307 })
  {
    EXPECT_NEAR(setting.Radiance(origin, length * glm::dvec3(1, 0.25, 0)).x, truth, 1e-14)
      << length;
  }
  for (double none : { 0.0, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    Errors errors(setting.Reference);
    EXPECT_EQ(setting.Radiance(origin, { none, 0, 0 }), glm::dvec4(0));
    EXPECT_TRUE(errors.IsOne("direction")) << none;
  }
}

TEST(ReferencePlaces, CamerasAndLampsAtNoPlaceAreRefused)
{
  for (bool parallel : { false, true })
  {
    WavySetting setting;
    setting.Reference->SetImageSize(2, 2);
    vtkCamera* camera = setting.Renderer->GetActiveCamera();
    camera->SetParallelProjection(parallel);
    for (double none : { 1e152, 1e200, 1e300 })
    {
      camera->SetPosition(0, 0, none);
      Errors errors(setting.Reference);
      vtkNew<vtkImageData> image;
      EXPECT_FALSE(setting.Reference->GetColorImage(image));
      EXPECT_TRUE(errors.IsOne("camera")) << none;
    }
    camera->SetPosition(0, 0, 5);
    vtkNew<vtkImageData> image;
    EXPECT_TRUE(setting.Reference->GetColorImage(image));
    setting.AddPointLight({ 0, 1e200, 0 });
    Errors errors(setting.Reference);
    EXPECT_FALSE(setting.Reference->GetColorImage(image));
    EXPECT_TRUE(errors.IsOne("1e+200"));
  }
}
