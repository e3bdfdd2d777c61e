// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Depth peeling takes the volume as well: a slanted pane that stands in the medium is veiled where it is
// deep inside, and veils what is behind it; a ball of glass floats at the near side.
#include "Baseline.h"
#include "Stage.h"

#include "vtkPlaneSource.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

int GlassInTheMedium(int argc, char* argv[])
{
  Stage stage;
  stage.AddVolume(Stage::Blobs(glm::ivec3(32)), Stage::Medium(9, { 0.95, 0.97, 1 }));
  stage.AddSun({ -2, -2, 2 }, glm::dvec3(1), 14);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.6, -0.6, -0.3);
  plane->SetPoint1(0.6, 0.6, -0.3);
  plane->SetPoint2(-0.6, -0.6, 0.3);
  stage.AddActor(plane, { 0.8, 0.2, 0.15 })->GetProperty()->SetOpacity(0.7);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.25, -0.4, -0.05);
  ball->SetRadius(0.15);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(32);
  stage.AddActor(ball, { 0.2, 0.7, 0.3 })->GetProperty()->SetOpacity(0.5);
  vtkRenderer* view = stage.GetView();
  view->SetBackground(0.1, 0.12, 0.16);
  view->UseDepthPeelingOn();
  view->UseDepthPeelingForVolumesOn();
  view->SetMaximumNumberOfPeels(8);
  stage.GetWindow()->SetAlphaBitPlanes(1);
  stage.LookFrom({ 0.4, -3, 0.7 }, 1.5);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "all glass behind the medium",
    [&] { view->UseDepthPeelingForVolumesOff(); });
}
