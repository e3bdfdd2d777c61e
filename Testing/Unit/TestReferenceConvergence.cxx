// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The reference against brute force, which knows nothing of cells, kinks and shadows.
#include "ReferenceSetting.h"
#include "vtkMediumFixtures.h"
#include "vtkMediumScene.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace ReferenceTests;

namespace
{
double Wavy(const glm::dvec3& box)
{
  return 0.5 + 0.25 * std::sin(9 * box.x + 2 * box.y) + 0.25 * std::cos(7 * box.z - 5 * box.x);
}

// Nested midpoint sums on the scene's own evaluation, with an isotropic phase function.
class BruteForce
{
public:
  explicit BruteForce(Setting& setting)
  {
    vtkImageData* image = setting.Reference->GetInputData();
    const bool onCells = image->GetPointData()->GetScalars() == nullptr;
    vtkDataArray* scalars =
      onCells ? image->GetCellData()->GetScalars() : image->GetPointData()->GetScalars();
    EXPECT_EQ(this->Scene.GatherVolume(
                image, scalars, onCells, setting.Volume, setting.Reference->GetMedium(), 0),
      "");
    EXPECT_EQ(this->Scene.GatherLights(setting.Renderer), "");
  }

  glm::dvec3 Radiance(const glm::dvec3& origin, const glm::dvec3& direction, int steps) const
  {
    const vtkMediumScene::Box& box = this->Scene.Geometry;
    const glm::dvec3 o = box.WorldToLocal(origin), d = glm::normalize(direction);
    double begin = 0, end = 1e9;
    Clip(o, d, begin, end);
    const double h = (end - begin) / steps;
    glm::dvec3 depth(0), radiance(0);
    for (int i = 0; i < steps; ++i)
    {
      const glm::dvec3 x = o + (begin + (i + 0.5) * h) * d;
      const vtkMediumScene::Coefficients at = this->Scene.Evaluate(box.LocalToBox(x));
      glm::dvec3 source = at.Emission;
      for (const vtkMediumScene::Light& light : this->Scene.Lights)
      {
        source += at.Scattering * Isotropic * this->Incident(light, x, steps);
      }
      const glm::dvec3 middle = depth + 0.5 * h * box.Length * at.Extinction;
      radiance += h * box.Length * glm::exp(-middle) * source;
      depth += h * box.Length * at.Extinction;
    }
    return radiance;
  }

private:
  void Clip(const glm::dvec3& o, const glm::dvec3& d, double& begin, double& end) const
  {
    const glm::dvec3 origin = this->Scene.Geometry.LocalToBox(o);
    const glm::dvec3 direction = this->Scene.Geometry.LocalToBoxAxes * d;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (direction[axis] != 0)
      {
        const double a = -origin[axis] / direction[axis];
        const double b = (1 - origin[axis]) / direction[axis];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
      }
    }
  }

  glm::dvec3 Incident(const vtkMediumScene::Light& light, const glm::dvec3& x, int steps) const
  {
    glm::dvec3 irradiance = light.Irradiance, way = -light.Direction;
    double begin = 0, end = 1e9;
    if (light.Type != vtkMediumScene::Light::Directional)
    {
      const double r = glm::length(light.Position - x);
      way = (light.Position - x) / r;
      end = r;
      irradiance /= light.Attenuation.x + light.Attenuation.y * r + light.Attenuation.z * r * r;
      const double cosine = -glm::dot(way, light.Direction);
      if (light.Type == vtkMediumScene::Light::Spot)
      {
        irradiance *= cosine < light.CosCone ? 0 : std::pow(cosine, light.Exponent);
      }
    }
    this->Clip(x, way, begin, end);
    glm::dvec3 depth(0);
    const double h = (end - begin) / steps;
    for (int i = 0; i < steps; ++i)
    {
      depth +=
        this->Scene.Evaluate(this->Scene.Geometry.LocalToBox(x + (begin + (i + 0.5) * h) * way))
          .Extinction;
    }
    return irradiance * glm::exp(-depth * h * this->Scene.Geometry.Length);
  }

  vtkMediumScene Scene;
};

// Midpoint sums of a field with kinks err by about a constant / steps^2; `bound` is that of 200 steps,
// relative, and a quarter of it must hold with 400.
void ExpectBruteForceConverges(Setting& setting, double bound)
{
  const BruteForce brute(setting);
  const glm::dvec3 rays[][2] = { { { -0.7, 0.31, 0.4 }, { 1, 0.2, 0.15 } },
    { { 1.5, 1.9, 1.7 }, { -1, -1.3, -1.1 } }, { { 0.45, 0.52, 0.55 }, { -0.3, 0.1, 1 } } };
  for (const auto& ray : rays)
  {
    const glm::dvec3 truth(setting.Radiance(ray[0], ray[1]));
    const double scale = std::max({ truth.x, truth.y, truth.z });
    ASSERT_GT(scale, 0);
    for (int steps : { 200, 400 })
    {
      const glm::dvec3 sum = brute.Radiance(ray[0], ray[1], steps);
      const double allowed = bound * scale * 200 * 200 / (steps * steps);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(sum[c], truth[c], allowed) << steps << " steps, channel " << c;
      }
    }
  }
}

