// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// FixedStep on heterogeneous media against vtkSingleScatteringReference, which shares none of its code.
#include "ClosedForms.h"
#include "vtkMediumFixtures.h"

#include "vtkSingleScatteringReference.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
const glm::dvec3 Size(1, 0.7, 1.3);
constexpr int Points = 32;
constexpr int Stride = 4;                    // of the pixels that are compared
constexpr double Voxel = 0.7 / (Points - 1); // its shortest edge

/// A field lit by a beam, a point light and a spot light whose cone, of `coneAngle` degrees, either
/// holds the whole box or cuts it.
struct ReferenceScene : Scene
{
  vtkNew<vtkSingleScatteringReference> Reference;
  Picture Truth;
  double Peak = 0;

  explicit ReferenceScene(
    vtkMediumFixtures::Fields field, bool onCells = false, double coneAngle = 60)
    : Scene(vtkMediumFixtures::MakeImage(field, glm::ivec3(Points), Size, onCells), 48)
  {
    this->Mapper->SetTransmittanceThreshold(0);
    this->Medium->SetExtinctionArrayName("");
    this->Medium->SetExtinctionScale(4, 5, 7);
    this->Medium->SetAlbedo(0.9, 0.8, 0.7);
    this->Medium->SetAnisotropy(0.4);
    this->Look({ 0.4, -0.3, -1 }, 2.4);
    this->AddBeam({ 1, -0.8, -0.2 });
    vtkSmartPointer<vtkLight> point = this->AddPointLight({ -0.9, 0.8, 0.5 });
    point->SetDiffuseColor(1, 0.6, 0.3);
    vtkSmartPointer<vtkLight> spot = this->AddPointLight({ 0.2, -1.6, 0.4 });
    spot->SetFocalPoint(0, 0, 0);
    spot->SetConeAngle(coneAngle);
    spot->SetExponent(2);
    spot->SetIntensity(3);
    this->Reference->SetVolume(this->Volume);
    this->Reference->SetMedium(this->Medium);
    this->Reference->SetRenderer(this->Renderer);
    this->Reference->SetPixelStride(Stride);
    this->Reference->SetTolerance(1e-7);
  }

  /// Renders the reference.
  void FindTruth()
  {
    this->Window->Render(); // so that the renderer has its size
    vtkNew<vtkImageData> image;
    ASSERT_TRUE(this->Reference->GetColorImage(image));
    const double* values = static_cast<const double*>(image->GetScalarPointer());
    this->Truth.Size = glm::ivec2(image->GetDimensions()[0], image->GetDimensions()[1]);
    this->Truth.Components = 4;
    this->Truth.Values.assign(values, values + 4 * this->Truth.Size.x * this->Truth.Size.y);
    for (std::size_t i = 0; i < this->Truth.Values.size(); ++i)
    {
      this->Peak = i % 4 < 3 ? std::max(this->Peak, double(this->Truth.Values[i])) : this->Peak;
    }
  }

  struct Errors
  {
    double Largest = 0, RootMeanSquare = 0, Alpha = 0; ///< of radiance: fractions of the peak
  };

  Errors Measure(double step)
  {
    this->SetSteps(step, step);
    const Picture picture = this->Render();
    Errors errors;
    for (int y = 0; y < this->Truth.Size.y; ++y)
    {
      for (int x = 0; x < this->Truth.Size.x; ++x)
      {
        for (int c = 0; c < 4; ++c)
        {
          const double error =
            std::abs(picture.At(Stride * x, Stride * y, c) - this->Truth.At(x, y, c));
          EXPECT_TRUE(std::isfinite(error));
          errors.Alpha = c == 3 ? std::max(errors.Alpha, error) : errors.Alpha;
          errors.Largest = c < 3 ? std::max(errors.Largest, error / this->Peak) : errors.Largest;
          errors.RootMeanSquare += c < 3 ? std::pow(error / this->Peak, 2) : 0;
        }
      }
    }
    errors.RootMeanSquare =
      std::sqrt(errors.RootMeanSquare / (3 * this->Truth.Size.x * this->Truth.Size.y));
    return errors;
  }
};

/// The slope of log error over log step, by least squares.
double Order(const std::vector<double>& steps, const std::vector<double>& errors)
{
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const double u = std::log(steps[i]), v = std::log(errors[i]);
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const double n = static_cast<double>(steps.size());
  return (n * xy - x * y) / (n * xx - x * x);
}
}

TEST(AgainstReference, SmoothFieldConvergesInSecondOrder)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.FindTruth();
  ASSERT_GT(scene.Peak, 0.01);
  std::vector<double> steps, largest, mean;
  // From 2 voxels, beyond which light rays, whose steps come in fours, do not follow the step, to 1/4,
  // below which float's rounding, some 1e-6 of the peak, shows.
  for (double step : { 2 * Voxel, Voxel, 0.5 * Voxel, 0.25 * Voxel })
  {
    const ReferenceScene::Errors errors = scene.Measure(step);
    steps.push_back(step);
    largest.push_back(errors.Largest);
    mean.push_back(errors.RootMeanSquare);
  }
  EXPECT_NEAR(Order(steps, largest), 2, 0.15);
  EXPECT_NEAR(Order(steps, mean), 2, 0.15);
  EXPECT_LT(largest[1], 5e-4); // at the default step, one voxel
}

TEST(AgainstReference, SmoothFieldIsMetClosely)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure(Voxel / 8);
  EXPECT_LT(errors.Largest, 1e-4);
  EXPECT_LT(errors.Alpha, 2e-5);
}

TEST(AgainstReference, ConeThatCutsTheFieldConvergesInFirstOrder)
{
  // Light ends abruptly at the cone: the step that it falls into is lit or not.
  ReferenceScene scene(vtkMediumFixtures::Smooth, false, 12);
  scene.FindTruth();
  std::vector<double> steps, mean;
  for (double step : { 2 * Voxel, Voxel, 0.5 * Voxel, 0.25 * Voxel })
  {
    steps.push_back(step);
    mean.push_back(scene.Measure(step).RootMeanSquare);
  }
  EXPECT_GT(Order(steps, mean), 0.8);
  EXPECT_LT(mean.back(), 2e-3);
}

TEST(AgainstReference, CloudConvergesToTheReference)
{
  // Detail down to the voxel: second order only below it, and less where the cloud's edge clips.
  ReferenceScene scene(vtkMediumFixtures::Cloud);
  scene.FindTruth();
  std::vector<double> steps, mean;
  for (double step : { Voxel, 0.5 * Voxel, 0.25 * Voxel, 0.125 * Voxel })
  {
    steps.push_back(step);
    mean.push_back(scene.Measure(step).RootMeanSquare);
  }
  EXPECT_GT(Order(steps, mean), 1.6);
  EXPECT_LT(mean[0], 5e-3);
  EXPECT_LT(mean.back(), 2e-4);
}

TEST(AgainstReference, BinaryFieldConvergesToTheReference)
{
  // Jumps between neighbouring points are ramps one voxel wide, kinked at both ends.
  for (bool onCells : { false, true })
  {
    SCOPED_TRACE(onCells ? "cells" : "points");
    ReferenceScene scene(vtkMediumFixtures::Binary, onCells);
    scene.FindTruth();
    std::vector<double> steps, mean;
    for (double step : { Voxel, 0.5 * Voxel, 0.25 * Voxel, 0.125 * Voxel })
    {
      steps.push_back(step);
      mean.push_back(scene.Measure(step).RootMeanSquare);
    }
    EXPECT_GT(Order(steps, mean), 1.4);
    EXPECT_LT(mean.back(), 5e-4);
  }
}
