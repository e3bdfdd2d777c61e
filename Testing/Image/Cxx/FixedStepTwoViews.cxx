// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// One volume in two views of a window, from the front and from above: each is clipped to its own
// part, and has its own lights.
#include "Baseline.h"
#include "Stage.h"

#include "vtkMediumFixtures.h"

#include "vtkCamera.h"

int FixedStepTwoViews(int argc, char* argv[])
{
  Stage stage(300, 180);
  vtkRenderer* front = stage.AddView(0, 0.6);
  vtkVolume* volume =
    stage.AddVolume(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(48)),
      Stage::Medium(14, glm::dvec3(1)));
  stage.AddSun({ -2, -2, 2 }, { 1, 0.85, 0.65 }, 14);
  stage.LookFrom({ 0, -3, 0 }, 1.6);
  vtkRenderer* above = stage.AddView(0.6, 1);
  above->AddVolume(volume);
  above->SetBackground(0.08, 0.1, 0.14);
  stage.AddSun({ 2, -2, 2 }, { 0.65, 0.8, 1 }, 14);
  stage.LookFrom({ 0, -0.01, 3 });
  return Baseline::Compare(argc, argv, stage.GetWindow(), "the cameras exchanged", [&] {
    vtkSmartPointer<vtkCamera> camera = front->GetActiveCamera();
    front->SetActiveCamera(above->GetActiveCamera());
    above->SetActiveCamera(camera);
  });
}
