// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Length of the way through five blobs that have grown together, as grey.
#include "Baseline.h"
#include "Stage.h"

int PaperDistance(int argc, char* argv[])
{
  Stage stage;
  vtkVolume* volume =
    stage.AddVolume(Stage::Blobs(glm::ivec3(48)), Stage::Medium(8, glm::dvec3(1)));
  vtkSingleScatteringVolumeMapper* mapper = Stage::GetMapper(volume);
  mapper->SetIntegratorToPaper();
  mapper->SetOutputToDistance();
  mapper->SetPaperThreshold(0.2);
  stage.LookFrom({ 2, -3, 1.2 }, 1.6);
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "another threshold", [&] { mapper->SetPaperThreshold(0.3); });
}
