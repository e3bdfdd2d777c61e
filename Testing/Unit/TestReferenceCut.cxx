// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes and cropping in the reference: closed forms, laws of geometry, and the volume that is
// left alone. What is cut away neither shines nor casts a shadow. Tolerances: see
// TestReferenceClosedForms.cxx.
#include "ReferenceSetting.h"
#include "vtkMediumFixtures.h"

#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkPlane.h"

#include <gtest/gtest.h>

using namespace ReferenceTests;

namespace
{
constexpr double Tolerance = 1e-9;

double One(const glm::dvec3&)
{
  return 1;
}

double Linear(const glm::dvec3& box)
{
  return 0.3 + 0.5 * box.x + 0.2 * box.y;
}

// A setting whose volume has a mapper, any of VTK's, to carry planes and cropping.
struct CutSetting : Setting
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> Mapper;

  CutSetting(vtkImageData* image, double sigma)
    : Setting(image, sigma)
  {
    this->Mapper->SetInputData(image);
    this->Volume->SetMapper(this->Mapper);
  }

  vtkSmartPointer<vtkPlane> AddPlane(const glm::dvec3& normal, const glm::dvec3& origin)
  {
    auto plane = vtkSmartPointer<vtkPlane>::New();
    plane->SetNormal(normal.x, normal.y, normal.z);
    plane->SetOrigin(origin.x, origin.y, origin.z);
    this->Mapper->AddClippingPlane(plane);
    return plane;
  }

  void Crop(const glm::dvec3& lower, const glm::dvec3& upper, int flags = VTK_CROP_SUBVOLUME)
  {
    this->Mapper->CroppingOn();
    this->Mapper->SetCroppingRegionPlanes(lower.x, upper.x, lower.y, upper.y, lower.z, upper.z);
    this->Mapper->SetCroppingRegionFlags(flags);
  }
};

glm::dvec3 RandomPoint(std::uint32_t index, std::uint32_t seed)
{
  return { vtkMediumFixtures::Random(3 * index, seed),
    vtkMediumFixtures::Random(3 * index + 1, seed),
    vtkMediumFixtures::Random(3 * index + 2, seed) };
}
}

// The eye ray is along x through the centre. The plane is met at x = 0.5, what is before it is removed and
// the light comes from there: at a depth s behind the plane it has passed kappa s of the medium.
TEST(ReferenceCut, ObliquePlaneThroughAHomogeneousBoxHasItsClosedForm)
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 0.3, -0.2));
  const glm::dvec3 travel = glm::normalize(glm::dvec3(1, -0.4, 0.1));
  for (double sigma : { 1e-3, 0.7, 5.0, 40.0 })
  {
    CutSetting setting(MakeGrid({ 9, 8, 7 }, glm::dvec3(1), One), sigma);
    setting.AddDirectionalLight(travel);
    setting.AddPlane(3.0 * normal, { 0.5, 0.5, 0.5 }); // any length of the normal
    const double kappa = normal.x / glm::dot(normal, travel);
    const double truth = sigma * Isotropic * 0.5 * MeanTransmittance(0.5 * sigma * (1 + kappa));
    const glm::dvec4 rgba = setting.Radiance({ -2, 0.5, 0.5 }, { 3, 0, 0 });
    EXPECT_NEAR(rgba.x / truth, 1, Tolerance) << "sigma " << sigma;
    EXPECT_NEAR(rgba.w / -std::expm1(-0.5 * sigma), 1, 1e-12);
  }
}

TEST(ReferenceCut, PlaneThatTouchesNothingChangesNothingAndOneThatHoldsNothingLeavesNothing)
{
  CutSetting setting(MakeGrid({ 5, 5, 5 }, glm::dvec3(1), Linear), 3);
  setting.AddPointLight({ 0.3, 2, 0.4 });
  const glm::dvec3 eye(-1, 0.2, 0.3), direction(1, 0.2, 0.1);
  const glm::dvec4 whole = setting.Radiance(eye, direction);
  vtkSmartPointer<vtkPlane> plane = setting.AddPlane({ 1, 1, 0 }, { -0.1, 0, 0 });
  EXPECT_EQ(setting.Radiance(eye, direction), whole);
  plane->SetNormal(-1, -1, 0); // moved: the reference notices
  EXPECT_EQ(setting.Radiance(eye, direction), glm::dvec4(0));
}

