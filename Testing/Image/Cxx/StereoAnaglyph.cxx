// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A red and blue-green picture of two eyes: red is what the left one sees. Things in the plane of the
// focal point have no coloured edges, what is nearer or farther has.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCamera.h"

int StereoAnaglyph(int argc, char* argv[])
{
  Stage stage;
  vtkCamera* camera = stage.LookAtPosts();
  camera->SetEyeAngle(4);
  stage.GetWindow()->SetStereoTypeToAnaglyph();
  stage.GetWindow()->SetAnaglyphColorMask(4, 3);
  stage.GetWindow()->StereoRenderOn();
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "the eyes exchanged", [&] { camera->SetEyeAngle(-4); });
}