void SetPropertyAsMedium(Setting& setting)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.1, 0);
  opacity->AddPoint(0.37, 0.3);
  opacity->AddPoint(0.9, 0.6);
  vtkNew<vtkColorTransferFunction> albedo;
  albedo->AddRGBPoint(0, 1, 0.5, 0.2);
  albedo->AddRGBPoint(0.5, 0.3, 0.9, 0.9);
  albedo->AddRGBPoint(1, 0.9, 0.2, 0.4);
  setting.Property->SetScalarOpacity(opacity);
  setting.Property->SetColor(albedo);
  setting.Property->SetScalarOpacityUnitDistance(0.3);
  setting.Reference->SetMedium(nullptr);
}
}

TEST(ReferenceConvergence, BruteForceOnPointData)
{
  Setting setting(MakeGrid({ 6, 5, 7 }, glm::dvec3(1), Wavy), 3);
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(0.3, -1, -0.6)));
  setting.AddPointLight({ 0.4, 1.3, 0.3 });
  ExpectBruteForceConverges(setting, 2e-4);
}

TEST(ReferenceConvergence, BruteForceOnCellData)
{
  Setting setting(MakeGrid({ 6, 5, 7 }, glm::dvec3(1), Wavy, true), 3);
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(0.3, -1, -0.6)));
  ExpectBruteForceConverges(setting, 2e-4);
}

TEST(ReferenceConvergence, BruteForceInsideASpotLightsCone)
{
  Setting setting(MakeGrid({ 6, 5, 7 }, glm::dvec3(1), Wavy), 3);
  const auto light = setting.AddPointLight({ 0.5, 1.6, 0.4 });
  light->SetFocalPoint(0.45, 0.2, 0.5);
  light->SetConeAngle(80); // wider than the box from there, so the sum sees no edge
  light->SetExponent(3);
  light->SetAttenuationValues(0.2, 0.1, 0.5);
  ExpectBruteForceConverges(setting, 2e-4);
}

// The cone's edge is a jump along the eye ray, so a sum errs by up to a step of the lit interval.
TEST(ReferenceConvergence, BruteForceAcrossASpotLightsCone)
{
  Setting setting(MakeGrid({ 6, 5, 7 }, glm::dvec3(1), Wavy), 3);
  const auto light = setting.AddPointLight({ 0.5, 1.6, 0.4 });
  light->SetFocalPoint(0.45, 0.2, 0.5);
  light->SetConeAngle(12);
  const BruteForce brute(setting);
  const glm::dvec3 origin(-0.7, 0.41, 0.4), direction(1, 0.02, 0.05);
  const double truth = setting.Radiance(origin, direction).x;
  ASSERT_GT(truth, 0);
  for (int steps : { 100, 400, 1600 })
  {
    EXPECT_NEAR(brute.Radiance(origin, direction, steps).x / truth, 1, 4.0 / steps);
  }
}

// A nearest field jumps at every voxel, so sums err in the first order.
TEST(ReferenceConvergence, BruteForceOnNearestVoxels)
{
  for (bool onCells : { false, true })
  {
    Setting setting(MakeGrid({ 6, 5, 7 }, glm::dvec3(1), Wavy, onCells), 3);
    setting.Property->SetInterpolationTypeToNearest();
    setting.AddDirectionalLight(glm::normalize(glm::dvec3(0.3, -1, -0.6)));
    const BruteForce brute(setting);
    const double truth = setting.Radiance({ -0.7, 0.31, 0.4 }, { 1, 0.2, 0.15 }).x;
    for (int steps : { 100, 400, 1600 })
    {
      EXPECT_NEAR(
        brute.Radiance({ -0.7, 0.31, 0.4 }, { 1, 0.2, 0.15 }, steps).x / truth, 1, 1.0 / steps);
    }
  }
}

TEST(ReferenceConvergence, BruteForceThroughTransferFunctions)
{
  Setting setting(MakeGrid({ 6, 5, 7 }, glm::dvec3(1), Wavy), 1);
  SetPropertyAsMedium(setting);
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(0.3, -1, -0.6)));
  ExpectBruteForceConverges(setting, 4e-4);
}

// Absorption on points, RGB scattering on cells, an emission of its own array: two lattices at once.
TEST(ReferenceConvergence, BruteForceOnTwoLatticesInColor)
{
  const auto image = MakeGrid({ 6, 5, 7 }, glm::dvec3(1), Wavy);
  vtkNew<vtkDoubleArray> scattering, emission;
  scattering->SetName("scattering");
  scattering->SetNumberOfComponents(3);
  for (int i = 0; i < image->GetNumberOfCells(); ++i)
  {
    using vtkMediumFixtures::Random;
    scattering->InsertNextTuple3(Random(i, 1), 2 * Random(i, 2), 3 * Random(i, 3));
  }
  emission->SetName("emission");
  for (int i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    emission->InsertNextValue(0.05 * vtkMediumFixtures::Random(i, 4));
  }
  image->GetCellData()->AddArray(scattering);
  image->GetPointData()->AddArray(emission);
  Setting setting(image, 1);
  setting.Medium->SetParametrizationToAbsorptionAndScattering();
  setting.Medium->SetAbsorptionArrayName("density");
  setting.Medium->SetScatteringArrayName("scattering");
  setting.Medium->SetEmissionArrayName("emission");
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(0.3, -1, -0.6)));
  ExpectBruteForceConverges(setting, 4e-4);
}

