// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A cloud's shadow on a floor, from the light that is left at each of its points; blue is weakened most.
#include "Baseline.h"
#include "Stage.h"

#include "vtkDoubleArray.h"
#include "vtkMapper.h"
#include "vtkParticipatingMedium.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkSingleScatteringReference.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace
{
// The colours of an unlit floor of reflectance 0.8 in white light of irradiance 1.
bool Shade(vtkPlaneSource* floor, vtkSingleScatteringReference* reference, vtkLight* light)
{
  floor->Update();
  vtkPolyData* surface = floor->GetOutput();
  vtkNew<vtkDoubleArray> left;
  if (!reference->LightTransmittance(light, surface->GetPoints(), left))
  {
    return false;
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType point = 0; point < left->GetNumberOfTuples(); ++point)
  {
    for (int c = 0; c < 3; ++c)
    {
      colors->InsertNextValue(
        static_cast<unsigned char>(std::lround(255 * 0.8 * left->GetComponent(point, c))));
    }
  }
  surface->GetPointData()->SetScalars(colors);
  return true;
}
}

int ShadowOnFloor(int argc, char* argv[])
{
  Stage stage;
  vtkVolume* volume =
    stage.AddVolume(Stage::Blobs(glm::ivec3(24)), Stage::Medium(1, glm::dvec3(1)));
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetExtinctionArrayName("density");
  medium->SetExtinctionScale(4, 6, 9);
  medium->SetAlbedo(0.95);
  Stage::GetMapper(volume)->SetMedium(medium);
  vtkLight* sun = stage.AddSun({ -0.7, -0.3, 1.2 }, glm::dvec3(1), 12);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-0.8, -0.8, -0.5);
  floor->SetPoint1(1.2, -0.8, -0.5);
  floor->SetPoint2(-0.8, 1.2, -0.5);
  floor->SetResolution(64, 64);
  vtkNew<vtkSingleScatteringReference> reference;
  reference->SetVolume(volume);
  reference->SetMedium(medium);
  reference->SetTolerance(1e-4);
  if (!Shade(floor, reference, sun))
  {
    return EXIT_FAILURE;
  }
  stage.AddActor(floor, glm::dvec3(1))->GetMapper()->SetInputDataObject(floor->GetOutput());
  stage.LookFrom({ 0.6, -3, 1.8 }, 1.4);
  return Baseline::Compare(
    argc, argv, stage.GetWindow(), "the sun's shadow from the other side", [&] {
      sun->SetPosition(0.7, -0.3, 1.2);
      Shade(floor, reference, sun);
      sun->SetPosition(-0.7, -0.3, 1.2);
    });
}