// The half that is left, alone, for a field that is linear on either grid.
TEST(ReferenceCut, RemovedHalfCastsNoShadow)
{
  const glm::dvec3 eye(-1, 0.21, 0.33), direction(1, 0.25, 0.12);
  const auto half = [](const glm::dvec3& box) { return Linear({ 0.5 * box.x, box.y, box.z }); };
  for (bool positional : { false, true })
  {
    CutSetting cut(MakeGrid({ 9, 5, 5 }, glm::dvec3(1), Linear), 6);
    CutSetting alone(MakeGrid({ 5, 5, 5 }, { 0.5, 1, 1 }, half), 6);
    cut.AddPlane({ -1, 0, 0 }, { 0.5, 0, 0 });
    for (CutSetting* setting : { &cut, &alone })
    {
      positional ? setting->AddPointLight({ 1.4, 0.7, 0.6 })
                 : setting->AddDirectionalLight(glm::normalize(glm::dvec3(-1, -0.2, -0.3)));
    }
    const glm::dvec4 expected = alone.Radiance(eye, direction);
    EXPECT_NEAR(cut.Radiance(eye, direction).x / expected.x, 1, Tolerance);
    cut.Mapper->RemoveAllClippingPlanes(); // not so with the half
    EXPECT_LT(
      cut.Radiance(eye, { 1, 1e-3, 1e-3 }).x, 0.9 * alone.Radiance(eye, { 1, 1e-3, 1e-3 }).x);
  }
}

// In the image's coordinates: its origin counts and the volume's matrix does not.
TEST(ReferenceCut, SubVolumeIsTheBoxThatItBounds)
{
  const glm::dvec3 lower(0.2, 0.3, 0.1), upper(0.7, 0.8, 0.9);
  vtkSmartPointer<vtkImageData> image = MakeGrid({ 9, 5, 6 }, glm::dvec3(1), One);
  vtkSmartPointer<vtkImageData> small = MakeGrid({ 3, 3, 3 }, upper - lower, One);
  image->SetOrigin(10, 20, 30);
  small->SetOrigin(10 + lower.x, 20 + lower.y, 30 + lower.z);
  CutSetting cropped(image, 4), alone(small, 4);
  cropped.Crop(lower + glm::dvec3(10, 20, 30), upper + glm::dvec3(10, 20, 30));
  for (CutSetting* setting : { &cropped, &alone })
  {
    setting->Volume->SetPosition(-10, -20, -30);
    setting->Volume->RotateZ(20);
    setting->AddDirectionalLight(glm::normalize(glm::dvec3(0.3, -1, 0.4)));
    setting->AddPointLight({ 0.5, 0.4, 2 });
  }
  glm::dvec3 center(10.5, 20.5, 30.5);
  const glm::dvec4 world(center, 1);
  vtkMatrix4x4* matrix = cropped.Volume->GetMatrix();
  glm::dvec4 target;
  matrix->MultiplyPoint(&world[0], &target[0]);
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3 direction = vtkMediumFixtures::RandomDirection(i, 3);
    const glm::dvec3 eye = glm::dvec3(target) - 3.0 * direction;
    const double expected = alone.Radiance(eye, direction).x;
    ASSERT_GT(expected, 1e-3);
    EXPECT_NEAR(cropped.Radiance(eye, direction).x / expected, 1, Tolerance);
  }
}

