// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Shafts of light: a grating in the sun, and a ball around which a lamp inside the haze shines.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCubeSource.h"
#include "vtkSphereSource.h"

namespace
{
void AddHaze(Stage& stage)
{
  const auto haze = Stage::Voxels(glm::ivec3(4), [](const glm::dvec3&) { return 1.0; });
  auto* mapper = stage.GetMapper(stage.AddVolume(haze, Stage::Medium(0.9, glm::dvec3(1))));
  mapper->SetSampleDistance(0.02);
  mapper->OpaqueShadowsOn();
}
}

int ShadowsOfGeometry(int argc, char* argv[])
{
  Stage stage(360, 180);
  stage.AddView(0, 0.5);
  AddHaze(stage);
  stage.AddSun({ -0.6, -0.2, 1 }, glm::dvec3(1), 14);
  for (int bar = -2; bar <= 2; ++bar)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetCenter(0.2 * bar, 0, 0.6);
    cube->SetXLength(0.1);
    cube->SetYLength(1.4);
    cube->SetZLength(0.03);
    stage.AddActor(cube, { 0.3, 0.2, 0.1 });
  }
  stage.LookFrom({ 0.4, -3, 0.7 }, 1.3);

  stage.AddView(0.5, 1);
  AddHaze(stage);
  stage.AddLamp({ 0.05, 0, 0.1 }, { 1, 0.8, 0.5 }, 14);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(-0.12, -0.05, 0);
  ball->SetRadius(0.08);
  ball->SetThetaResolution(32);
  ball->SetPhiResolution(32);
  vtkActor* blocker = stage.AddActor(ball, { 0.1, 0.25, 0.4 });
  stage.LookFrom({ 0.4, -3, 0.7 }, 1.3);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "the ball on the other side of the lamp",
    [&] { blocker->SetPosition(0.3, 0, 0.2); });
}
