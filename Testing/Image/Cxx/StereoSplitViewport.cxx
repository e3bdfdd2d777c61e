// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The two eyes side by side in the halves of the window, as VTK splits its viewports for them; each
// picture is as wide as half of the window.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCamera.h"

int StereoSplitViewport(int argc, char* argv[])
{
  Stage stage(320, 160);
  vtkCamera* camera = stage.LookAtPosts();
  camera->SetEyeAngle(8);
  stage.GetWindow()->SetStereoTypeToSplitViewportHorizontal();
  stage.GetWindow()->StereoRenderOn();
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "both eyes at one place", [&] { camera->SetEyeAngle(0); });
}
