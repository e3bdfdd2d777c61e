// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Which structure a program has, row by row, and how many programs there can be (variants.md).
#include "PlanSetting.h"

#include <map>
#include <set>

using namespace vtkMediumTest;

namespace
{
constexpr int Marching[] = { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact };

std::string KeyOf(const vtkMediumPlan& plan)
{
  std::string key = plan.ShaderDefines;
  for (const std::string& file : plan.ShaderFiles)
  {
    key += file + ' ';
  }
  return key;
}

/// The programs of a plan.
void Collect(const vtkMediumPlan& plan, std::set<std::string>& keys)
{
  keys.insert(KeyOf(plan));
  if (plan.Rough)
  {
    keys.insert(KeyOf(*plan.Rough));
  }
}
}

//------------------------------------------------------------------------------
TEST(PlanVariants, NoAnisotropyIsAConstantPhase)
{
  using Phases = vtkParticipatingMedium;
  for (int integrator : Marching)
  {
    vtkMediumScene scene = MakeScene();
    const auto calls = [&](int phase) {
      return Has(vtkMediumPlan(scene, With(integrator), Device()),
        "PHASE(angle, g) PHASE_" + std::to_string(phase) + '(');
    };
    for (vtkMediumScene::Phases phase :
      { Phases::HenyeyGreenstein, Phases::Schlick, Phases::SchlickK })
    {
      scene.Content.Phase = phase;
      scene.Content.Anisotropy.Scale = glm::dvec3(0);
      EXPECT_TRUE(calls(Phases::Isotropic)) << phase;
      scene.Content.Anisotropy.Scale = glm::dvec3(1e-3);
      EXPECT_TRUE(calls(phase)) << phase;
    }
    scene.Content.Anisotropy.Scale = glm::dvec3(0);
    scene.Content.Phase = Phases::Rayleigh; // whose g is no parameter
    EXPECT_TRUE(calls(Phases::Rayleigh));
  }
}

//------------------------------------------------------------------------------
TEST(PlanVariants, GreyExtinctionIsOneNumber)
{
  for (int integrator : Marching)
  {
    vtkMediumScene scene = MakeScene();
    EXPECT_FALSE(Has(vtkMediumPlan(scene, With(integrator), Device()), "CHROMATIC_EXTINCTION"));
    scene.Content.ChromaticExtinction = true;
    EXPECT_TRUE(Has(vtkMediumPlan(scene, With(integrator), Device()), "CHROMATIC_EXTINCTION"));
  }
}

//------------------------------------------------------------------------------
TEST(PlanVariants, ConesAreTestedOnlyWhereThereIsASpot)
{
  for (int integrator : Marching)
  {
    vtkMediumScene scene = MakeScene();
    scene.Lights.resize(2, scene.Lights[0]);
    scene.Lights[1].Type = vtkMediumScene::Light::Point;
    const vtkMediumPlan lamp(scene, With(integrator), Device());
    EXPECT_TRUE(Has(lamp, "POSITIONAL_LIGHTS"));
    EXPECT_FALSE(Has(lamp, "SPOT_LIGHTS"));
    scene.Lights[1].Type = vtkMediumScene::Light::Spot;
    EXPECT_TRUE(Has(vtkMediumPlan(scene, With(integrator), Device()), "SPOT_LIGHTS"));
  }
}

