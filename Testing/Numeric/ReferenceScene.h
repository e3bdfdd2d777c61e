// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceScene.h
 * @brief A heterogeneous scene, its truth by vtkSingleScatteringReference, and the mapper's errors.
 */
#ifndef ReferenceScene_h
#define ReferenceScene_h

#include "ClosedForms.h"
#include "vtkMediumFixtures.h"

#include "vtkSingleScatteringReference.h"

#include <gtest/gtest.h>

namespace vtkMediumTest
{
/// Its box and lattice, and the shortest edge of a voxel.
const glm::dvec3 ReferenceSize(1, 0.7, 1.3);
constexpr int ReferencePoints = 32;
constexpr double ReferenceVoxel = 0.7 / (ReferencePoints - 1);

/// A field lit by a beam, a point light and a spot light whose cone, of `coneAngle` degrees, either
/// holds the whole box or cuts it.
struct ReferenceScene : Scene
{
  vtkNew<vtkSingleScatteringReference> Reference;
  Picture Truth;
  double Peak = 0;
  int Stride = 4; ///< of the pixels that are compared

  explicit ReferenceScene(
    vtkMediumFixtures::Fields field, bool onCells = false, double coneAngle = 60)
    : Scene(
        vtkMediumFixtures::MakeImage(field, glm::ivec3(ReferencePoints), ReferenceSize, onCells),
        48)
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
    this->Reference->SetTolerance(1e-7);
  }

  /// Renders the reference.
  void FindTruth()
  {
    this->Window->Render(); // so that the renderer has its size
    this->Reference->SetPixelStride(this->Stride);
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
    return this->Measure();
  }

  /// Renders with the mapper as it is set and compares with the truth.
  Errors Measure()
  {
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
}

#endif
