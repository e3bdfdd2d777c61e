// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A cube of smoke cropped to a cross of three beams, on a volume that is turned: the beams shade each other
// and nothing else does.
#include "Baseline.h"
#include "Stage.h"

int CroppedCross(int argc, char* argv[])
{
  Stage stage;
  vtkVolume* cube = stage.AddVolume(
    Stage::Voxels(glm::ivec3(9), [](const glm::dvec3& x) { return 0.7 + 0.5 * x.z; }),
    Stage::Medium(9, { 0.9, 0.95, 1 }));
  cube->RotateZ(25);
  vtkSingleScatteringVolumeMapper* mapper = Stage::GetMapper(cube);
  mapper->SetSampleDistance(0.02);
  mapper->CroppingOn();
  mapper->SetCroppingRegionPlanes(-0.12, 0.12, -0.2, 0.15, -0.1, 0.2);
  mapper->SetCroppingRegionFlagsToCross();
  stage.AddSun({ -1, -1.5, 2 }, glm::dvec3(1), 14);
  stage.LookFrom({ 1, -2, 1.2 }, 1.6);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "a fence instead of a cross",
    [&] { mapper->SetCroppingRegionFlagsToFence(); });
}