//------------------------------------------------------------------------------
TEST(PlanVariants, TablesAreReadOnlyWhereThereIsAFunction)
{
  for (int integrator : Marching)
  {
    vtkMediumScene scene = MakeScene();
    const vtkMediumPlan direct(scene, With(integrator), Device());
    EXPECT_TRUE(Has(direct, "FUNCTION_COUNT 0\n"));
    EXPECT_EQ(direct.ShaderDefines.find("functionValue"), std::string::npos);
    EXPECT_FALSE(Has(direct, "EXTINCTION_BETWEEN"));
    EXPECT_FALSE(direct.ReadsFunctions || direct.ReadsFunctionIntegrals);
    scene.Content.Functions.emplace_back();
    scene.Content.Functions[0].Sample(0, 1, {}, [](double x) { return glm::dvec4(x * x); });
    scene.Content.Extinction = { Coefficient::FunctionAlpha, 0, 0, -1, glm::dvec3(1) };
    const vtkMediumPlan mapped(scene, With(integrator), Device());
    EXPECT_TRUE(Has(mapped, "FUNCTION_COUNT 1\n"));
    EXPECT_NE(mapped.ShaderDefines.find("functionValue"), std::string::npos);
    EXPECT_EQ(Has(mapped, "EXTINCTION_BETWEEN"), integrator == Mapper::Exact)
      << "only cells in closed form need a function's integral";
    EXPECT_TRUE(mapped.ReadsFunctions);
    EXPECT_EQ(mapped.ReadsFunctionIntegrals, integrator == Mapper::Exact);
  }
}

//------------------------------------------------------------------------------
TEST(PlanVariants, OpaqueGeometryStandsInTheLightOnlyWhereThereAreBoth)
{
  for (int integrator : Marching)
  {
    vtkMediumScene scene = MakeScene();
    EXPECT_FALSE(Reads(vtkMediumPlan(scene, With(integrator), Device()), "ShadowMap"));
    scene.Casters.emplace_back();
    const vtkMediumPlan shadowed(scene, With(integrator), Device());
    EXPECT_TRUE(shadowed.OpaqueShadows);
    EXPECT_TRUE(Reads(shadowed, "ShadowMap"));
    scene.Lights.clear();
    const vtkMediumPlan dark(scene, With(integrator), Device());
    EXPECT_FALSE(dark.OpaqueShadows);
    EXPECT_FALSE(Reads(dark, "ShadowMap"));
  }
}

//------------------------------------------------------------------------------
TEST(PlanVariants, ConstantExtinctionMakesALightRayOneSegment)
{
  vtkMediumScene scene = MakeScene();
  scene.Lights[0].Type = vtkMediumScene::Light::Point; // else there would be no march at all
  EXPECT_FALSE(Has(vtkMediumPlan(scene, With(Mapper::FixedStep), Device()), "EXTINCTION_CONSTANT"));
  scene.Content.Fields.clear();
  scene.Content.Extinction = { Coefficient::Constant, -1, -1, -1, glm::dvec3(2) };
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled })
  {
    const vtkMediumPlan plan(scene, With(integrator), Device());
    EXPECT_TRUE(Has(plan, "EXTINCTION_CONSTANT"));
    EXPECT_TRUE(Has(plan, "FIELD_COUNT 0\n")) << "and there is no texture to look up";
    EXPECT_EQ(plan.CachedLights, 0);
  }
}

