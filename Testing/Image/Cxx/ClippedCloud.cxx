// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A cloud cut by an oblique plane, under light from the removed side: the cut face is in full light.
#include "Baseline.h"
#include "Stage.h"
#include "vtkMediumFixtures.h"

#include "vtkPlane.h"

int ClippedCloud(int argc, char* argv[])
{
  Stage stage;
  vtkVolume* cloud =
    stage.AddVolume(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(48)),
      Stage::Medium(25, { 1, 0.96, 0.9 }));
  vtkNew<vtkPlane> plane;
  plane->SetNormal(-0.3, 1, -0.5);
  plane->SetOrigin(0, -0.05, 0.02);
  Stage::GetMapper(cloud)->AddClippingPlane(plane);
  stage.AddSun({ 0.6, -2, 1.5 }, { 1, 0.95, 0.85 }, 14);
  stage.GetView()->SetBackground(0.1, 0.16, 0.25);
  stage.LookFrom({ 0.5, -3, 0.8 }, 1.5);
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "the other half kept", [&] { plane->SetNormal(0.3, -1, 0.5); });
}
