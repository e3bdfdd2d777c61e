// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The reference along one ray through anything that is not refused: radiance is >= 0 and finite.
#include "FuzzedInput.h"

#include "vtkSingleScatteringReference.h"

#include "vtkCellData.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using vtkMediumFuzz::Demand;
  vtkMediumFuzz::Bytes bytes(data, size);
  vtkMediumFuzz::Input input(bytes);
  if (input.Scalars)
  {
    input.OnCells ? input.Image->GetCellData()->SetScalars(input.Scalars)
                  : input.Image->GetPointData()->SetScalars(input.Scalars);
  }
  vtkNew<vtkRenderer> renderer;
  renderer->SetAutomaticLightCreation(false);
  vtkNew<vtkLight> light;
  light->SetPositional(bytes.Bit());
  light->SetConeAngle(bytes.Number(10, 180));
  light->SetPosition(bytes.Number(-2, 2), bytes.Number(-2, 2), bytes.Number(-2, 2));
  renderer->AddLight(light);
  vtkNew<vtkSingleScatteringReference> reference;
  reference->SetInputData(input.Image);
  reference->SetVolume(input.Volume);
  reference->SetRenderer(renderer);
  reference->SetAnisotropy(bytes.Number(-1, 1));
  reference->SetTolerance(0.1);
  if (bytes.Bit())
  {
    FillMedium(bytes, input.Medium);
    reference->SetMedium(input.Medium);
  }
  const double origin[3] = { bytes.Number(-3, 3), bytes.Number(-3, 3), bytes.Number(-3, 3) };
  const double direction[3] = { bytes.Number(-1, 1), bytes.Number(-1, 1), bytes.Number(-1, 1) };
  double rgba[4];
  if (reference->Radiance(origin, direction, rgba))
  {
    for (double value : rgba)
    {
      Demand(value >= 0 && std::isfinite(value),
        "radiance is >= 0 and finite, not " + std::to_string(value));
    }
    Demand(rgba[3] <= 1, "alpha is at most 1");
  }
  const double depth = reference->OpticalDepth(origin, direction);
  Demand(std::isnan(depth) || (depth >= 0 && std::isfinite(depth)),
    "an optical depth is >= 0 and finite, not " + std::to_string(depth));
  return 0;
}
