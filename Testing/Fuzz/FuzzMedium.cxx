// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A medium from arrays, functions and constants: refused in words, or sound wherever it is looked up.
#include "FuzzedInput.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkMediumFuzz::Bytes bytes(data, size);
  vtkMediumFuzz::Input input(bytes);
  FillMedium(bytes, input.Medium);
  vtkMediumScene scene;
  for (int time = 0; time < 2; ++time) // the second on what the first has kept
  {
    const std::string problem = scene.GatherVolume(
      input.Image, input.Scalars, input.OnCells, input.Volume, input.Medium, bytes.Number(-1, 1));
    vtkNew<vtkImageData> mask;
    FillGeometry(bytes, mask);
    bool onCells = false;
    vtkMediumFuzz::AddArray(bytes, mask, "mask", onCells);
    onCells ? mask->GetCellData()->SetActiveScalars("mask")
            : mask->GetPointData()->SetActiveScalars("mask");
    if (problem.empty() &&
      scene.GatherMask(input.Image, bytes.Bit() ? mask.Get() : nullptr).empty())
    {
      vtkMediumFuzz::DemandSoundScene(scene);
    }
    FillMedium(bytes, input.Medium);
  }
  return 0;
}
