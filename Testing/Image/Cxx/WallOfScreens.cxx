// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A wall of four screens: each viewport shows its quarter of one picture through an off-centre
// window of the camera, and the frames between the screens hide nothing of it.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkMath.h"
#include "vtkSmartPointer.h"

#include <cmath>

int WallOfScreens(int argc, char* argv[])
{
  constexpr double Frame = 0.01; // of the wall's edge, around each screen
  Stage stage(220, 220);
  vtkVolume* volume =
    stage.AddVolume(Stage::Blobs(glm::ivec3(32)), Stage::Medium(9, { 0.95, 0.97, 1 }));
  vtkLight* sun = stage.AddSun({ -2, -2, 2 }, glm::dvec3(1), 14);
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(48);
  cone->SetDirection(0.2, 0, 1);
  cone->SetHeight(0.9);
  cone->SetRadius(0.15);
  vtkActor* spike = stage.AddActor(cone, { 0.75, 0.2, 0.12 });
  stage.LookFrom({ 1.5, -3, 1.2 }, 1.4);
  const vtkSmartPointer<vtkCamera> whole = stage.GetView()->GetActiveCamera();
  const double half = std::tan(vtkMath::RadiansFromDegrees(whole->GetViewAngle()) / 2);

  vtkRenderer* screen = nullptr;
  for (int number = 0; number < 4; ++number)
  {
    const int column = number % 2, row = number / 2;
    screen = number == 0 ? stage.GetView() : stage.AddView();
    screen->SetViewport(
      0.5 * column + Frame, 0.5 * row + Frame, 0.5 * (column + 1) - Frame, 0.5 * (row + 1) - Frame);
    screen->SetBackground(0.1, 0.12, 0.16);
    vtkNew<vtkCamera> quarter;
    quarter->DeepCopy(whole);
    quarter->SetViewAngle(vtkMath::DegreesFromRadians(2 * std::atan(half / 2)));
    quarter->SetWindowCenter(2 * column - 1, 2 * row - 1);
    screen->SetActiveCamera(quarter);
    if (number > 0)
    {
      screen->AddVolume(volume);
      screen->AddActor(spike);
      screen->AddLight(sun);
    }
  }
  return Baseline::Compare(argc, argv, stage.GetWindow(), "the last screen's window not moved",
    [&] { screen->GetActiveCamera()->SetWindowCenter(0, 0); });
}