TEST(ReferenceConvergence, BruteForceInASkewVolume)
{
  Setting setting(MakeGrid({ 6, 5, 7 }, { 1, 0.7, 0.4 }, Wavy), 3);
  vtkNew<vtkMatrix4x4> matrix;
  const double rows[16] = { 0.9, 0.3, 0.2, 0.1, -0.2, 1.2, 0.1, 0, 0, 0.4, -1.5, 0.8, 0, 0, 0, 1 };
  matrix->DeepCopy(rows);
  setting.Volume->SetUserMatrix(matrix);
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(0.3, -1, -0.6)));
  ExpectBruteForceConverges(setting, 4e-4);
}

// The error stays within the tolerance, as a fraction of the peak. On the transfer function the table's
// facets bound it, see the class; 1e-6 is above them.
TEST(ReferenceConvergence, ToleranceIsKept)
{
  using namespace vtkMediumFixtures;
  for (Fields field : { Smooth, Cloud, Binary })
  {
    for (int mode = 0; mode < 3; ++mode)
    {
      Setting setting(MakeImage(field, glm::ivec3(24)), 8);
      setting.AddDirectionalLight(glm::normalize(glm::dvec3(-1, -2, -1.3)));
      mode == 1 ? setting.Property->SetInterpolationTypeToNearest() : void();
      mode == 2 ? SetPropertyAsMedium(setting) : void();
      vtkCamera* camera = setting.Renderer->GetActiveCamera();
      camera->SetPosition(1, 1.5, 2);
      camera->SetClippingRange(0.1, 10);
      setting.Reference->SetImageSize(12, 12);
      vtkNew<vtkImageData> strict, loose;
      setting.Reference->SetTolerance(1e-8);
      ASSERT_TRUE(setting.Reference->GetColorImage(strict));
      const double* truth = static_cast<double*>(strict->GetScalarPointer());
      const double peak = *std::max_element(truth, truth + 4 * 144);
      for (double tolerance : { 1e-3, 1e-6 })
      {
        setting.Reference->SetTolerance(tolerance);
        ASSERT_TRUE(setting.Reference->GetColorImage(loose));
        const double* values = static_cast<double*>(loose->GetScalarPointer());
        for (int i = 0; i < 4 * 144; ++i)
        {
          ASSERT_NEAR(values[i], truth[i], tolerance * peak) << Name(field) << ", mode " << mode;
        }
      }
    }
  }
}

// Between the edges of nearest voxels the depth is linear along the ray under a beam, and nearly so under
// a point light, so even a loose tolerance leaves 1e-8, or 1e-6: only a missed edge would show.
TEST(ReferenceConvergence, NearestVoxelsAreExactAtAnyTolerance)
{
  Setting setting(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Binary, glm::ivec3(24)), 8);
  setting.Property->SetInterpolationTypeToNearest();
  const auto light = setting.AddDirectionalLight(glm::normalize(glm::dvec3(-1, -2, -1.3)));
  for (bool positional : { false, true })
  {
    light->SetPositional(positional);
    light->SetPosition(0.3, 0.7, 0.4);
    for (int i = 0; i < 20; ++i)
    {
      const glm::dvec3 direction = vtkMediumFixtures::RandomDirection(i, 9);
      const glm::dvec3 origin = vtkMediumFixtures::RandomDirection(i, 10) * 0.1 - 2.0 * direction;
      setting.Reference->SetTolerance(1e-2);
      const double loose = setting.Radiance(origin, direction).x;
      setting.Reference->SetTolerance(1e-12);
      EXPECT_NEAR(loose, setting.Radiance(origin, direction).x, (positional ? 1e-6 : 1e-8) * loose)
        << "ray " << i;
    }
  }
}

TEST(ReferenceConvergence, ThreadsDoNotMatter)
{
  Setting setting(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(20)), 8);
  setting.AddDirectionalLight(glm::normalize(glm::dvec3(-1, -2, -1.3)));
  setting.Renderer->GetActiveCamera()->SetPosition(1, 1.5, 2);
  setting.Renderer->GetActiveCamera()->SetClippingRange(0.1, 10);
  setting.Reference->SetImageSize(16, 11);
  setting.Reference->SetTolerance(1e-5);
  std::vector<double> images[2];
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&]() {
      vtkNew<vtkImageData> image;
      ASSERT_TRUE(setting.Reference->GetColorImage(image));
      const double* values = static_cast<double*>(image->GetScalarPointer());
      images[threads == 1 ? 0 : 1].assign(values, values + 4 * 16 * 11);
    });
  }
  EXPECT_EQ(images[0], images[1]);
}
