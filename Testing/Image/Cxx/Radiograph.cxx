// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What light from behind loses, in parallel projection: additive blending on the left adds the extinction
// up; on the right is what is left of the light, white where there is nothing.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCamera.h"

int Radiograph(int argc, char* argv[])
{
  Stage stage(320, 160);
  const auto blobs = Stage::Blobs(glm::ivec3(32));
  vtkSingleScatteringVolumeMapper* additive = nullptr;
  for (bool right : { false, true })
  {
    stage.AddView(right ? 0.5 : 0, right ? 1 : 0.5);
    auto* mapper = Stage::GetMapper(stage.AddVolume(blobs, Stage::Medium(7, glm::dvec3(1))));
    if (right)
    {
      mapper->SetOutputToTransmittance();
      stage.GetView()->SetBackground(1, 1, 1);
    }
    else
    {
      additive = mapper;
      mapper->SetBlendModeToAdditive();
    }
    stage.GetView()->GetActiveCamera()->ParallelProjectionOn();
    stage.LookFrom({ 0.5, -3, 0.7 }, 1.5);
  }
  return Baseline::Compare(argc, argv, stage.GetWindow(), "composite blending",
    [&] { additive->SetBlendModeToComposite(); });
}
