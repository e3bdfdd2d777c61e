// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The camera is in the cloud and looks past the sun: nothing is cut off near the eye.
#include "Baseline.h"
#include "Stage.h"

#include "vtkMediumFixtures.h"

#include "vtkCamera.h"

int FixedStepCameraInside(int argc, char* argv[])
{
  Stage stage;
  stage.AddVolume(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(48)),
    Stage::Medium(10, { 1, 0.97, 0.94 }));
  vtkLight* sun = stage.AddSun({ -1, 1, 1.5 }, { 1, 0.9, 0.75 }, 16);
  stage.GetView()->SetBackground(0.16, 0.28, 0.45);
  vtkCamera* camera = stage.GetView()->GetActiveCamera();
  camera->SetPosition(0.1, -0.2, 0.05);
  camera->SetFocalPoint(-0.2, 0.5, 0.15);
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(70);
  stage.GetView()->ResetCameraClippingRange();
  return Baseline::Compare(argc, argv, stage.GetWindow(), "light from the other side",
    [&] { sun->SetPosition(1, -1, -1.5); });
}
