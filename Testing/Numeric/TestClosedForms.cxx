// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Every closed form, in every integrator that models its medium.
#include "ClosedForms.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
using Mapper = vtkSingleScatteringVolumeMapper;

/// Radiance per steradian of phase 1, and optical depth, along a ray.
struct Truth
{
  double Radiance, Depth;
};

struct ClosedForm
{
  const char* Name;
  std::function<vtkSmartPointer<vtkImageData>()> Image;
  std::function<void(Scene&)> Prepare; ///< medium, lights and camera
  std::function<Truth(const Ray&)> Of;
  double Relative = 1e-4;           ///< of FixedStep and Exact; what they may differ by beside 2e-6
  double Step = 0.0025;             ///< of FixedStep and Paper, world units
  const char* NotInPaper = nullptr; ///< why Paper does not model it
};

/// GoogleTest's name of a form.
void PrintTo(const ClosedForm& form, std::ostream* out)
{
  *out << form.Name;
}

const glm::dvec3 Size(1, 0.8, 0.5);
const char* const NotHomogeneous = "Paper fills voxels with a homogeneous medium";

Truth BoxTruth(const Box& box, const Ray& ray, double sigma, double radiance)
{
  const std::array<double, 2> t = box.Intersect(ray);
  return { radiance, sigma * std::max(t[1] - t[0], 0.0) };
}

/// A: a box of an extinction under a beam.
ClosedForm BoxUnderABeam(
  const char* name, const glm::dvec3& beam, const glm::dvec3& view, double sigma, double step)
{
  const glm::dvec3 unit = glm::normalize(beam);
  return { name, [] { return MakeBox(Size); },
    [=](Scene& scene) {
      scene.Medium->SetExtinction(sigma);
      scene.AddBeam(unit);
      scene.Look(view, 2);
    },
    [=](const Ray& ray) {
      const Box box(Size);
      return BoxTruth(box, ray, sigma, BoxRadiance(box, ray, -unit, sigma));
    },
    1e-4, step };
}

/// C: a lamp in a homogeneous box, which holds all of the light's ways.
ClosedForm LampInABox(const char* name, const glm::dvec3& lamp)
{
  return { name, [] { return MakeBox(); },
    [=](Scene& scene) {
      scene.Medium->SetExtinction(2);
      scene.AddPointLight(lamp);
      scene.LookParallel({ 0, 0, -1 }, 2, 0.3);
    },
    [=](const Ray& ray) {
      const Box box(glm::dvec3(1));
      const std::array<double, 2> t = box.Intersect(ray);
      return BoxTruth(box, ray, 2, PointSourceRadiance(ray, lamp, 2, t[0], t[1]));
    },
    1e-2, 0.005 };
}

/// D: extinction that falls off with the height. Between grid planes a straight line is above the
/// exponential, by (spacing / height)^2 / 8 = 6e-5 of it at most.
ClosedForm Atmosphere(const char* name, const glm::dvec3& view)
{
  const double height = 0.7, sigma = 2;
  return { name,
    [=] {
      return MakeImage(
        { 2, 65, 2 }, glm::dvec3(1), [=](const glm::dvec3& p) { return std::exp(-p.y / height); });
    },
    [=](Scene& scene) {
      scene.Medium->SetExtinctionArrayName("");
      scene.Medium->SetExtinctionScale(sigma);
      scene.Look(view, 2);
    },
    [=](const Ray& ray) {
      const std::array<double, 2> t = Box(glm::dvec3(1)).Intersect(ray);
      const double y = ray.Origin.y + t[0] * ray.Direction.y;
      return Truth{ 0,
        t[0] < t[1] ? AtmosphereDepth(sigma, height, y, ray.Direction.y, t[1] - t[0]) : 0 };
    },
    1e-3, 0.005, NotHomogeneous };
}

/// E: extinction that grows from 1 to 10 across the box.
ClosedForm Ramp()
{
  return { "RampOneToTen",
    [] {
      return MakeImage(
        { 2, 2, 9 }, glm::dvec3(1), [](const glm::dvec3& p) { return 5.5 + 9 * p.z; });
    },
    [](Scene& scene) {
      scene.Medium->SetExtinctionArrayName("");
      scene.Look({ 0.3, 0.2, -1 }, 2);
    },
    [](const Ray& ray) {
      const std::array<double, 2> t = Box(glm::dvec3(1)).Intersect(ray);
      const double first = 5.5 + 9 * (ray.Origin.z + t[0] * ray.Direction.z);
      return Truth{ 0, t[0] < t[1] ? RampDepth(first, 9 * ray.Direction.z, t[1] - t[0]) : 0 };
    },
    1e-4, 0.005, NotHomogeneous };
}

