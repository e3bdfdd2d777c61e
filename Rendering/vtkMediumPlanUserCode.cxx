// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What shader code of the user asks of a plan.
#include "vtkMediumPlan.h"

#include "vtkMediumUserCode.h"
#include "vtkSingleScatteringVolumeMapper.h"

//------------------------------------------------------------------------------
void vtkMediumPlan::PlanUserCode(const Settings& settings)
{
  using Mapper = vtkSingleScatteringVolumeMapper;
  this->UserCode = settings.UserCode;
  if (!this->UserCode || !this->Refusal.empty())
  {
    return;
  }
  for (const char* point : { vtkMediumUserCode::Coefficients, vtkMediumUserCode::InScatter })
  {
    if (settings.Integrator == Mapper::Paper && this->UserCode->Has(point))
    {
      this->Refusal = std::string("The volume's vtkShaderProperty has code at ") + point +
        ", which the Paper integrator does not have; choose another one "
        "(SetIntegratorToErrorControlled), or take the code away "
        "(ClearAllFragmentShaderReplacements).";
    }
  }
  this->Finishes =
    settings.Output == Mapper::Radiance && this->UserCode->Has(vtkMediumUserCode::Color);
}
