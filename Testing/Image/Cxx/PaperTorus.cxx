// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A ring of fog. Left: taken for convex, as the paper has it, light and eye see its near part only.
// Right: as it is; the far part is seen, and lies in the shadow of the near one.
#include "Baseline.h"
#include "Stage.h"

#include <cmath>

int PaperTorus(int argc, char* argv[])
{
  Stage stage(360, 180);
  const auto ring = [](const glm::dvec3& x) {
    return std::hypot(std::hypot(x.x, x.y) - 0.33, x.z) < 0.13 ? 1 : 0;
  };
  const auto voxels = Stage::Voxels(glm::ivec3(64), ring);
  vtkSingleScatteringVolumeMapper* mappers[2];
  for (int side : { 0, 1 })
  {
    stage.AddView(0.5 * side, 0.5 * side + 0.5);
    mappers[side] = Stage::GetMapper(stage.AddVolume(voxels, Stage::Medium(2.5, { 1, 0.8, 0.6 })));
    mappers[side]->SetIntegratorToPaper();
    mappers[side]->SetAssumeConvex(side == 0);
    stage.AddSun({ 2, -3, 0.8 }, glm::dvec3(1), 22);
    stage.LookFrom({ 1, -3, 0.9 }, 1.8);
  }
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "both taken for convex", [&] { mappers[1]->AssumeConvexOn(); });
}