/// The reflection (view and light from one side) or transmission of a wide slab of optical depth 1.5.
ClosedForm Slab(const char* name, double mu, double mu0, bool reflects)
{
  const glm::dvec3 toLight(std::sqrt(1 - mu0 * mu0), 0, reflects ? mu0 : -mu0);
  const glm::dvec3 view(0, std::sqrt(1 - mu * mu), -mu);
  return { name,
    [] {
      return MakeBox({ 12, 12, 0.5 });
    },
    [=](Scene& scene) {
      scene.Medium->SetExtinction(3);
      scene.AddBeam(-toLight);
      scene.LookParallel(view, 3, 0.5);
    },
    [=](const Ray&) {
      const double fraction =
        reflects ? SlabReflection(1.5, mu, mu0) : SlabTransmission(1.5, mu, mu0);
      return Truth{ fraction, 1.5 / mu };
    } };
}

std::vector<ClosedForm> ClosedForms()
{
  return {
    BoxUnderABeam("BoxLitFromTheEye", { 0, 0, -1 }, { 0, 0, -1 }, 3, 0.0025),
    BoxUnderABeam("BoxLitFromBehind", { 0, 0, 1 }, { 0, 0, -1 }, 3, 0.0025),
    BoxUnderABeam("BoxLitFromTheSide", { 1, 0, 0 }, { 1, -0.4, 0.3 }, 3, 0.0025),
    BoxUnderABeam("BoxLitAslant", { 0.3, -0.8, 0.4 }, { 1, -0.4, 0.3 }, 3, 0.0025),
    BoxUnderABeam("BoxLitObliquely", { -0.6, 0.1, -0.7 }, { 1, -0.4, 0.3 }, 3, 0.0025),
    BoxUnderABeam("BoxThin", { 0.3, -0.8, -0.4 }, { 0.2, 0.1, -1 }, 1e-2, 0.005),
    BoxUnderABeam("BoxVeryThin", { 0.3, -0.8, -0.4 }, { 0.2, 0.1, -1 }, 1e-5, 0.005),
    BoxUnderABeam("BoxThick", { 0.3, -0.8, -0.4 }, { 0.2, 0.1, -1 }, 20, 0.0005),
    BoxUnderABeam("BoxOpaque", { 0.3, -0.8, -0.4 }, { 0.2, 0.1, -1 }, 80, 0.000125),
    LampInABox("LampInABox", { 0.37, 0.05, 0.1 }),
    LampInABox("LampAmongTheRays", { 0.1, 0.05, -0.2 }),
    Atmosphere("AtmosphereSeenLevel", { 0, 0, -1 }),
    Atmosphere("AtmosphereSeenAslant", { 0.2, -0.7, -1 }),
    Ramp(),
    Slab("SlabReflects", 0.8, 0.6, true),
    Slab("SlabTransmits", 0.8, 0.6, false),
    Slab("SlabTransmitsWhereItCancels", 0.8, 0.8 + 1e-9, false),
  };
}

void Choose(Scene& scene, int integrator)
{
  scene.Mapper->SetIntegrator(integrator);
  scene.Mapper->SetTransmittanceThreshold(0);
  scene.Mapper->SetPaperThreshold(0);
  scene.Mapper->SetJitter(0);
}

struct Allowed
{
  double Radiance, Alpha;
};

/// What each integrator promises. A float ray's length at a grazing edge is good to 6e-8, and 80 times that is
/// 5e-6 of alpha; 2e-6 is the same of radiance.
Allowed Tolerances(const ClosedForm& form, Scene& scene, double alpha, double radiance, double peak)
{
  switch (scene.Mapper->GetIntegrator())
  {
    case Mapper::Paper: // a left Riemann sum's first order, sigma (1 + kappa) h / 2 with kappa <= 1
      return { 1e-2 * radiance + 2e-6, form.Relative * alpha + 5e-6 };
    case Mapper::FixedStep:
      return { form.Relative * radiance + 2e-6, form.Relative * alpha + 5e-6 };
    case Mapper::ErrorControlled:
    {
      const double error = scene.Mapper->GetMaximumError();
      return { error * peak + 2e-6, error };
    }
    default: // Exact: of the peak
      return { 1e-4 * peak, 2e-5 + (form.Relative > 1e-4 ? form.Relative * alpha : 0) };
  }
}

