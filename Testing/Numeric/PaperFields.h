// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PaperFields.h
 * @brief A ball and slabs as distance fields, whose threshold 0 is their surface.
 */
#ifndef PaperFields_h
#define PaperFields_h

#include "ClosedForms.h"

namespace vtkMediumTest
{
constexpr double BallRadius = 0.8;
/// Spacing h of the ball's grid, and how far its trilinear surface is from the true one: h^2 / 8 times
/// the sum of the field's curvatures, 2 / R.
constexpr double BallSpacing = 2.0 / 63;
constexpr double BallSurfaceError = BallSpacing * BallSpacing / (4 * BallRadius);

inline vtkSmartPointer<vtkImageData> MakeBall()
{
  return MakeImage(
    glm::ivec3(64), glm::dvec3(2), [](const glm::dvec3& p) { return BallRadius - glm::length(p); });
}

/// Two slabs 0.1 < |z| < 0.4 in a wide box |z| < 0.5. The field is linear between grid planes, so that
/// the slabs' faces are exact.
inline vtkSmartPointer<vtkImageData> MakeTwoSlabs()
{
  return MakeImage({ 2, 2, 21 }, { 8, 8, 1 },
    [](const glm::dvec3& p) { return 0.15 - std::abs(std::abs(p.z) - 0.25); });
}

/// One slab |z| < 0.3 in a wide box |z| < 0.5.
inline vtkSmartPointer<vtkImageData> MakeSlab()
{
  return MakeImage(
    { 2, 2, 21 }, { 8, 8, 1 }, [](const glm::dvec3& p) { return 0.3 - std::abs(p.z); });
}

/// A scene that the Paper integrator draws, without jitter, of the filled part of the image.
struct PaperScene : Scene
{
  explicit PaperScene(vtkImageData* image, int pixels = 24)
    : Scene(image, pixels)
  {
    this->Mapper->SetIntegratorToPaper();
    this->Mapper->SetPaperThreshold(0);
    this->Mapper->SetJitter(0);
    this->Mapper->SetTransmittanceThreshold(0);
    this->Mapper->SetBinarySearchIterations(10);
  }
};
}

#endif
