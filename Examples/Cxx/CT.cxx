// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A CT scan as a participating medium: bone in a thin fog of skin and tissue, lit by two lights.
#include "Picture.h"
#include "VolumeReader.h"

#include "vtkParticipatingMedium.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <iostream>
#include <stdexcept>

/// CT number in HU, extinction in 1/mm, albedo; linear between.
const double Tissue[][5] = { { -400, 0.0, 0.80, 0.58, 0.46 }, { -150, 0.006, 0.85, 0.56, 0.43 },
  { 100, 0.009, 0.88, 0.55, 0.42 }, { 250, 0.02, 0.92, 0.74, 0.60 },
  { 600, 0.25, 0.95, 0.88, 0.78 }, { 1500, 0.90, 0.99, 0.97, 0.93 } };

int main(int argc, char* argv[])
{
  Picture::Options options;
  options.Output = "ct.png";
  options.Step = 0; // mm; 0: the mapper finds it
  options = Picture::ReadOptions(argc, argv,
    "INPUT is a .vti, .nii, .nii.gz, .mhd, .mha or .nrrd file or a folder of DICOM slices, in HU\n"
    "and mm. Debian's package invesalius-examples has a skull as .inv3, which the Python example\n"
    "reads; Examples/Data/cranium.py makes a .vti of it.",
    options);
  vtkNew<vtkSingleScatteringVolumeMapper> mapper;
  try
  {
    mapper->SetInputData(VolumeReader::Read(options.Input));
  }
  catch (const std::runtime_error& error)
  {
    std::cerr << "CT: " << error.what() << "\n";
    return 2;
  }
  mapper->SetMaximumError(4.0 / 255);
  if (options.Step > 0)
  {
    mapper->SetIntegratorToFixedStep();
    mapper->SetSampleDistance(options.Step);
    mapper->SetLightSampleDistance(2 * options.Step);
  }

  vtkNew<vtkPiecewiseFunction> extinction;
  vtkNew<vtkColorTransferFunction> albedo;
  for (const auto& [number, sigma, red, green, blue] : Tissue)
  {
    extinction->AddPoint(number, sigma);
    albedo->AddRGBPoint(number, red, green, blue);
  }
  vtkNew<vtkParticipatingMedium> tissue;
  tissue->SetExtinctionFunction(extinction);
  tissue->SetAlbedoColorFunction(albedo);
  mapper->SetMedium(tissue);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetInterpolationTypeToLinear();

  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkLight> key, fill; // far away; irradiance is what a surface that faces them receives
  key->SetPosition(1.0, 1.4, 1.2);
  key->SetColor(1.0, 0.95, 0.88);
  key->SetIntensity(10);
  fill->SetPosition(-1.5, -0.5, 0.3);
  fill->SetColor(0.55, 0.72, 1.0);
  fill->SetIntensity(6.5);
  renderer->AddLight(key);
  renderer->AddLight(fill);
  renderer->SetBackground(0.02, 0.025, 0.035);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 1, 0);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewUp(0, 0, 1);
  camera->Azimuth(-40);
  camera->Elevation(8);
  renderer->ResetCamera();
  camera->Zoom(1.55);
  camera->SetWindowCenter(0, -0.12); // a head is in the lower half of its scan
  vtkNew<vtkRenderWindow> window;
  window->SetSize(options.Size, options.Size);
  window->AddRenderer(renderer);
  return Picture::Finish(window, { { "CT", mapper } }, options);
}