struct ClosedFormsTest : testing::TestWithParam<std::tuple<ClosedForm, int>>
{
};

const char* NameOf(int integrator)
{
  static const char* const names[] = { "Paper", "FixedStep", "ErrorControlled", "Exact" };
  return names[integrator];
}
}

TEST_P(ClosedFormsTest, Holds)
{
  const auto& [form, integrator] = GetParam();
  if (integrator == Mapper::Paper && form.NotInPaper)
  {
    GTEST_SKIP() << form.NotInPaper;
  }
  // ErrorControlled's error is of the peak that its probes see, 32 x 32 at least.
  Scene scene(form.Image(), integrator == Mapper::ErrorControlled ? 32 : 8);
  Choose(scene, integrator);
  scene.SetSteps(integrator == Mapper::Paper ? form.Step / 2 : form.Step, 0.1);
  form.Prepare(scene);
  double peak = 0;
  ForEachPixel(scene,
    [&](int, int, const Ray& ray) { peak = std::max(peak, Isotropic * form.Of(ray).Radiance); });
  const Picture picture = scene.Render();
  ASSERT_TRUE(picture.IsLight());
  ASSERT_EQ(scene.Errors.size(), 0u);
  int hits = 0;
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const Truth truth = form.Of(ray);
    const double alpha = -std::expm1(-truth.Depth), radiance = Isotropic * truth.Radiance;
    hits += alpha > 0;
    const Allowed allowed = Tolerances(form, scene, alpha, radiance, peak);
    ASSERT_NEAR(picture.At(x, y), radiance, allowed.Radiance) << x << ", " << y;
    ASSERT_NEAR(picture.At(x, y, 3), alpha, allowed.Alpha) << x << ", " << y;
  });
  EXPECT_GT(hits, 8); // the view shows the medium
}

INSTANTIATE_TEST_SUITE_P(Mapper, ClosedFormsTest,
  testing::Combine(testing::ValuesIn(ClosedForms()),
    testing::Values(Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact)),
  [](const auto& parameters) {
    return std::get<0>(parameters.param).Name + std::string("In") +
      NameOf(std::get<1>(parameters.param));
  });

// A radiograph: what adds up along a ray is the optical depth, and no light is followed.
TEST(ClosedForms, AdditiveBlendingIsTheOpticalDepth)
{
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    const double sigma = 1.7;
    Scene scene(MakeBox(Size));
    scene.Mapper->SetIntegrator(integrator);
    scene.Medium->SetExtinction(sigma);
    scene.AddBeam({ 0.3, -1, -0.2 });
    scene.Look({ 0.3, 0.2, -1 }, 2);
    scene.Mapper->SetBlendModeToAdditive();
    const Picture added = scene.Render();
    const std::vector<unsigned char> shown = scene.RenderWindow();
    int seen = 0;
    ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
      const std::array<double, 2> t = Box(Size).Intersect(ray);
      const double depth = sigma * std::max(t[1] - t[0], 0.0);
      EXPECT_NEAR(added.At(x, y, 1), depth, 1e-4) << x << ", " << y;
      const double grey = shown[3 * (y * scene.Pixels + x) + 1];
      EXPECT_NEAR(grey, -255 * std::expm1(-depth), 1) << x << ", " << y;
      seen += depth > 0.1;
    });
    EXPECT_GT(seen, 100);
    scene.Renderer->RemoveAllLights();
    EXPECT_EQ(scene.Render().Values, added.Values);
    scene.Mapper->SetBlendModeToComposite();
    scene.Mapper->SetOutputToOpticalDepth();
    EXPECT_EQ(scene.Render().Values, added.Values);
    scene.Mapper->SetOutputToDepth();
    const Picture depths = scene.Render();
    scene.Mapper->SetBlendModeToAdditive();
    EXPECT_EQ(scene.Render().Values, depths.Values);
    EXPECT_TRUE(scene.Errors.empty());
  }
}
