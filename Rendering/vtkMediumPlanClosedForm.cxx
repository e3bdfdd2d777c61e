// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Which scenes are integrated in closed form: homogeneous boxes in directional light.
#include "vtkMediumPlan.h"

#include "vtkMediumUserCode.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkMediumPlan::HasClosedForm(const vtkMediumScene& scene, const Settings& settings) const
{
  using Mapper = vtkSingleScatteringVolumeMapper;
  const bool promisesError =
    settings.Integrator == Mapper::ErrorControlled || settings.Integrator == Mapper::Exact;
  const bool ownCode = this->UserCode && this->UserCode->Has(vtkMediumUserCode::InScatter);
  const bool meanDepth =
    settings.Output == Mapper::Depth && settings.DepthDefinition == Mapper::MeanScatteringDepth;
  // What cuts eye rays short is in their ends; what cuts light rays short is not in the form.
  const bool cut = scene.Cut.CutsRegions() || (this->Lit && !scene.Cut.Planes.empty());
  const auto directional = [](const vtkMediumScene::Light& light) {
    return light.Type == vtkMediumScene::Light::Directional;
  };
  return promisesError && !ownCode && !meanDepth && !cut && this->ConstantExtinction &&
    this->Fields.empty() && !this->OpaqueShadows &&
    (!this->Lit || std::all_of(scene.Lights.begin(), scene.Lights.end(), directional));
}

//------------------------------------------------------------------------------
void vtkMediumPlan::PlanClosedForm(const vtkMediumScene& scene, const Capabilities& device)
{
  this->ClosedForm = true;
  this->EyeStep = this->LightStep = 1; // the longest ray there is
  const int lights = this->Lit ? static_cast<int>(scene.Lights.size()) : 0;
  const int group =
    device.LoopIterations / 8; // leaves room for what a loop costs beyond its iterations
  for (int first = 0; first < std::max(lights, 1); first += group)
  {
    this->Passes.push_back({ first, std::min(first + group, lights), 0, 1 });
  }
}
