// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A CT scan as a participating medium: bone in a thin fog of skin and tissue, lit by two lights.
#include "Picture.h"
#include "VolumeReader.h"

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

#include <cmath>
#include <iostream>
#include <stdexcept>

namespace
{
/// CT number in HU, extinction in 1/mm, albedo; linear between.
const double Tissue[][5] = {
  { -400, 0.0, 0.80, 0.58, 0.46 },
  { -150, 0.006, 0.85, 0.56, 0.43 },
  { 100, 0.009, 0.88, 0.55, 0.42 },
  { 250, 0.02, 0.92, 0.74, 0.60 },
  { 600, 0.25, 0.95, 0.88, 0.78 },
  { 1500, 0.90, 0.99, 0.97, 0.93 },
};

//------------------------------------------------------------------------------
void SetTissue(vtkVolumeProperty* property)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> albedo;
  const double* previous = nullptr;
  for (const auto& node : Tissue)
  {
    // VTK's opacity is that of one unit of length; eight pieces follow the curve between nodes.
    for (int piece = 1; previous && piece <= 8; ++piece)
    {
      const double t = piece / 8.0;
      const double extinction = previous[1] + t * (node[1] - previous[1]);
      opacity->AddPoint(previous[0] + t * (node[0] - previous[0]), -std::expm1(-extinction));
    }
    albedo->AddRGBPoint(node[0], node[2], node[3], node[4]);
    previous = node;
  }
  opacity->AddPoint(Tissue[0][0], 0);
  property->SetScalarOpacity(opacity);
  property->SetColor(albedo);
  property->SetScalarOpacityUnitDistance(1); // mm
  property->SetInterpolationTypeToLinear();
}

//------------------------------------------------------------------------------
// A lamp far away; irradiance is what a surface that faces it receives.
void AddLight(vtkRenderer* renderer, double x, double y, double z, double red, double green,
  double blue, double irradiance)
{
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(x, y, z);
  lamp->SetFocalPoint(0, 0, 0);
  lamp->SetColor(red, green, blue);
  lamp->SetIntensity(irradiance);
  renderer->AddLight(lamp);
}
}

int main(int argc, char* argv[])
{
  Picture::Options options;
  options.Output = "ct.png";
  options.Size = 512;
  options.Step = 0; // mm; 0: the mapper finds it
  options = Picture::ReadOptions(argc, argv,
    "INPUT is a .vti, .nii, .nii.gz, .mhd, .mha or .nrrd "
    "file or a folder of DICOM slices, in HU and mm; Examples/Data/cranium.py makes one.",
    options);
  vtkNew<vtkSingleScatteringVolumeMapper> mapper;
  try
  {
    if (options.Input.empty())
    {
      throw std::runtime_error("no volume; name a file (--help tells which)");
    }
    mapper->SetInputData(VolumeReader::Read(options.Input));
  }
  catch (const std::runtime_error& error)
  {
    std::cerr << "CT: " << error.what() << "\n";
    return 2;
  }
  if (options.Step > 0)
  {
    mapper->SetIntegratorToFixedStep();
    mapper->SetSampleDistance(options.Step);
    mapper->SetLightSampleDistance(2 * options.Step);
  }
  else
  {
    mapper->SetIntegratorToErrorControlled();
    mapper->SetMaximumError(4.0 / 255);
  }

  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  SetTissue(volume->GetProperty());
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  AddLight(renderer, 1.0, 1.4, 1.2, 1.0, 0.95, 0.88, 10);
  AddLight(renderer, -1.5, -0.5, 0.3, 0.55, 0.72, 1.0, 6.5);
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
