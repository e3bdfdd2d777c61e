// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Several volumes in one renderer: each in its own light, blended back to front.
#include "ClosedForms.h"

#include "vtkActor.h"
#include "vtkBackToFrontVolumeCuller.h"
#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
/// Another volume for a scene, homogeneous as that of the scene.
struct Guest
{
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkSingleScatteringVolumeMapper> Mapper;

  explicit Guest(vtkImageData* image)
  {
    this->Mapper->SetInputData(image);
    this->Mapper->SetMedium(this->Medium);
    this->Mapper->SetIntegratorToFixedStep();
    this->Volume->SetMapper(this->Mapper);
  }
};

/// A box of the medium where it is, and what it shows of one ray.
struct Placed
{
  Box Shape;
  double Sigma;
  double Albedo;

  double Depth(const Ray& ray) const
  {
    const std::array<double, 2> t = this->Shape.Intersect(ray);
    return this->Sigma * std::max(t[1] - t[0], 0.0);
  }
  double Radiance(const Ray& ray, const glm::dvec3& toLight) const
  {
    return this->Albedo * BoxRadiance(this->Shape, ray, toLight, this->Sigma);
  }
};

Placed Place(
  vtkVolume* volume, const glm::dvec3& size, const glm::dvec3& at, double sigma, double albedo)
{
  volume->SetPosition(at.x, at.y, at.z);
  Box box(size);
  box.Origin += at;
  return { box, sigma, albedo };
}

/// Two boxes one behind the other, of 0.9 x 0.7 x 0.6 and 0.6 x 0.8 x 0.5 around z = -0.6 and z = 0.6.
struct TwoBoxes : Scene
{
  const glm::dvec3 Sizes[2] = { { 0.9, 0.7, 0.6 }, { 0.6, 0.8, 0.5 } };
  const glm::dvec3 ToLight = glm::normalize(glm::dvec3(0.3, 0.2, -1));
  static constexpr double Irradiance = 6;
  Guest Second;
  Placed Boxes[2];

  explicit TwoBoxes(bool secondFirst)
    : Scene(MakeBox({ 0.9, 0.7, 0.6 }), 24)
    , Second(MakeBox({ 0.6, 0.8, 0.5 }))
    , Boxes{ Place(this->Volume, Sizes[0], { 0, 0, -0.6 }, 1.2, 1),
      Place(this->Second.Volume, Sizes[1], { 0.1, 0, 0.6 }, 2.5, 0.2) }
  {
    this->Medium->SetExtinction(1.2);
    this->Second.Medium->SetExtinction(2.5);
    this->Second.Medium->SetAlbedo(0.2);
    this->SetSteps(0.01, 0.1);
    this->Second.Mapper->SetSampleDistance(0.01);
    this->AddBeam(-this->ToLight)->SetIntensity(Irradiance);
    this->Renderer->AddVolume(this->Second.Volume);
    if (secondFirst)
    {
      this->Renderer->RemoveVolume(this->Volume);
      this->Renderer->AddVolume(this->Volume);
    }
  }

  /// What the window shows when box `near` is blended over the other, 0 to 1.
  double Blended(const Ray& ray, int near) const
  {
    const double phase = Irradiance * Isotropic;
    const double front = phase * this->Boxes[near].Radiance(ray, this->ToLight);
    const double behind = phase * this->Boxes[1 - near].Radiance(ray, this->ToLight);
    return front + std::exp(-this->Boxes[near].Depth(ray)) * behind;
  }
};

void ExpectBackToFront(TwoBoxes& scene)
{
  for (double side : { 1.0, -1.0 }) // box 1 is at z > 0
  {
    scene.Look({ 0, 0, -side }, 4);
    const int near = side > 0 ? 1 : 0;
    const std::vector<unsigned char> shown = scene.RenderWindow();
    double wrong = 0;
    ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
      const double truth = 255 * scene.Blended(ray, near);
      ASSERT_LT(truth, 255);
      // The window rounds to bytes twice.
      ASSERT_NEAR(shown[3 * (y * scene.Pixels + x)], truth, 1.1) << x << ", " << y;
      wrong = std::max(wrong, std::abs(255 * scene.Blended(ray, 1 - near) - truth));
    });
    EXPECT_GT(wrong, 20) << "the other order shows";
  }
}

