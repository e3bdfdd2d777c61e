// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 15 to 21: lights near, far, behind, none, many, faint and bright.
#include "StressStage.h"

#include "vtkLightCollection.h"

namespace vtkMediumStress
{
namespace
{
void NearPointLight(Trial& trial)
{
  const double sigma = 0.7;
  for (double distance : { 0.3, 0.1, 1e-2, 1e-3 })
  {
    Stage stage(trial, MakeBox(), 4);
    const glm::dvec3 source(distance, 0, 0.1);
    stage.AddPointLight(source);
    stage.LookParallel({ 0, 0, -1 }, 2, 0.2 * distance);
    stage.SetSigma(sigma);
    stage.Mapper->SetMaximumError(1e-3);
    stage.SetSteps(std::min(0.005, 0.1 * distance), 2);
    const Picture picture = stage.Render();
    ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
      const std::array<double, 2> t = Box(glm::dvec3(1)).Intersect(ray);
      const double truth = Isotropic * PointSourceRadiance(ray, source, sigma, t[0], t[1]);
      trial.AtMost(std::abs(picture.At(x, y) / truth - 1), 0.01,
        "relative error at distance " + std::to_string(distance));
    });
  }
}

/// What a source can add at most: it is taken as 1e-4 of the diagonal away (see vtkMediumLight.glsl).
void LightOnSpecialPoints(Trial& trial)
{
  const double nearest = 1e-4 * std::sqrt(3.0);
  const double bound = Isotropic * std::sqrt(3.0) / (nearest * nearest);
  const glm::dvec3 voxel(0, 1.0 / 6, 0), eye(0.1, 0.1, 0.3), corner(0.5), middle(0);
  for (const glm::dvec3& place : { voxel, eye, corner, middle })
  {
    Stage stage(trial, MakeBox(), 9);
    stage.AddPointLight(place);
    stage.Mapper->SetMaximumError(0.01);
    for (bool inside : { false, true })
    {
      inside ? stage.Look({ 0, 0, -1 }, 0.3, { 0.1, 0.1, 0 }) : stage.Look({ 0, 0, -1 }, 2);
      stage.SetSteps(0.112, 0.1); // nine of them, the fifth at the middle of the box
      const Picture picture = stage.Render();
      trial.AtMost(*std::max_element(picture.Values.begin(), picture.Values.end()), bound,
        "radiance, against that of the nearest distance");
      trial.Holds(picture.Mean() > 0, "it is lit");
    }
  }
}

void FarPointLight(Trial& trial)
{
  Stage stage(trial, MakeBox());
  stage.Look({ 0.2, 0.1, -1 }, 2);
  stage.SetFineSteps(1);
  const glm::dvec3 towards = glm::normalize(glm::dvec3(0.3, 0.8, 0.4));
  vtkSmartPointer<vtkLight> light = stage.AddBeam(-towards);
  const Picture beam = stage.Render();
  stage.Renderer->RemoveLight(light);
  light = stage.AddPointLight(1e8 * towards);
  light->SetIntensity(1e16);
  CheckSame(trial, beam, stage.Render(), 1e-3, "light 1e8 away against a beam");
}

void LightBehind(Trial& trial)
{
  Stage stage(trial, MakeBox());
  stage.Look({ 0.1, -0.05, -1 }, 2);
  const double sigma = 2;
  stage.SetSigma(sigma);
  stage.SetFineSteps(sigma);
  for (const glm::dvec3& at :
    { glm::dvec3(0, 0, 1), { 0, 0, -1 }, { 0.3, 0.2, 1 }, { 0.3, 0.2, -1 } })
  {
    const glm::dvec3 towards = glm::normalize(at);
    vtkSmartPointer<vtkLight> beam = stage.AddBeam(-towards);
    TruthA{ towards, sigma }.Check(stage, "beam");
    stage.Renderer->RemoveLight(beam);
    vtkSmartPointer<vtkLight> point = stage.AddPointLight(1e6 * towards);
    point->SetAttenuationValues(1, 0, 0);
    TruthA{ towards, sigma }.Check(stage, "positional light");
    stage.Renderer->RemoveLight(point);
  }
}

