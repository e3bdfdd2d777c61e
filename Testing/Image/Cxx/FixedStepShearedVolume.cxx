// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A smooth medium in voxels of 1 : 2 : 4, sheared and turned by the volume's matrix.
#include "Baseline.h"
#include "Stage.h"

#include "vtkMatrix4x4.h"

int FixedStepShearedVolume(int argc, char* argv[])
{
  Stage stage;
  vtkVolume* volume =
    stage.AddVolume(Stage::Blobs({ 65, 33, 17 }), Stage::Medium(10, { 0.85, 1, 0.9 }));
  // A unit cube's edges become (0.9, 0.3, 0), (-0.35, 0.9, 0.1) and (0.6, 0, 0.8).
  const double sheared[16] = { 0.9, -0.35, 0.6, 0, 0.3, 0.9, 0, 0, 0, 0.1, 0.8, 0, 0, 0, 0, 1 };
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(sheared);
  volume->SetUserMatrix(matrix);
  stage.AddSun({ -2, -2, 2 }, glm::dvec3(1), 16);
  stage.LookFrom({ 1, -3, 1 }, 1.7);
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "the matrix transposed", [&] { matrix->Transpose(); });
}
