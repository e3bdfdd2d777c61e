// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Pins where a picker finds the medium, over a grid of pixels: they stick in what the picture shows,
// on its near side, and none stands where light passes.
#include "Baseline.h"
#include "Stage.h"

#include "vtkGlyph3D.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPropPicker.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace
{
// What a picker finds at every so many pixels of the window.
void Pick(Stage& stage, vtkPoints* places)
{
  constexpr int Step = 15;
  const int* size = stage.GetWindow()->GetSize();
  vtkNew<vtkPropPicker> picker;
  places->Reset();
  for (int y = Step / 2; y < size[1]; y += Step)
  {
    for (int x = Step / 2; x < size[0]; x += Step)
    {
      if (picker->Pick(x, y, 0, stage.GetView()))
      {
        places->InsertNextPoint(picker->GetPickPosition());
      }
    }
  }
  places->Modified();
}
}

int PickedPlaces(int argc, char* argv[])
{
  Stage stage(120, 120);
  const auto ring = Stage::Voxels(glm::ivec3(24), [](const glm::dvec3& x) {
    return std::clamp(4 - 20 * std::hypot(std::hypot(x.x, x.z) - 0.29, x.y), 0.0, 1.0);
  });
  vtkVolume* volume = stage.AddVolume(ring, Stage::Medium(30, { 0.6, 0.8, 1 }));
  stage.AddSun({ -2, -2, 2 }, glm::dvec3(1), 16);
  stage.LookFrom({ 0.8, -3, 0.7 }, 1.5);
  vtkNew<vtkPoints> places;
  stage.GetWindow()->Render();
  Pick(stage, places);
  if (places->GetNumberOfPoints() == 0)
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkPolyData> grid;
  grid->SetPoints(places);
  vtkNew<vtkSphereSource> head;
  head->SetRadius(0.025);
  vtkNew<vtkGlyph3D> heads;
  heads->SetInputData(grid);
  heads->SetSourceConnection(head->GetOutputPort());
  stage.AddActor(heads, { 1, 0.4, 0.1 })->PickableOff();
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "what is found while the medium is elsewhere", [&] {
      volume->SetPosition(0.3, 0, 0);
      Pick(stage, places);
      volume->SetPosition(0, 0, 0);
    });
}
