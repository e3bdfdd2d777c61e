// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// From the back to the front: a pane of glass, two volumes that the culler puts in order, though the
// near one was added first, and another pane in a layer above.
#include "Baseline.h"
#include "Stage.h"

#include "vtkBackToFrontVolumeCuller.h"
#include "vtkCullerCollection.h"
#include "vtkPlaneSource.h"
#include "vtkProperty.h"

namespace
{
vtkActor* AddPane(Stage& stage, double left, double y, const glm::dvec3& color)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(left, y, -0.25);
  plane->SetPoint1(left + 0.6, y, -0.25);
  plane->SetPoint2(left, y, 0.4);
  vtkActor* pane = stage.AddActor(plane, color);
  pane->GetProperty()->SetOpacity(0.6);
  return pane;
}
}

int GlassAndVolumes(int argc, char* argv[])
{
  Stage stage;
  const auto blobs = Stage::Blobs(glm::ivec3(32));
  vtkVolume* nearer = stage.AddVolume(blobs, Stage::Medium(20, { 1, 0.75, 0.4 }));
  nearer->SetPosition(0.3, -0.6, 0.1);
  stage.AddVolume(blobs, Stage::Medium(20, { 0.4, 0.7, 1 }))->SetPosition(-0.1, 0.6, 0);
  stage.AddSun({ -2, -2, 2 }, glm::dvec3(1), 16);
  AddPane(stage, -0.9, 1.3, { 0.2, 0.6, 0.25 });
  vtkRenderer* below = stage.GetView();
  vtkNew<vtkBackToFrontVolumeCuller> culler;
  below->GetCullers()->AddItem(culler);
  stage.LookFrom({ 0.1, -3, 0.5 }, 1.5);

  vtkRenderer* above = stage.AddView();
  above->SetLayer(1);
  stage.GetWindow()->SetNumberOfLayers(2);
  above->SetActiveCamera(below->GetActiveCamera());
  AddPane(stage, -0.3, -1.3, { 0.7, 0.15, 0.2 });
  below->ResetCameraClippingRange(-1, 1, -1.4, 1.4, -1, 1);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "the volumes in the order of adding",
    [&] { below->GetCullers()->RemoveItem(culler); });
}
