// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Cameras, lights, clipping planes and cropping around any image, and the plan that is made of them.
#include "FuzzedInput.h"

#include "vtkMediumPlan.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace
{
using vtkMediumFuzz::Bytes;
using vtkMediumFuzz::Demand;

void AddLights(Bytes& bytes, vtkRenderer* renderer)
{
  renderer->SetAutomaticLightCreation(bytes.Bit());
  for (int count = bytes.Whole(4); count > 0; --count)
  {
    vtkNew<vtkLight> light;
    light->SetLightType(1 + bytes.Whole(3));
    light->SetSwitch(bytes.Whole(8) != 0);
    light->SetPositional(bytes.Bit());
    light->SetPosition(bytes.Number(-2, 2), bytes.Number(-2, 2), bytes.Number(-2, 2));
    light->SetFocalPoint(bytes.Number(-2, 2), bytes.Number(-2, 2), bytes.Number(-2, 2));
    light->SetConeAngle(bytes.Number(0, 180));
    light->SetExponent(bytes.Number(0, 10));
    light->SetIntensity(bytes.Number(0, 2));
    light->SetDiffuseColor(bytes.Number(0, 1), bytes.Number(0, 1), bytes.Number(0, 1));
    light->SetAttenuationValues(bytes.Number(0, 1), bytes.Number(0, 1), bytes.Number(0, 1));
    if (bytes.Whole(4) == 0)
    {
      vtkNew<vtkMatrix4x4> matrix;
      for (int i = 0; i < 12; ++i)
      {
        matrix->SetElement(i / 4, i % 4, bytes.Number(-1, 1));
      }
      light->SetTransformMatrix(matrix);
    }
    renderer->AddLight(light);
  }
}

void FillCamera(Bytes& bytes, vtkCamera* camera)
{
  camera->SetPosition(bytes.Number(-4, 4), bytes.Number(-4, 4), bytes.Number(-4, 4));
  camera->SetFocalPoint(bytes.Number(-1, 1), bytes.Number(-1, 1), bytes.Number(-1, 1));
  camera->SetViewUp(bytes.Number(-1, 1), bytes.Number(-1, 1), bytes.Number(-1, 1));
  camera->SetViewAngle(bytes.Number(1, 170));
  camera->SetParallelProjection(bytes.Bit());
  camera->SetParallelScale(bytes.Number(0.1, 2));
  camera->SetClippingRange(bytes.Number(0.01, 1), bytes.Number(2, 20));
}

void FillCut(Bytes& bytes, vtkSingleScatteringVolumeMapper* mapper)
{
  mapper->SetCropping(bytes.Bit());
  mapper->SetCroppingRegionFlags(
    bytes.Byte() | bytes.Byte() << 8 | bytes.Byte() << 16 | bytes.Whole(8) << 24);
  double planes[6];
  for (double& plane : planes)
  {
    plane = bytes.Number(-1, 3);
  }
  mapper->SetCroppingRegionPlanes(planes);
  for (int count = bytes.Whole(4); count > 0; --count)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(bytes.Number(-1, 1), bytes.Number(-1, 1), bytes.Number(-1, 1));
    plane->SetNormal(bytes.Number(-1, 1), bytes.Number(-1, 1), bytes.Number(-1, 1));
    mapper->AddClippingPlane(plane);
  }
}

