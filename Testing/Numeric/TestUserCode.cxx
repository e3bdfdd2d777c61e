// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Code and uniforms that a vtkShaderProperty puts into the shaders: what the documented points change, that
// they cost one compilation each, and what is refused.
#include "BadInput.h"

#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

using namespace vtkMediumTest;

namespace
{
using Mapper = vtkSingleScatteringVolumeMapper;

constexpr const char* Color = "//VTK::Medium::Color::Impl";
constexpr const char* Coefficients = "//VTK::Medium::Coefficients::Impl";
constexpr const char* InScatter = "//VTK::Medium::InScatter::Impl";
constexpr const char* Declarations = "//VTK::Medium::Dec";

void Alter(Scene& scene, const char* point, const char* code)
{
  scene.Volume->GetShaderProperty()->AddFragmentShaderReplacement(point, true, code, false);
}

vtkUniforms* UniformsOf(Scene& scene)
{
  return scene.Volume->GetShaderProperty()->GetFragmentCustomUniforms();
}

vtkTypeInt64 Compiles(Scene& scene)
{
  return scene.Mapper->GetStatistics()->GetProgramCompiles();
}

/// A ball whose density falls from its middle, in a beam from the side.
struct LitBall : Scene
{
  explicit LitBall(int integrator, double extinction = 4)
    : Scene(MakeImage(glm::ivec3(9), glm::dvec3(1),
              [](const glm::dvec3& p) { return std::max(1 - 2 * glm::length(p), 0.0); }),
        16)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetPaperThreshold(0.3);
    this->Medium->SetExtinction(extinction);
    this->Medium->SetAlbedo(0.8);
    if (integrator != Mapper::Paper)
    {
      this->Medium->SetExtinctionArrayName("");
      this->Medium->SetExtinctionScale(extinction);
    }
    this->SetSteps(0.02, 0.02);
    this->AddBeam({ 1, -1, -0.3 });
    this->Look({ 0.3, 0.2, -1 }, 2);
  }
};

/// The largest difference from the values of the picture times the factors of colour and alpha.
double DifferenceFrom(const Picture& plain, double color, double alpha, const Picture& altered)
{
  double largest = 0;
  for (std::size_t i = 0; i < plain.Values.size(); ++i)
  {
    const double expected = (i % 4 == 3 ? alpha : color) * plain.Values[i];
    largest = std::max(largest, std::abs(expected - altered.Values[i]));
  }
  return largest;
}

double MeanDifference(const Picture& first, const Picture& second)
{
  double sum = 0;
  for (std::size_t i = 0; i < first.Values.size(); ++i)
  {
    sum += std::abs(first.Values[i] - second.Values[i]);
  }
  return sum / first.Values.size();
}

constexpr int Integrators[] = { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled,
  Mapper::Exact };
}

TEST_F(BadInput, UserCodeIsNoReasonForErrorsOfVTK)
{
  LitBall scene(Mapper::FixedStep);
  Alter(scene, Color, "color *= 2.0;");
  Alter(scene, Coefficients, "extinction *= 2.0;");
  scene.Render();
  EXPECT_TRUE(scene.Errors.empty());
  EXPECT_EQ(this->Other->Errors.size(), 0u);
}

TEST(UserCode, OnTheColourHasTheLastWord)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    LitBall scene(integrator);
    scene.AddBeam({ -1, -1, 0 }); // marches of two lights may be two draws
    const Picture plain = scene.Render();
    Alter(scene, Color, "color.rgb *= 2.0;");
    EXPECT_EQ(DifferenceFrom(plain, 2, 1, scene.Render()), 0);
    EXPECT_GT(plain.At(8, 8), 0.01);
    scene.Volume->GetShaderProperty()->ClearAllFragmentShaderReplacements();
    EXPECT_EQ(plain.Values, scene.Render().Values);
    // Distances count from the eye in world units, here as those that GetColorImage gives.
    Alter(scene, Color, "color.r = first; color.g = last;");
    const Picture distances = scene.Render();
    scene.Mapper->SetOutputToFirstHit();
    EXPECT_NEAR(scene.Render().At(8, 8), distances.At(8, 8), 1e-5);
    EXPECT_TRUE(scene.Errors.empty());
  }
}

