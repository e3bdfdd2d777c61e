// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A block of haze with a tunnel of blanked cells: eye rays see through it, and light that comes through
// it is not weakened.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCellData.h"
#include "vtkUniformGrid.h"

#include <cmath>

int BlankedVoxels(int argc, char* argv[])
{
  constexpr int Points = 24;
  Stage stage;
  vtkNew<vtkUniformGrid> grid;
  grid->DeepCopy(Stage::Voxels(glm::ivec3(Points), [](const glm::dvec3&) { return 1.0; }));
  constexpr int Cells = Points - 1;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const double x = cell % Cells + 0.5 - 0.5 * Cells,
                 z = cell / (Cells * Cells) + 0.5 - 0.5 * Cells;
    if (std::hypot(x, z) < 5)
    {
      grid->BlankCell(cell);
    }
  }
  auto* mapper = Stage::GetMapper(stage.AddVolume(grid, Stage::Medium(5, { 1, 0.9, 0.75 })));
  mapper->SetSampleDistance(0.015);
  stage.AddSun({ 0.2, -2, 1.2 }, glm::dvec3(1), 14);
  stage.LookFrom({ 1.4, -3, 1.4 }, 1.5);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "nothing blanked", [&] {
    grid->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    grid->Modified();
  });
}
