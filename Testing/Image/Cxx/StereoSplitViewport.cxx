// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The two eyes side by side in the halves of the window, as VTK splits its viewports for them; each
// picture is as wide as half of the window.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCamera.h"
#include "vtkCubeSource.h"

int StereoSplitViewport(int argc, char* argv[])
{
  Stage stage(320, 160);
  stage.AddVolume(Stage::Blobs(glm::ivec3(32)), Stage::Medium(12, glm::dvec3(1)));
  stage.AddSun({ -2, -2, 2 }, glm::dvec3(1), 16);
  for (int side : { -1, 1 }) // a post behind the middle, and one before it
  {
    vtkNew<vtkCubeSource> post;
    post->SetXLength(0.06);
    post->SetYLength(0.06);
    post->SetZLength(0.9);
    post->SetCenter(0.15 * side, -0.4 * side, 0);
    stage.AddActor(post, glm::dvec3(0.5));
  }
  stage.LookFrom({ 0.6, -3, 0.8 }, 1.4);
  vtkCamera* camera = stage.GetView()->GetActiveCamera();
  camera->SetEyeAngle(8);
  stage.GetWindow()->SetStereoTypeToSplitViewportHorizontal();
  stage.GetWindow()->StereoRenderOn();
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "both eyes at one place", [&] { camera->SetEyeAngle(0); });
}