//------------------------------------------------------------------------------
TEST(PlanVariants, JitterIsOfPaperAndOnlyWhereItIsNotZero)
{
  for (int integrator :
    { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    vtkMediumScene scene = MakeScene();
    scene.Content.Extinction = { Coefficient::Constant, -1, -1, -1, glm::dvec3(2) };
    for (double jitter : { 0.0, 0.2 })
    {
      Settings settings = With(integrator);
      settings.Jitter = jitter;
      const vtkMediumPlan plan(scene, settings, Device());
      ASSERT_TRUE(plan.Refusal.empty()) << plan.Refusal;
      const bool jitters = integrator == Mapper::Paper && jitter > 0;
      EXPECT_EQ(Has(plan, "JITTER"), jitters);
      EXPECT_EQ(plan.ReadsJitter, jitters);
    }
  }
}

//------------------------------------------------------------------------------
// Bricks would leave out what code of the user adds.
TEST(PlanVariants, TilesAndLeapsAreThoseOfErrorControlledAlone)
{
  vtkMediumScene scene = MakeScene();
  for (int integrator : Marching)
  {
    const vtkMediumPlan plan(scene, With(integrator), Device());
    const bool controlled = integrator == Mapper::ErrorControlled;
    EXPECT_EQ(plan.UseTiles, controlled);
    EXPECT_EQ(Has(plan, "TILES"), controlled);
    EXPECT_EQ(Reads(plan, "EmptyBricks"), controlled);
  }
  scene.Content.Altered = true;
  const vtkMediumPlan altered(scene, With(Mapper::ErrorControlled), Device());
  EXPECT_FALSE(altered.UseTiles || Has(altered, "TILES") || Reads(altered, "EmptyBricks"));
  Settings far = With(Mapper::ErrorControlled);
  far.ControlledStep = 1.01 * vtkMediumPlan::LongestLeaptStep * 0.01;
  EXPECT_FALSE(vtkMediumPlan(MakeScene(), far, Device()).LeapEyeSteps)
    << "asking costs as much as a step";
  far.ControlledStep = 0.99 * vtkMediumPlan::LongestLeaptStep * 0.01;
  EXPECT_TRUE(vtkMediumPlan(MakeScene(), far, Device()).LeapEyeSteps);
}

//------------------------------------------------------------------------------
// Whatever numbers an interactive session sets, one structure of scene has six programs at most: three ways
// to a light, each carried from draw to draw or not.
TEST(PlanVariants, AreSixAtMostForOneScene)
{
  std::set<std::string> keys;
  vtkMediumScene scene = MakeScene();
  for (double step : { 0.0, 1e-6, 1e-4, 1e-3, 0.01, 0.1, 1.0 })
  {
    for (vtkMediumPlan::LightMethods method :
      { vtkMediumPlan::March, vtkMediumPlan::LookUp, vtkMediumPlan::MarchThenLookUp })
    {
      for (bool hurried : { false, true })
      {
        for (double number : { 0.1, 1.0, 10.0 })
        {
          Settings settings = With(Mapper::ErrorControlled);
          settings.ControlledStep = step;
          settings.ControlledLightStep = step / 2;
          settings.LightMethod = method;
          settings.LightTolerance = number;
          settings.Hurried = hurried;
          settings.MaximumError = 0.1 * number;
          settings.TransmittanceThreshold = 0.01 * number;
          scene.Content.DensityScale = number;
          scene.Content.Extinction.Scale = glm::dvec3(number);
          scene.Content.Scattering.Scale = glm::dvec3(0.1 * number);
          scene.Lights[0].Irradiance = glm::dvec3(number, 1, 0);
          scene.Lights[0].Direction = glm::normalize(glm::dvec3(number, -1, 0.3));
          Collect(vtkMediumPlan(scene, settings, Device()), keys);
        }
      }
    }
  }
  EXPECT_EQ(keys.size(), 6u);
}

//------------------------------------------------------------------------------
// One light is its own program, since a loop over lights costs more than the light. Lights that look up
// caches have one to four textures of them; beyond, their number is a number.
TEST(PlanVariants, NumberOfLightsMakesFewPrograms)
{
  const std::map<vtkMediumPlan::LightMethods, std::size_t> expected = {
    { vtkMediumPlan::March, 2 }, { vtkMediumPlan::LookUp, 1 + 4 + 1 },
    { vtkMediumPlan::MarchThenLookUp, 2 * (1 + 4) + 1 }, // look-up and march
  };
  for (const auto& [method, programs] : expected)
  {
    std::set<std::string> keys;
    for (int lights = 1; lights <= 40; ++lights)
    {
      vtkMediumScene scene = MakeScene();
      scene.Lights.resize(lights, scene.Lights[0]);
      Settings settings = With(Mapper::ErrorControlled);
      settings.LightMethod = method;
      Device endless; // so that no march is carried from draw to draw
      endless.LoopIterations = 1 << 30;
      Collect(vtkMediumPlan(scene, settings, endless), keys);
    }
    EXPECT_EQ(keys.size(), programs) << method;
  }
}
