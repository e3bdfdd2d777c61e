// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// An engine-like block filled with fog, as Han, Ki and Oh drew the Engine: on the left with their
// assumption that the filled part is convex, which leaves holes, on the right without it.
#include "EngineBlock.h"
#include "Picture.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>
#include <map>
#include <stdexcept>

int main(int argc, char* argv[])
{
  Picture::Options options;
  options.Output = "engine_stand_in.png";
  options.Step = 2;
  options = Picture::ReadOptions(
    argc, argv, "INPUT is the real Engine, 256 x 256 x 128 raw bytes; none: a stand-in.", options);
  std::string name = "procedural stand-in, not the real Engine";
  vtkSmartPointer<vtkImageData> image;
  try
  {
    image = options.Input.empty() ? EngineBlock::Make() : EngineBlock::Read(options.Input);
    name = options.Input.empty() ? name : options.Input;
  }
  catch (const std::runtime_error& error)
  {
    std::cerr << "EngineStandIn: " << error.what() << "\n";
    return 2;
  }

  // One medium for all that is filled: extinction 0.04 per voxel, and an albedo of warm metal.
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, -std::expm1(-0.04));
  vtkNew<vtkColorTransferFunction> albedo;
  albedo->AddRGBPoint(0, 1.0, 0.93, 0.82);
  vtkNew<vtkVolumeProperty> metal;
  metal->SetScalarOpacity(opacity);
  metal->SetColor(albedo);

  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(180);
  lamp->SetPosition(-350, -250, 320);
  lamp->SetIntensity(15);
  vtkNew<vtkCamera> camera;
  camera->SetFocalPoint(128, 122, 60);
  camera->SetPosition(-145, -298, 330);
  camera->SetViewUp(0, 0, 1);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(2 * options.Size, options.Size);
  std::map<std::string, vtkSingleScatteringVolumeMapper*> mappers;
  for (const bool convex : { true, false })
  {
    const std::string title = convex ? "assumed convex" : "every interval";
    vtkNew<vtkSingleScatteringVolumeMapper> mapper;
    mapper->SetInputData(image);
    mapper->SetIntegratorToPaper();
    mapper->SetPaperThreshold(60);
    mapper->SetAssumeConvex(convex);
    mapper->SetSampleDistance(options.Step);
    vtkNew<vtkVolume> volume;
    volume->SetMapper(mapper);
    volume->SetProperty(metal);
    vtkNew<vtkTextActor> label;
    label->SetInput((title + "\n" + name).c_str());
    label->SetPosition(12, 10);
    vtkNew<vtkRenderer> renderer;
    renderer->SetViewport(convex ? 0 : 0.5, 0, convex ? 0.5 : 1, 1);
    renderer->SetActiveCamera(camera);
    renderer->AddLight(lamp);
    renderer->AddVolume(volume);
    renderer->AddViewProp(label);
    renderer->ResetCameraClippingRange();
    window->AddRenderer(renderer);
    mappers[title] = mapper;
  }
  return Picture::Finish(window, mappers, options);
}