TEST(UserCode, UniformsChangeThePictureWithoutCompiling)
{
  LitBall scene(Mapper::FixedStep);
  const Picture plain = scene.Render();
  const vtkTypeInt64 before = Compiles(scene);
  UniformsOf(scene)->SetUniformf("gain", 2);
  Alter(scene, Color, "color *= gain;");
  EXPECT_EQ(DifferenceFrom(plain, 2, 2, scene.Render()), 0);
  // The march knows the new uniform too, and what finishes the colour is new.
  EXPECT_EQ(Compiles(scene), before + 2);
  for (int gain : { 4, 8, 2 })
  {
    UniformsOf(scene)->SetUniformf("gain", gain);
    EXPECT_EQ(DifferenceFrom(plain, gain, gain, scene.Render()), 0);
  }
  const vtkTypeInt64 reused = scene.Mapper->GetStatistics()->GetFramesReused();
  scene.Render();
  EXPECT_EQ(scene.Mapper->GetStatistics()->GetFramesReused(), reused + 1);
  EXPECT_EQ(Compiles(scene), before + 2);
}

TEST(UserCode, CompilesOnceForEachChange)
{
  LitBall scene(Mapper::FixedStep);
  scene.Render();
  vtkTypeInt64 before = Compiles(scene);
  for (const char* code : { "color *= 2.0;", "color *= 3.0;", "color *= 2.0;" })
  {
    scene.Volume->GetShaderProperty()->ClearAllFragmentShaderReplacements();
    Alter(scene, Color, code);
    const Picture picture = scene.Render();
    scene.Camera->Azimuth(1);
    scene.Render();
    scene.Camera->Azimuth(-1);
    EXPECT_EQ(picture.Values, scene.Render().Values);
  }
  EXPECT_EQ(Compiles(scene), before + 2); // the third is the first
  before = Compiles(scene);
  Alter(scene, InScatter, "inScattered *= 0.5;");
  scene.Render();
  scene.Render();
  EXPECT_EQ(Compiles(scene), before + 1);
}

TEST(UserCode, OnCoefficientsIsTheMediumOfThoseCoefficients)
{
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    for (bool transmittance : { false, true })
    {
      SCOPED_TRACE(testing::Message() << "integrator " << integrator << ' ' << transmittance);
      LitBall scene(integrator), dense(integrator, 12);
      for (Scene* each : { static_cast<Scene*>(&scene), static_cast<Scene*>(&dense) })
      {
        each->Mapper->SetLightCachesToAlways();
        transmittance ? each->Mapper->SetOutputToTransmittance()
                      : each->Mapper->SetOutputToRadiance();
      }
      const Picture plain = scene.Render();
      Alter(scene, Coefficients, "extinction *= 3.0; scattering *= 3.0;");
      const Picture altered = scene.Render();
      const Picture expected = dense.Render();
      // FixedStep does the same; ErrorControlled may err by 1/255 of the peak, with the caches of the
      // dense one beside that; Exact has two points a cell.
      const double tolerance = integrator == Mapper::FixedStep ? 1e-5
        : integrator == Mapper::ErrorControlled                ? 0.01
                                                               : 2e-4;
      EXPECT_LT(Difference(expected, altered), tolerance);
      EXPECT_GT(Difference(expected, plain), 0.1);
      EXPECT_TRUE(scene.Errors.empty());
    }
  }
}

TEST(UserCode, MakesAMediumWhereTheDataHaveNone)
{
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    Scene box(MakeBox(), 16), empty(MakeBox(), 16);
    for (Scene* scene : { &box, &empty })
    {
      scene->Mapper->SetIntegrator(integrator);
      scene->SetSteps(0.02, 0.02);
      scene->AddBeam({ 1, -1, -0.3 });
      scene->Look({ 0.3, 0.2, -1 }, 3);
    }
    box.Medium->SetExtinction(2);
    box.Medium->SetAlbedo(0.5);
    empty.Medium->SetExtinction(0);
    UniformsOf(empty)->SetUniformf("sigma", 2);
    Alter(empty, Declarations, "float half_of(float x) { return 0.5 * x; }");
    Alter(empty, Coefficients,
      "//VTK::Medium::Coefficients::Impl\n" // as VTK's users often write it
      "extinction.r = extinction.g = extinction.b = sigma * worldLength; // per world unit\n"
      "scattering = half_of(1.0) * extinction;");
    // ErrorControlled may find another step where it does not know that the medium is homogeneous.
    const double tolerance = integrator == Mapper::ErrorControlled ? 0.01 : 1e-4;
    EXPECT_LT(Difference(box.Render(), empty.Render()), tolerance);
    EXPECT_TRUE(empty.Errors.empty());
  }
}

