// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Five smooth blobs between a warm and a cold light, over a background that shows through.
#include "Baseline.h"
#include "Stage.h"

int FixedStepTwoLights(int argc, char* argv[])
{
  Stage stage;
  stage.AddVolume(Stage::Blobs(glm::ivec3(32)), Stage::Medium(12, glm::dvec3(0.95)));
  vtkLight* warm = stage.AddSun({ -3, -1, 1 }, { 1, 0.55, 0.25 }, 16);
  vtkLight* cold = stage.AddSun({ 3, -0.5, 0.5 }, { 0.25, 0.5, 1 }, 16);
  stage.GetView()->SetBackground(0.1, 0.11, 0.14);
  stage.LookFrom({ 0.5, -3, 1 }, 1.5);
  return Baseline::Compare(argc, argv, stage.GetWindow(), "the lights' colours exchanged", [&] {
    warm->SetColor(0.25, 0.5, 1);
    cold->SetColor(1, 0.55, 0.25);
  });
}
