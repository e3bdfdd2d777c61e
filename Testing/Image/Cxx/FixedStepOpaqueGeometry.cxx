// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A cone stands in the fog on a plane that cuts the volume: what is behind an opaque surface adds
// nothing, what is before it veils it.
#include "Baseline.h"
#include "Stage.h"

#include "vtkConeSource.h"
#include "vtkPlaneSource.h"

int FixedStepOpaqueGeometry(int argc, char* argv[])
{
  Stage stage;
  stage.AddVolume(Stage::Blobs(glm::ivec3(32)), Stage::Medium(9, { 0.95, 0.97, 1 }));
  stage.AddSun({ -2, -2, 2 }, glm::dvec3(1), 14);
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(48);
  cone->SetDirection(0, 0, 1);
  cone->SetHeight(0.75);
  cone->SetRadius(0.22);
  vtkActor* spike = stage.AddActor(cone, { 0.75, 0.2, 0.12 });
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-0.7, -0.7, -0.25);
  plane->SetPoint1(0.7, -0.7, -0.25);
  plane->SetPoint2(-0.7, 0.7, -0.25);
  stage.AddActor(plane, { 0.16, 0.24, 0.2 });
  stage.LookFrom({ 1.5, -3, 1.6 }, 1.5);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "the cone behind the fog",
    [&] { spike->SetPosition(-0.25, 0.5, 0); });
}