/// The settings of a mapper, and what a device may be.
vtkMediumPlan::Settings FillSettings(Bytes& bytes, vtkMediumPlan::Capabilities& device)
{
  vtkMediumPlan::Settings settings;
  settings.Integrator = bytes.Whole(4);
  settings.Output = bytes.Whole(8);
  settings.SampleDistance = bytes.Number(0, 1);
  settings.LightSampleDistance = bytes.Number(0, 1);
  settings.BinarySearchIterations = bytes.Whole(11);
  settings.Jitter = bytes.Number(0, 0.99);
  settings.TransmittanceThreshold = bytes.Number(0, 0.5);
  settings.PaperThreshold = bytes.Number(0, 1);
  settings.AssumeConvex = bytes.Bit();
  settings.CountTaps = bytes.Bit();
  settings.DepthDefinition = bytes.Whole(3);
  settings.DepthTransmittance = bytes.Number(0.01, 0.99);
  settings.MaximumError = bytes.Number(0.001, 0.1);
  settings.LightMethod = static_cast<vtkMediumPlan::LightMethods>(bytes.Whole(3));
  settings.ControlledStep = bytes.Bit() ? 0 : 1e-4 + bytes.Unit();
  device.LoopIterations = bytes.Bit() ? 65536 : 1 << 22;
  device.TextureSize3D = bytes.Whole(8) == 0 ? 3 : 2048;
  device.CoarseFilter = bytes.Bit();
  return settings;
}

void CheckPlan(const vtkMediumPlan& plan, const vtkMediumScene& scene,
  const vtkMediumPlan::Settings& settings, const vtkMediumPlan::Capabilities& device)
{
  if (!plan.Refusal.empty())
  {
    return;
  }
  Demand(!plan.ShaderFiles.empty() && !plan.ShaderDefines.empty(), "a plan has a program");
  Demand(plan.CachedLights <= static_cast<int>(scene.Lights.size()), "caches are of lights");
  if (settings.Integrator == vtkSingleScatteringVolumeMapper::Exact && !plan.ClosedForm)
  {
    Demand(plan.IterationBudget > 0 && plan.IterationBudget < device.LoopIterations,
      "Exact keeps to the device's iterations");
    return;
  }
  Demand(plan.EyeStep >= vtkMediumPlan::ShortestStep && plan.EyeStep < 1e300, "a step is one");
  Demand(!plan.Passes.empty(), "something is drawn");
  // Parts follow one another through all steps, for each group of lights in turn.
  int light = 0, step = 0;
  for (const vtkMediumPlan::Pass& pass : plan.Passes)
  {
    if (pass.FirstLight != light)
    {
      light = pass.FirstLight;
      step = 0;
    }
    Demand(pass.FirstStep == step && pass.LastStep > step, "no step is left out or drawn twice");
    step = pass.LastStep;
  }
  Demand(step * plan.EyeStep >= 1, "the steps reach through the volume");
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  vtkMediumFuzz::Input input(bytes);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkCamera> camera;
  renderer->SetActiveCamera(camera);
  FillCamera(bytes, camera);
  AddLights(bytes, renderer);
  vtkNew<vtkSingleScatteringVolumeMapper> mapper;
  FillCut(bytes, mapper);
  vtkMediumPlan::Capabilities device;
  const vtkMediumPlan::Settings settings = FillSettings(bytes, device);
  if (bytes.Bit())
  {
    FillMedium(bytes, input.Medium);
  }
  vtkMediumScene scene;
  if (!scene.GatherVolume(input.Image, input.Scalars, input.OnCells, input.Volume, input.Medium, 0)
         .empty() ||
    !scene.GatherMask(input.Image, nullptr).empty() ||
    !scene.GatherCut(mapper, input.Volume).empty() || !scene.GatherLights(renderer).empty() ||
    !scene.GatherView(camera->GetCompositeProjectionTransformMatrix(1, -1, 1)).empty())
  {
    return 0;
  }
  for (const vtkMediumScene::Light& light : scene.Lights)
  {
    Demand(light.Irradiance.x >= 0 && std::isfinite(light.Irradiance.x), "light is >= 0");
    Demand(std::abs(glm::length(light.Direction) - 1) < 1e-6, "a light's direction is of length 1");
  }
  const vtkMediumPlan plan(scene, settings, device);
  CheckPlan(plan, scene, settings, device);
  const glm::ivec4 scissor = vtkMediumPlan::FindScissor(scene.Eye, scene.Geometry, { 16, 9 });
  Demand(scissor.x >= 0 && scissor.y >= 0 && scissor.z >= 0 && scissor.w >= 0 &&
      scissor.x + scissor.z <= 16 && scissor.y + scissor.w <= 9,
    "the scissor lies in the viewport");
  return 0;
}