void NoLight(Trial& trial)
{
  Stage stage(trial, MakeBox());
  stage.Look({ 0.2, 0.1, -1 }, 2);
  const Picture none = stage.Render();
  stage.AddBeam({ 0, -1, 0 })->SetIntensity(0);
  trial.Holds(
    none.Values == stage.Render().Values, "no light is a light of intensity 0, to the bit");
  ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
    trial.Holds(none.At(x, y) == 0, "nothing is lit");
    trial.AtMost(QError(none.At(x, y, 3), TruthA{ { 0, 1, 0 }, 1 }.Alpha(ray)), 1e-4, "alpha");
  });
}

/// A field in the integrators that draw one.
vtkSmartPointer<vtkImageData> MakeMedium(Trial& trial)
{
  return trial.Is(Mapper::Paper)
    ? MakeBox()
    : vtkMediumFixtures::MakeImage(vtkMediumFixtures::Smooth, glm::ivec3(9));
}

struct LightsStage : Stage
{
  explicit LightsStage(Trial& trial)
    : Stage(trial, MakeMedium(trial), 6)
  {
    this->Look({ 0.2, 0.1, -1 }, 2);
    if (!trial.Is(vtkMediumStress::Mapper::Paper))
    {
      this->SetField(3);
    }
    this->SetSteps(0.1, 0.1);
  }

  void Add(std::uint32_t number)
  {
    const glm::dvec3 direction = vtkMediumFixtures::RandomDirection(number, 20);
    vtkSmartPointer<vtkLight> light =
      number % 2 ? this->AddBeam(direction) : this->AddPointLight(1.5 * direction);
    light->SetIntensity(0.5 + vtkMediumFixtures::Random(number, 21));
    light->SetDiffuseColor(1, vtkMediumFixtures::Random(number, 22), 0.5);
  }
};

void ManyLights(Trial& trial)
{
  const std::uint32_t count = 64;
  LightsStage stage(trial);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    stage.Add(i);
  }
  const Picture all = stage.Render();
  stage.Renderer->RemoveAllLights();
  for (std::uint32_t i = count; i-- > 0;)
  {
    stage.Add(i);
  }
  CheckSame(trial, all, stage.Render(), Same, "64 lights in reverse");
  Picture sum = all;
  std::fill(sum.Values.begin(), sum.Values.end(), 0.0f);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    stage.Renderer->RemoveAllLights();
    stage.Add(i);
    const Picture one = stage.Render();
    for (std::size_t v = 0; v < sum.Values.size(); ++v)
    {
      sum.Values[v] = v % 4 == 3 ? one.Values[v] : sum.Values[v] + one.Values[v];
    }
  }
  // ErrorControlled answers for each single frame's peak, which 64 lights share.
  CheckSame(trial, all, sum, trial.Is(Mapper::ErrorControlled) ? 5e-4 : Same, "sum of 64 singles");
}

void ScaledColour(Trial& trial)
{
  LightsStage stage(trial);
  stage.Add(1);
  vtkLight* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
  light->SetDiffuseColor(1, 0.5, 0.25);
  const Picture one = stage.Render();
  for (double factor : { 1e-6, 1e6 })
  {
    light->SetDiffuseColor(factor, 0.5 * factor, 0.25 * factor);
    Picture scaled = stage.Render();
    for (std::size_t v = 0; v < scaled.Values.size(); ++v)
    {
      scaled.Values[v] = static_cast<float>(scaled.Values[v] / (v % 4 == 3 ? 1 : factor));
    }
    CheckSame(trial, one, scaled, Same, "colour times " + std::to_string(factor));
  }
}
}

std::vector<Row> LightRows()
{
  return {
    { 15, "NearPointLightIsTruthC", "1 %, in steps of a tenth of its distance from the ray",
      NearPointLight, {} },
    { 16, "LightOnVoxelCameraAndSampleIsBounded",
      "σ p d / r², r the distance below which attenuation is held: 1e-4 of the diagonal",
      LightOnSpecialPoints, {} },
    { 17, "FarPointLightIsABeam", "1e-3: float's rounding of 1e8 in local units", FarPointLight,
      {} },
    { 18, "LightBehindCameraOrVolumeIsTruthA", "as row 2", LightBehind, {} },
    { 19, "WithoutLightOnlyTransmittanceIsLeft", "bitwise; alpha Q", NoLight,
      { { Mapper::Paper, "refuses a scene without light by an error (row 55's kind)" } } },
    { 20, "SixtyFourLightsAddUpInAnyOrder", "S; ErrorControlled's sum of singles 5e-4: 64 peaks",
      ManyLights, {} },
    { 21, "RadianceIsLinearInTheLight", "S", ScaledColour, {} },
  };
}
}
