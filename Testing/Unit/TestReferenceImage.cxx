// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The reference's image: its pixels, its energy, its events and its errors.
#include "ReferenceSetting.h"
#include "vtkMediumFixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace ReferenceTests;

namespace
{
double Blob(const glm::dvec3& box) // vanishes with its slope at the faces of the box
{
  const glm::dvec3 s(std::sin(Pi * box.x), std::sin(Pi * box.y), std::sin(Pi * box.z));
  return std::pow(s.x * s.y * s.z, 2) * (1 + 0.7 * std::sin(5 * box.x + 3 * box.y));
}

// Sum of pixel x area over a parallel view along `view`, lit along `light`.
double Flux(const glm::dvec3& view, const glm::dvec3& light, double sigma)
{
  Setting setting(MakeGrid(glm::ivec3(13), glm::dvec3(1), Blob), sigma);
  setting.AddDirectionalLight(light);
  vtkCamera* camera = setting.Renderer->GetActiveCamera();
  const glm::dvec3 position = glm::dvec3(0.5) - 2.0 * view;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.9);
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(0.5, 0.5, 0.5);
  camera->SetViewUp(std::abs(view.z) < 0.9 ? 0 : 1, 0, std::abs(view.z) < 0.9 ? 1 : 0);
  camera->SetClippingRange(0.1, 4);
  setting.Reference->SetTolerance(1e-5);
  setting.Reference->SetImageSize(40, 40);
  vtkNew<vtkImageData> image;
  EXPECT_TRUE(setting.Reference->GetColorImage(image));
  double sum = 0;
  for (int i = 0; i < 1600; ++i)
  {
    sum += static_cast<double*>(image->GetScalarPointer())[4 * i];
  }
  return sum * std::pow(1.8 / 40, 2);
}
}

// Light path and eye path may be exchanged: who looks along the light, lit along the view, sees the
// same flux. `view` is the way from the eye.
// 40 x 40 pixels of a field that ends smoothly sum to about 1e-4.
TEST(ReferenceImage, ReciprocityOnTenPairs)
{
  for (int pair = 0; pair < 10; ++pair)
  {
    const glm::dvec3 view = vtkMediumFixtures::RandomDirection(pair, 11);
    const glm::dvec3 light = vtkMediumFixtures::RandomDirection(pair, 12);
    EXPECT_NEAR(Flux(view, light, 6) / Flux(light, view, 6), 1, 1e-3) << "pair " << pair;
  }
}

// A thin medium scatters p E int sigma_s dV; the integral of a trilinear field is the sum of its values
// (its border is 0). The optical depth is below 1e-4.
TEST(ReferenceImage, ThinMediumScattersInProportionToItsVolume)
{
  double integral = 0;
  for (int point = 0; point < 13 * 13 * 13; ++point)
  {
    integral += Blob(glm::dvec3(point % 13, point / 13 % 13, point / 169) / 12.0) / (12 * 12 * 12);
  }
  const double flux = Flux(glm::normalize(glm::dvec3(1, 2, 3)), { 0, 0, 1 }, 1e-4);
  EXPECT_NEAR(flux / (1e-4 * Isotropic * integral), 1, 1e-3);
}

// Pixel (i, j) is the ray through the centre that vtkCamera itself finds by undoing its projection.
TEST(ReferenceImage, PixelsAreTheCamerasRays)
{
  for (bool parallel : { false, true })
  {
    Setting setting(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Smooth, glm::ivec3(9)), 5);
    setting.AddDirectionalLight(glm::normalize(glm::dvec3(-1, -2, -1.3)));
    vtkCamera* camera = setting.Renderer->GetActiveCamera();
    camera->SetPosition(1, 1.5, 2);
    camera->SetClippingRange(0.5, 6);
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(0.6);
    camera->SetWindowCenter(0.1, -0.2);
    const int width = 10, height = 6, stride = 3;
    setting.Reference->SetImageSize(width, height);
    setting.Reference->SetPixelStride(stride);
    vtkNew<vtkImageData> image;
    ASSERT_TRUE(setting.Reference->GetColorImage(image));
    ASSERT_EQ(image->GetDimensions()[0], 4);
    ASSERT_EQ(image->GetDimensions()[1], 2);
    vtkNew<vtkMatrix4x4> inverse;
    vtkMatrix4x4::Invert(
      camera->GetCompositeProjectionTransformMatrix(double(width) / height, -1, 1), inverse);
    double brightest = 0;
    for (int pixel = 0; pixel < 8; ++pixel)
    {
      const int i = pixel % 4 * stride, j = pixel / 4 * stride;
      glm::dvec3 ends[2];
      for (int end = 0; end < 2; ++end)
      {
        const double clip[4] = { 2 * (i + 0.5) / width - 1, 2 * (j + 0.5) / height - 1,
          end ? 1.0 : -1.0, 1 };
        glm::dvec4 world;
        inverse->MultiplyPoint(clip, &world[0]);
        ends[end] = glm::dvec3(world) / world.w;
      }
      const glm::dvec4 truth = setting.Radiance(ends[0], ends[1] - ends[0]);
      for (int c = 0; c < 4; ++c)
      {
        EXPECT_NEAR(
          image->GetScalarComponentAsDouble(i / stride, j / stride, 0, c), truth[c], 1e-9);
      }
      brightest = std::max(brightest, truth.x);
    }
    EXPECT_GT(brightest, 1e-3);
  }
}