// Each of 27 regions by itself, and any choice of them together.
TEST(ReferenceCut, OpticalDepthIsTheSumOfThatOfTheKeptRegions)
{
  CutSetting setting(
    MakeGrid({ 6, 7, 8 }, glm::dvec3(1),
      [](const glm::dvec3& box) { return 0.1 + box.x * box.y + 0.3 * box.z * box.x; }),
    2);
  const glm::dvec3 lower(0.25, 0.4, 0.3), upper(0.6, 0.75, 0.85);
  for (int ray = 0; ray < 6; ++ray)
  {
    const glm::dvec3 a = 3.0 * RandomPoint(2 * ray, 5) - 1.0, b = 1.0 - a; // through the centre
    setting.Mapper->CroppingOff();
    const double whole = setting.OpticalDepth(a, b);
    double depths[27], sum = 0;
    for (int region = 0; region < 27; ++region)
    {
      setting.Crop(lower, upper, 1 << region);
      depths[region] = setting.OpticalDepth(a, b);
      sum += depths[region];
    }
    EXPECT_NEAR(sum / whole, 1, 1e-12);
    for (int flags : { VTK_CROP_SUBVOLUME, VTK_CROP_FENCE, VTK_CROP_INVERTED_FENCE, VTK_CROP_CROSS,
           VTK_CROP_INVERTED_CROSS, 0x0, 0x7ffffff, 0x1234567, 0x38, 0xfff })
    {
      double expected = 0;
      for (int region = 0; region < 27; ++region)
      {
        expected += flags >> region & 1 ? depths[region] : 0;
      }
      setting.Crop(lower, upper, flags);
      EXPECT_NEAR(setting.OpticalDepth(a, b), expected, 1e-12 * whole) << "flags " << flags;
    }
  }
}

// x is the lowest digit of a region's number, as in VTK.
TEST(ReferenceCut, RegionsAreNumberedAsInVTK)
{
  CutSetting setting(MakeGrid({ 4, 4, 4 }, glm::dvec3(1), One), 1);
  const glm::dvec3 step(0.2),
    here = glm::dvec3(5, 1, 3) / 6.0; // above in x, below in y, between in z
  setting.Crop(glm::dvec3(1 / 3.0), glm::dvec3(2 / 3.0), 1 << (2 + 3 * 0 + 9 * 1));
  EXPECT_GT(setting.OpticalDepth(here - 0.1 * step, here + 0.1 * step), 0);
  setting.Mapper->SetCroppingRegionFlags(0x7ffffff & ~(1 << (2 + 3 * 0 + 9 * 1)));
  EXPECT_EQ(setting.OpticalDepth(here - 0.1 * step, here + 0.1 * step), 0);
}

// Finer parts agree with coarse ones: the edges of shadows are where the integrator looks for them.
TEST(ReferenceCut, SeveralPlanesAndAFenceAgreeWithATighterTolerance)
{
  CutSetting setting(MakeGrid({ 9, 9, 9 }, glm::dvec3(1),
                       [](const glm::dvec3& box) { return 1 + box.x * box.y * box.z; }),
    8);
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(-1, -0.6, 0.3)));
  setting.AddPointLight({ 0.5, 0.5, 0.45 }); // within
  setting.AddPlane({ -1, 0.3, 0.1 }, { 0.85, 0.5, 0.5 });
  setting.AddPlane({ 0.2, 1, -0.4 }, { 0.5, 0.2, 0.5 });
  setting.Crop({ 0.3, 0.25, 0.35 }, { 0.7, 0.6, 0.65 }, VTK_CROP_FENCE);
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3 direction = vtkMediumFixtures::RandomDirection(i, 11);
    const glm::dvec3 eye = glm::dvec3(0.5, 0.45, 0.5) - 3.0 * direction;
    setting.Reference->SetTolerance(1e-6);
    const double coarse = setting.Radiance(eye, direction).x;
    setting.Reference->SetTolerance(1e-11);
    const double fine = setting.Radiance(eye, direction).x;
    ASSERT_GT(fine, 1e-4);
    EXPECT_NEAR(coarse / fine, 1, 1e-6);
  }
}
