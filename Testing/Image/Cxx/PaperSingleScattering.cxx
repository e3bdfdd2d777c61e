// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A cube of fog in the middle of a 0/1 volume, lit from the upper left: bright on that side, darker
// along every way that light must go to get in.
#include "Baseline.h"
#include "Stage.h"

#include <glm/common.hpp>

int PaperSingleScattering(int argc, char* argv[])
{
  Stage stage;
  const auto cube = [](const glm::dvec3& x) {
    const glm::dvec3 side = glm::abs(x);
    return side.x < 0.3 && side.y < 0.3 && side.z < 0.3 ? 1 : 0;
  };
  vtkVolume* volume =
    stage.AddVolume(Stage::Voxels(glm::ivec3(48), cube), Stage::Medium(6, { 0.95, 0.97, 1 }));
  Stage::GetMapper(volume)->SetIntegratorToPaper();
  vtkLight* sun = stage.AddSun({ -1, -1, 1.5 }, { 1, 0.95, 0.85 }, 16);
  stage.LookFrom({ 2, -3, 2 }, 1.7);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "light from the other side",
    [&] { sun->SetPosition(1, 1, -1.5); });
}