TEST(ReferenceImage, StartsAtTheNearPlane)
{
  Setting setting(MakeGrid(glm::ivec3(5), glm::dvec3(1), [](const glm::dvec3&) { return 1.0; }), 2);
  vtkCamera* camera = setting.Renderer->GetActiveCamera();
  camera->SetPosition(0.5, 0.5, 3);
  camera->SetFocalPoint(0.5, 0.5, 0);
  camera->SetClippingRange(2.25, 9); // 0.75 of the box is left
  setting.Reference->SetImageSize(1, 1);
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(setting.Reference->GetColorImage(image));
  EXPECT_NEAR(image->GetScalarComponentAsDouble(0, 0, 0, 3), -std::expm1(-2 * 0.75), 1e-12);
}

TEST(ReferenceImage, ReportsProgressAndAborts)
{
  Setting setting(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Smooth, glm::ivec3(9)), 5);
  setting.Reference->SetImageSize(20, 20);
  vtkNew<vtkCallbackCommand> progress;
  double last = 0;
  progress->SetClientData(&last);
  progress->SetCallback([](vtkObject*, unsigned long, void* client, void* call) {
    EXPECT_GT(*static_cast<double*>(call), *static_cast<double*>(client));
    *static_cast<double*>(client) = *static_cast<double*>(call);
  });
  setting.Reference->AddObserver(vtkCommand::ProgressEvent, progress);
  vtkNew<vtkImageData> image;
  EXPECT_TRUE(setting.Reference->GetColorImage(image));
  EXPECT_EQ(last, 1);

  progress->SetCallback([](vtkObject* caller, unsigned long, void*, void*) {
    static_cast<vtkSingleScatteringReference*>(caller)->AbortExecuteOn();
  });
  vtkNew<vtkImageData> untouched;
  EXPECT_FALSE(setting.Reference->GetColorImage(untouched));
  EXPECT_EQ(untouched->GetNumberOfPoints(), 0);
}

TEST(ReferenceImage, EachCauseIsOneErrorAndTheNextValidCallWorks)
{
  vtkNew<vtkSingleScatteringReference> empty;
  const double a[3] = { 0, 0, 0 }, b[3] = { 1, 0, 0 };
  double rgba[4];
  {
    Errors errors(empty);
    EXPECT_TRUE(std::isnan(empty->OpticalDepth(a, b)));
    EXPECT_TRUE(errors.IsOne("SetInputData"));
  }
  Setting setting(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Smooth, glm::ivec3(9)), 5);
  vtkSingleScatteringReference* reference = setting.Reference;
  {
    Errors errors(reference);
    EXPECT_FALSE(reference->Radiance(a, a, rgba));
    EXPECT_TRUE(errors.IsOne("direction"));
  }
  {
    Errors errors(reference);
    const double far[3] = { 1e200, 0, 0 };
    EXPECT_TRUE(std::isnan(reference->OpticalDepth(a, far)));
    EXPECT_TRUE(errors.IsOne("1e+200"));
  }
  {
    Errors errors(reference);
    vtkNew<vtkImageData> image;
    EXPECT_FALSE(reference->GetColorImage(image));
    EXPECT_TRUE(errors.IsOne("SetImageSize"));
  }
  {
    Errors errors(reference);
    reference->SetRenderer(nullptr);
    EXPECT_FALSE(reference->Radiance(a, b, rgba));
    EXPECT_TRUE(errors.IsOne("SetRenderer"));
  }
  reference->SetRenderer(setting.Renderer);
  {
    Errors errors(reference);
    reference->SetTolerance(std::nan("")); // which clamping lets through
    EXPECT_FALSE(reference->Radiance(a, b, rgba));
    EXPECT_TRUE(errors.IsOne("SetTolerance"));
  }
  reference->SetTolerance(1e-6);
  Errors errors(reference);
  EXPECT_TRUE(reference->Radiance(a, b, rgba));
  EXPECT_GT(rgba[3], 0);
  EXPECT_TRUE(errors.Messages.empty());
}

// What is changed after a question counts in the next.
TEST(ReferenceImage, ChangesAreSeen)
{
  const auto image = MakeGrid(glm::ivec3(4), glm::dvec3(1), [](const glm::dvec3&) { return 1.0; });
  Setting setting(image, 1);
  const glm::dvec3 a(-1, 0.5, 0.5), b(2, 0.5, 0.5);
  EXPECT_NEAR(setting.OpticalDepth(a, b), 1, 1e-14);
  setting.Medium->SetExtinctionScale(3);
  EXPECT_NEAR(setting.OpticalDepth(a, b), 3, 1e-14);
  image->GetPointData()->GetScalars()->FillComponent(0, 2);
  image->GetPointData()->GetScalars()->Modified();
  EXPECT_NEAR(setting.OpticalDepth(a, b), 6, 1e-14);
  setting.Volume->SetScale(2, 1, 1);
  EXPECT_NEAR(setting.OpticalDepth(a, b), 12, 1e-13);
  const auto light = setting.AddDirectionalLight({ 0, 0, 1 });
  const double before = setting.Radiance(a, b - a).x;
  light->SetIntensity(2);
  EXPECT_NEAR(setting.Radiance(a, b - a).x / before, 2, 1e-9);
  EXPECT_GT(before, 0);
}