TEST(UserCode, ThatRemovesHalfOfAConstantMediumIsTheCroppedOne)
{
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    Scene cropped(MakeBox(), 16), altered(MakeBox(), 16);
    for (Scene* scene : { &cropped, &altered })
    {
      scene->Mapper->SetIntegrator(integrator);
      scene->Mapper->SetMaximumError(0.002);
      scene->SetSteps(0.005, 0.005);
      scene->AddBeam({ 1, -0.2, -0.1 }); // through the half that is removed
      scene->Look({ 0.3, 0.2, -1 }, 3);
      scene->Medium->SetExtinction(4);
    }
    cropped.Mapper->CroppingOn();
    cropped.Mapper->SetCroppingRegionPlanes(0, 1, -1, 1, -1, 1);
    Alter(altered, Coefficients, "if (box.x < 0.5) { extinction *= 0.0; scattering *= 0.0; }");
    const Picture expected = cropped.Render(), found = altered.Render();
    // A step of 0.005 straddles the edge; that of ErrorControlled and a part of Exact is longer.
    EXPECT_LT(MeanDifference(expected, found), integrator == Mapper::FixedStep ? 2e-4 : 2e-3);
    EXPECT_TRUE(altered.Errors.empty());
  }
}

TEST(UserCode, OnScatteredLightIsOfEachLight)
{
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    LitBall scene(integrator), one(integrator);
    scene.AddBeam({ -1, -1, 0 });
    const Picture two = scene.Render();
    Alter(scene, InScatter, "inScattered *= number == 1 ? 0.0 : 1.0;");
    const Picture altered = scene.Render();
    const double tolerance = integrator == Mapper::FixedStep ? 1e-6 : 2e-3;
    EXPECT_LT(Difference(one.Render(), altered), tolerance);
    EXPECT_GT(Difference(two, altered), 0.03);
    scene.Volume->GetShaderProperty()->ClearAllFragmentShaderReplacements();
    EXPECT_EQ(two.Values, scene.Render().Values);
  }
}

TEST_F(BadInput, CodeThatDoesNotCompileIsRefusedOnceAndTheNextFrameIsDrawn)
{
  for (const char* point : { Color, Coefficients })
  {
    for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled })
    {
      LitBall scene(integrator);
      const Picture plain = scene.Render();
      Alter(scene, point, "no such thing;");
      scene.Window->Render();
      scene.Window->Render();
      ASSERT_EQ(scene.Errors.size(), 1u);
      EXPECT_NE(scene.Errors[0].find("vtkShaderProperty does not compile"), std::string::npos);
      scene.Volume->GetShaderProperty()->ClearAllFragmentShaderReplacements();
      EXPECT_EQ(plain.Values, scene.Render().Values);
      EXPECT_EQ(scene.Errors.size(), 1u);
    }
  }
}

TEST_F(BadInput, ShaderCodeWithoutAPlaceIsRefused)
{
  const Change mend = [](Scene& scene) {
    scene.Volume->GetShaderProperty()->ClearAllShaderReplacements();
    scene.Volume->GetShaderProperty()->SetFragmentShaderCode(nullptr);
    scene.Volume->GetShaderProperty()->GetVertexCustomUniforms()->RemoveAllUniforms();
  };
  ExpectRefusal(
    { "//VTK::Light::Impl", "//VTK::Medium::Color::Impl" },
    [](Scene& scene) { Alter(scene, "//VTK::Light::Impl", "color *= 2.0;"); }, mend);
  ExpectRefusal(
    { "Vertex", Color },
    [](Scene& scene) {
      scene.Volume->GetShaderProperty()->AddVertexShaderReplacement(Color, true, "x", false);
    },
    mend);
  ExpectRefusal(
    { "whole shader", "AddFragmentShaderReplacement" },
    [](Scene& scene) {
      scene.Volume->GetShaderProperty()->SetFragmentShaderCode("//VTK::System::Dec");
    },
    mend);
  ExpectRefusal(
    { "GetFragmentCustomUniforms" },
    [](Scene& scene) {
      scene.Volume->GetShaderProperty()->GetVertexCustomUniforms()->SetUniformf("gain", 2);
    },
    mend);
  ExpectRefusal(
    { "Paper", Coefficients },
    [](Scene& scene) { Alter(scene, Coefficients, "extinction *= 2.0;"); }, mend, OnlyPaper);
}
