// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A ball of fog with a lamp close to it; the light falls off with the square of the distance, and
// Schlick's phase function sends most of it forward.
#include "Baseline.h"
#include "Stage.h"

#include <glm/geometric.hpp>

int PaperLampInFog(int argc, char* argv[])
{
  Stage stage;
  const auto ball = [](const glm::dvec3& x) { return 1 - glm::length(x); };
  vtkVolume* volume =
    stage.AddVolume(Stage::Voxels(glm::ivec3(48), ball), Stage::Medium(5, { 0.9, 0.8, 0.6 }));
  vtkSingleScatteringVolumeMapper* mapper = Stage::GetMapper(volume);
  mapper->SetIntegratorToPaper();
  mapper->SetPaperThreshold(0.55); // the ball's radius is 0.45
  mapper->SetAnisotropy(0.3);
  stage.AddLamp({ -0.6, -0.6, 0.5 }, glm::dvec3(1), 10)->SetAttenuationValues(0, 0, 1);
  stage.LookFrom({ 2, -3, 1.5 }, 1.7);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "steps 8 times as long",
    [&] { mapper->SetSampleDistance(8.0 / 47); });
}
