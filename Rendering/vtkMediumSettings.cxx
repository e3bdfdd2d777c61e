// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumSettings.h"

#include "vtkMediumStatistics.h"
#include "vtkSingleScatteringVolumeMapper.h"

//------------------------------------------------------------------------------
vtkMediumPlan::Settings vtkMediumSettingsOf(vtkSingleScatteringVolumeMapper* mapper)
{
  vtkMediumPlan::Settings settings;
  settings.Integrator = mapper->GetIntegrator();
  settings.Output = mapper->GetOutput();
  if (mapper->GetBlendMode() == vtkVolumeMapper::ADDITIVE_BLEND &&
    settings.Output == vtkSingleScatteringVolumeMapper::Radiance)
  {
    settings.Output = vtkSingleScatteringVolumeMapper::OpticalDepth; // what adds up along a ray
  }
  settings.SampleDistance = mapper->GetSampleDistance();
  settings.LightSampleDistance = mapper->GetLightSampleDistance();
  settings.BinarySearchIterations = mapper->GetBinarySearchIterations();
  settings.Jitter = mapper->GetJitter();
  settings.TransmittanceThreshold = mapper->GetTransmittanceThreshold();
  settings.PaperThreshold = mapper->GetPaperThreshold();
  settings.AssumeConvex = mapper->GetAssumeConvex();
  settings.CountTaps = mapper->GetStatistics()->GetCountTaps();
  settings.DepthDefinition = mapper->GetDepthDefinition();
  settings.DepthTransmittance = mapper->GetDepthTransmittance();
  settings.MaximumError = mapper->GetMaximumError();
  settings.OpaqueShadowResolution = mapper->GetOpaqueShadowResolution();
  settings.LightMethod = mapper->GetLightCaches() == vtkSingleScatteringVolumeMapper::CachesNever
    ? vtkMediumPlan::March
    : vtkMediumPlan::LookUp;
  return settings;
}
