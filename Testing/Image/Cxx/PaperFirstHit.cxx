// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Distance to the first point of a ring, a ball and a rod, as grey: near is bright.
#include "Baseline.h"
#include "Stage.h"

#include "vtkMediumFixtures.h"

int PaperFirstHit(int argc, char* argv[])
{
  Stage stage;
  vtkVolume* volume =
    stage.AddVolume(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Binary, glm::ivec3(64)),
      Stage::Medium(8, glm::dvec3(1)));
  Stage::GetMapper(volume)->SetIntegratorToPaper();
  Stage::GetMapper(volume)->SetOutputToFirstHit();
  stage.LookFrom({ 1.2, -1.6, 2.2 }, 1.6);
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "the volume mirrored", [&] { volume->SetScale(-1, 1, 1); });
}
