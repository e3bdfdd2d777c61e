// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A cube of fog in a 0/1 volume of 256^3 voxels, in the three modes of Han, Ki and Oh's Table 1:
// first intersection, distance from the first to the last intersection, single scattering.
#include "Picture.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageConstantPad.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <map>

int main(int argc, char* argv[])
{
  Picture::Options options;
  options.Output = "fog_cube.png";
  options.Step = 1.0 / 128;
  options = Picture::ReadOptions(argc, argv, "Renders a cube of fog in three modes.", options);

  // 160^3 ones in the middle of 256^3 voxels; the edge of the volume is 1 long.
  vtkNew<vtkImageData> ones;
  ones->SetDimensions(160, 160, 160);
  ones->SetSpacing(1.0 / 255, 1.0 / 255, 1.0 / 255);
  ones->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  ones->GetPointData()->GetScalars()->Fill(1);
  vtkNew<vtkImageConstantPad> voxels;
  voxels->SetInputData(ones);
  voxels->SetOutputWholeExtent(-48, 207, -48, 207, -48, 207);

  // Extinction 5 per unit of length, an optical depth of 3 across the fog; all light is scattered.
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0);
  opacity->AddPoint(1, 1 - std::exp(-0.05));
  vtkNew<vtkColorTransferFunction> albedo;
  albedo->AddRGBPoint(1, 1, 1, 1);
  vtkNew<vtkVolumeProperty> fog;
  fog->SetScalarOpacity(opacity);
  fog->SetColor(albedo);
  fog->SetScalarOpacityUnitDistance(0.01);

  vtkNew<vtkRenderWindow> window;
  window->SetSize(3 * options.Size, options.Size);
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(0.31, 0.31, 0.27);
  camera->SetPosition(1.5, -1.25, 1.15);
  camera->SetViewUp(0, 0, 1);
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(180);
  lamp->SetPosition(0.5, -1.3, 1.6);
  lamp->SetIntensity(16);

  using Mapper = vtkSingleScatteringVolumeMapper;
  const char* const names[] = { "single scattering", "first intersection", "distance" };
  std::map<std::string, Mapper*> mappers;
  int column = 0;
  for (const int output : { Mapper::FirstHit, Mapper::Distance, Mapper::Radiance })
  {
    vtkNew<Mapper> mapper;
    mapper->SetInputConnection(voxels->GetOutputPort());
    mapper->SetIntegratorToPaper();
    mapper->SetOutput(output);
    mapper->SetSampleDistance(options.Step);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->SetProperty(fog);
    vtkNew<vtkTextActor> label;
    label->SetInput(names[output]);
    label->SetPosition(12, 10);
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(column / 3.0, 0, (column + 1) / 3.0, 1);
    renderer->SetActiveCamera(camera);
    renderer->AddLight(lamp);
    renderer->AddVolume(volume);
    renderer->AddViewProp(label);
    renderer->ResetCameraClippingRange();
    window->AddRenderer(renderer);
    mappers[names[output]] = mapper;
    ++column;
  }
  return Picture::Finish(window, mappers, options);
}
