// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A red and blue-green picture of two eyes: red is what the left one sees. Things in the plane of the
// focal point have no coloured edges, what is nearer or farther has.
#include "Baseline.h"
#include "Stage.h"

#include "vtkCamera.h"
#include "vtkCubeSource.h"

int StereoAnaglyph(int argc, char* argv[])
{
  Stage stage;
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
  camera->SetEyeAngle(4);
  stage.GetWindow()->SetStereoTypeToAnaglyph();
  stage.GetWindow()->SetAnaglyphColorMask(4, 3);
  stage.GetWindow()->StereoRenderOn();
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "the eyes exchanged", [&] { camera->SetEyeAngle(-4); });
}
