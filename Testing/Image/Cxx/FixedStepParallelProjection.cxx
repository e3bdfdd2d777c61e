// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A box of even fog in parallel projection: edges that are parallel stay so.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCamera.h"

int FixedStepParallelProjection(int argc, char* argv[])
{
  Stage stage;
  const auto even = [](const glm::dvec3&) { return 1; };
  stage.AddVolume(Stage::Voxels(glm::ivec3(32), even), Stage::Medium(3, { 0.75, 0.9, 1 }));
  stage.AddSun({ -2, -1, 2 }, glm::dvec3(1), 14);
  vtkCamera* camera = stage.GetView()->GetActiveCamera();
  camera->ParallelProjectionOn();
  stage.LookFrom({ 2, -3, 2 }, 1.05);
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "perspective", [&] { camera->ParallelProjectionOff(); });
}
