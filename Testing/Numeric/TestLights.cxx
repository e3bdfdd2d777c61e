// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Lights add up, are linear, fall off and are scattered by the phase function as documented.
#include "ClosedForms.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
/// The same renderer twice: float's rounding in another order of sums.
constexpr double SameRenderer = 2e-4;

/// A little scene with three kinds of light; `mask` says which of them are on.
struct ThreeLights : Scene
{
  vtkSmartPointer<vtkLight> Beam, Point, Spot;

  explicit ThreeLights(bool paper = false)
    : Scene(MakeBox(), 12)
  {
    this->Mapper->SetIntegrator(
      paper ? vtkSingleScatteringVolumeMapper::Paper : vtkSingleScatteringVolumeMapper::FixedStep);
    this->Medium->SetExtinction(1.5, 2, 3);
    this->Medium->SetAnisotropy(0.4);
    this->SetSteps(0.05, 0.05);
    this->Look({ 0.3, 0.2, -1 }, 2.5);
    this->Beam = this->AddBeam({ 1, -1, -0.3 });
    this->Beam->SetDiffuseColor(1, 0.5, 0.2);
    this->Point = this->AddPointLight({ 0, 1, 1 });
    this->Spot = this->AddPointLight({ -1, 0.2, 0.1 });
    this->Spot->SetFocalPoint(0, 0, 0);
    this->Spot->SetConeAngle(20);
  }

  Picture RenderOnly(int mask)
  {
    this->Beam->SetSwitch(mask & 1);
    this->Point->SetSwitch(mask >> 1 & 1);
    this->Spot->SetSwitch(mask >> 2 & 1);
    return this->Render();
  }
};

/// The picture of one pixel of a thin slab, which is E p(cosTheta) tau, over E tau.
double MeasurePhase(Scene& scene, double tau)
{
  return scene.Render().At(2, 2) / tau;
}
}

TEST(Lights, AddUp)
{
  for (bool paper : { false, true })
  {
    SCOPED_TRACE(paper ? "Paper" : "FixedStep");
    ThreeLights scene(paper);
    Picture sum = scene.RenderOnly(1);
    for (int mask : { 2, 4 })
    {
      const Picture one = scene.RenderOnly(mask);
      ASSERT_GT(one.Mean(), 0);
      for (std::size_t i = 0; i < sum.Values.size(); ++i)
      {
        sum.Values[i] += i % 4 < 3 ? one.Values[i] : 0;
      }
    }
    EXPECT_LT(Difference(sum, scene.RenderOnly(7)), SameRenderer);
  }
}

TEST(Lights, OfAnyNumberMayBePermuted)
{
  Scene scene(MakeBox(), 8);
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (int i = 0; i < 64; ++i)
  {
    lights.push_back(scene.AddBeam({ std::cos(0.7 * i), std::sin(1.3 * i), std::cos(2.1 * i) }));
    lights.back()->SetIntensity(1.0 / (i + 1));
  }
  const Picture forwards = scene.Render();
  scene.Renderer->RemoveAllLights();
  for (int i = 63; i >= 0; --i)
  {
    scene.Renderer->AddLight(lights[i]);
  }
  EXPECT_LT(Difference(forwards, scene.Render()), SameRenderer);
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(lights[0]);
  EXPECT_LT(scene.Render().Mean(), 0.8 * forwards.Mean()); // the other 63 did count
}

TEST(Lights, ColourIsLinearOverTwelveDecades)
{
  ThreeLights scene;
  const Picture unit = scene.RenderOnly(1);
  for (double scale : { 1e-6, 1e-3, 1e3, 1e6 })
  {
    scene.Beam->SetIntensity(scale);
    Picture scaled = scene.Render();
    for (std::size_t i = 0; i < scaled.Values.size(); ++i)
    {
      scaled.Values[i] /= i % 4 < 3 ? static_cast<float>(scale) : 1;
    }
    EXPECT_LT(Difference(unit, scaled), SameRenderer) << "scale " << scale;
  }
}

TEST(Lights, ColourIsOfEachChannel)
{
  Scene scene(MakeBox(), 8);
  scene.AddBeam({ 0, 0, -1 })->SetDiffuseColor(1, 0.5, 0.25);
  const Picture picture = scene.Render();
  ASSERT_GT(picture.At(4, 4), 0);
  EXPECT_NEAR(picture.At(4, 4, 1) / picture.At(4, 4), 0.5, 1e-6);
  EXPECT_NEAR(picture.At(4, 4, 2) / picture.At(4, 4), 0.25, 1e-6);
}

TEST(Lights, PhaseFunctionIsThatOfTheAngleInTheWorld)
{
  // A thin box that is far from a cube, seen along -z; the beam turns in the plane of x and z.
  Scene scene(MakeBox({ 4, 0.5, 1 }), 4);
  const double tau = 1e-4;
  scene.Medium->SetExtinction(tau);
  scene.LookParallel({ 0, 0, -1 }, 3, 0.1);
  for (double g : { -0.999, -0.9, -0.3, 0.3, 0.9, 0.99, 0.999 })
  {
    for (double cosTheta : { -1.0, -0.9999995, -0.7, 0.0, 0.6, 0.99, 0.9999995, 1.0 })
    {
      SCOPED_TRACE(testing::Message() << "g " << g << ", cos " << cosTheta);
      // From sample to eye is +z: light that travels along +z is scattered forwards.
      vtkSmartPointer<vtkLight> beam =
        scene.AddBeam({ std::sqrt(1 - cosTheta * cosTheta), 0, cosTheta });
      scene.Medium->SetAnisotropy(g);
      scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
      double truth = HenyeyGreenstein(cosTheta, g);
      const double tolerance = 5e-4; // 2 tau of it is lost on the way
      EXPECT_NEAR(MeasurePhase(scene, tau), truth, tolerance * truth);

      scene.Medium->SetPhaseFunctionToSchlick();
      const double k = glm::clamp(1.55 * g - 0.55 * g * g * g, -0.999, 0.999);
      truth = Schlick(cosTheta, k);
      EXPECT_NEAR(MeasurePhase(scene, tau), truth, tolerance * truth);
      scene.Renderer->RemoveLight(beam);
    }
  }
}

