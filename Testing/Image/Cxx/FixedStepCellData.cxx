// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A medium on 12^3 cells: the fog ends at the cells' borders, not at their centres.
#include "Baseline.h"
#include "Stage.h"

#include "vtkMediumFixtures.h"

int FixedStepCellData(int argc, char* argv[])
{
  Stage stage;
  const auto make = [](bool onCells) {
    return vtkMediumFixtures::MakeImage(
      vtkMediumFixtures::Binary, glm::ivec3(onCells ? 13 : 12), glm::dvec3(1), onCells);
  };
  vtkSingleScatteringVolumeMapper* mapper =
    Stage::GetMapper(stage.AddVolume(make(true), Stage::Medium(12, { 0.85, 0.9, 1 })));
  mapper->SetSampleDistance(1.0 / 48);
  stage.AddSun({ -1, -2, 2.5 }, glm::dvec3(1), 16);
  stage.LookFrom({ 1.2, -1.6, 2.2 }, 1.5);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "the values on points",
    [&] { mapper->SetInputData(make(false)); });
}
