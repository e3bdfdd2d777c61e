// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A cloud before the sun: its thin edges shine, since droplets scatter forward (g = 0.7).
#include "Baseline.h"
#include "Stage.h"

#include "vtkMediumFixtures.h"

int FixedStepForwardCloud(int argc, char* argv[])
{
  Stage stage;
  vtkSingleScatteringVolumeMapper* mapper = Stage::GetMapper(
    stage.AddVolume(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(48)),
      Stage::Medium(14, glm::dvec3(1))));
  mapper->SetAnisotropy(0.7);
  stage.AddSun({ -0.9, 3, 1.4 }, { 1, 0.93, 0.8 }, 5);
  stage.AddSun({ 1, -1, 2 }, { 0.6, 0.75, 1 }, 10);
  stage.GetView()->SetBackground(0.16, 0.28, 0.45);
  stage.LookFrom({ 0.3, -3, 0.6 }, 1.6);
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "g = 0", [&] { mapper->SetAnisotropy(0); });
}