/// Three props of a list, in the order in which a culler leaves them.
std::vector<vtkProp*> Order(Scene& scene, std::vector<vtkProp*> props)
{
  vtkNew<vtkBackToFrontVolumeCuller> culler;
  int count = static_cast<int>(props.size()), initialized = 0;
  EXPECT_EQ(culler->Cull(scene.Renderer, props.data(), count, initialized), props.size());
  EXPECT_EQ(initialized, 1);
  EXPECT_EQ(count, props.size());
  return props;
}
}

//------------------------------------------------------------------------------
// C = C_near + T_near C_far, each C in the light that its own medium leaves.
TEST(SeveralVolumes, AreBlendedBackToFrontFromEitherSide)
{
  for (bool secondFirst : { false, true })
  {
    TwoBoxes scene(secondFirst);
    vtkNew<vtkBackToFrontVolumeCuller> culler;
    scene.Renderer->GetCullers()->AddItem(culler);
    ExpectBackToFront(scene);
  }
}

//------------------------------------------------------------------------------
// VTK's own way to sort, which serves volumes of about the same size.
TEST(SeveralVolumes, AreBlendedBackToFrontBySortedCentres)
{
  for (bool secondFirst : { false, true })
  {
    TwoBoxes scene(secondFirst);
    auto* culler =
      vtkFrustumCoverageCuller::SafeDownCast(scene.Renderer->GetCullers()->GetLastItem());
    ASSERT_NE(culler, nullptr);
    culler->SetSortingStyleToBackToFront();
    ExpectBackToFront(scene);
  }
}

//------------------------------------------------------------------------------
// The eye sees the small box before the long one, whose centre is nearer.
TEST(SeveralVolumes, LongVolumeBesideAShortOneIsDrawnInItsPlace)
{
  for (bool parallel : { false, true })
  {
    Scene scene(MakeBox({ 0.2, 0.2, 0.2 }), 8);
    Guest wall(MakeBox({ 0.1, 8, 0.1 }));
    scene.Volume->SetPosition(0, 3.5, 0.3);
    scene.Look({ 0, 0, -1 }, 1, { 0, 0, 0 });
    scene.Camera->SetParallelProjection(parallel);
    vtkProp* small = scene.Volume;
    vtkProp* large = wall.Volume;
    const std::vector<vtkProp*> largeFirst = { large, small }, smallFirst = { small, large };
    EXPECT_EQ(Order(scene, smallFirst), largeFirst) << parallel;
    EXPECT_EQ(Order(scene, largeFirst), largeFirst) << parallel;
    scene.Look({ 0, 0, 1 }, 1, { 0, 0, 0 }); // from behind
    EXPECT_EQ(Order(scene, largeFirst), smallFirst) << parallel;
  }
}

//------------------------------------------------------------------------------
TEST(SeveralVolumes, OtherPropsKeepTheirPlaces)
{
  Scene scene(MakeBox(), 8);
  Guest behind(MakeBox());
  behind.Volume->SetPosition(0, 0, -2);
  vtkNew<vtkActor> one, two;
  const std::vector<vtkProp*> added = { one, scene.Volume, two, behind.Volume };
  const std::vector<vtkProp*> ordered = { one, behind.Volume, two, scene.Volume };
  EXPECT_EQ(Order(scene, added), ordered);
  EXPECT_EQ(Order(scene, ordered), ordered);
}

//------------------------------------------------------------------------------
TEST(SeveralVolumes, OverlappingVolumesAreDrawnByTheirCentres)
{
  Scene scene(MakeBox(), 8);
  Guest other(MakeBox());
  other.Volume->SetPosition(0, 0, 0.4);
  const std::vector<vtkProp*> ordered = { scene.Volume, other.Volume };
  EXPECT_EQ(Order(scene, { other.Volume, scene.Volume }), ordered);
  EXPECT_EQ(Order(scene, { scene.Volume, other.Volume }), ordered);
}