TEST(Lights, AnisotropyIsThatOfTheMapperWithoutAMedium)
{
  Scene scene(MakeBox(), 4);
  scene.LookParallel({ 0, 0, -1 }, 3, 0.1);
  scene.AddBeam({ 0, 0, 1 });
  scene.Mapper->SetMedium(nullptr);
  scene.Mapper->SetAnisotropy(0.5);
  const double forward = scene.Render().At(2, 2);
  scene.Mapper->SetAnisotropy(-0.5);
  const double backward = scene.Render().At(2, 2);
  ASSERT_GT(backward, 0);
  // The density plays no part in the quotient.
  EXPECT_NEAR(forward / backward, HenyeyGreenstein(1, 0.5) / HenyeyGreenstein(1, -0.5), 1e-3);
  scene.Mapper->SetPhaseFunctionToSchlick();
  const double k = 1.55 * -0.5 + 0.55 * 0.125;
  EXPECT_NEAR(scene.Render().At(2, 2) / backward, Schlick(1, k) / HenyeyGreenstein(1, -0.5), 1e-3);
}

TEST(Lights, PointLightFallsOffWithTheSquareOfTheDistance)
{
  // A small thin cube far from the lamp: E = I / r^2 at its centre, within (size / r)^2.
  Scene scene(MakeBox(glm::dvec3(0.02)), 4);
  scene.Medium->SetExtinction(1e-3);
  scene.LookParallel({ 0, 0, -1 }, 3, 0.001);
  const double thin = Isotropic * 1e-3 * 0.02;
  for (double r : { 0.5, 2.0, 50.0 })
  {
    vtkSmartPointer<vtkLight> light = scene.AddPointLight({ 0, r, 0 });
    EXPECT_NEAR(scene.Render().At(2, 2) / (thin / (r * r)), 1, 1e-3) << "distance " << r;
    light->SetAttenuationValues(2, 3, 4);
    EXPECT_NEAR(scene.Render().At(2, 2) / (thin / (2 + 3 * r + 4 * r * r)), 1, 1e-3);
    scene.Renderer->RemoveLight(light);
  }
}

TEST(Lights, FarPointLightEqualsABeam)
{
  Scene scene(MakeBox(), 8);
  vtkSmartPointer<vtkLight> light = scene.AddBeam({ 0, -1, 0 });
  const Picture beam = scene.Render();
  light->SetSwitch(false);
  scene.AddPointLight({ 0, 1e8, 0 })->SetIntensity(1e16);
  EXPECT_LT(Difference(beam, scene.Render()), 1e-3);
}

TEST(Lights, PointLightInsideStaysFinite)
{
  Scene scene(MakeBox(), 16);
  scene.Medium->SetExtinction(2);
  // On a voxel, on the eye, on a sample of the middle ray.
  for (const glm::dvec3& at : { glm::dvec3(0), glm::dvec3(0, 0, 3), glm::dvec3(0, 0, 0.25) })
  {
    vtkSmartPointer<vtkLight> light = scene.AddPointLight(at);
    const Picture picture = scene.Render();
    EXPECT_TRUE(picture.IsLight());
    EXPECT_GT(picture.Mean(), 0);
    scene.Renderer->RemoveLight(light);
  }
}

TEST(Lights, SpotEndsAtItsCone)
{
  // From above, half angle 20 degrees, exponent 0: E = I / r^2 inside, nothing outside.
  Scene scene(MakeBox({ 1, 0.02, 1 }), 32);
  scene.Medium->SetExtinction(1e-3);
  scene.SetSteps(0.002, 0.1);
  scene.LookParallel({ 0, -1, 0 }, 3, 0.5);
  vtkSmartPointer<vtkLight> spot = scene.AddPointLight({ 0, 1, 0 });
  spot->SetFocalPoint(0, 0, 0);
  spot->SetConeAngle(20);
  for (double exponent : { 0.0, 6.0 })
  {
    spot->SetExponent(exponent);
    const Picture picture = scene.Render();
    ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
      const double across = std::hypot(ray.Origin.x, ray.Origin.z), r = std::hypot(across, 1);
      const double cosine = 1 / r, edge = std::cos(20 * Pi / 180);
      const double inside = Isotropic * 1e-3 * 0.02 / (r * r) * std::pow(cosine, exponent);
      if (std::abs(across - std::tan(20 * Pi / 180)) > 0.01) // the sheet is 0.02 thick
      {
        const double truth = cosine > edge ? inside : 0;
        // (thickness / r)^2 of the inverse square's curvature.
        ASSERT_NEAR(picture.At(x, y), truth, 2e-3 * inside) << "exponent " << exponent;
      }
    });
  }
}
