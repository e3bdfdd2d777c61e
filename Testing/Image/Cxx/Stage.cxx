// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include "vtkMediumFixtures.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCubeSource.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <cmath>

//------------------------------------------------------------------------------
Stage::Stage(int width, int height)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
}

//------------------------------------------------------------------------------
Stage::~Stage() = default;

//------------------------------------------------------------------------------
vtkRenderer* Stage::AddView(double left, double right)
{
  vtkNew<vtkRenderer> view;
  view->SetViewport(left, 0, right, 1);
  view->AutomaticLightCreationOff();
  this->Window->AddRenderer(view);
  this->View = view;
  return view;
}

//------------------------------------------------------------------------------
vtkRenderer* Stage::GetView()
{
  return this->View ? this->View : this->AddView();
}

//------------------------------------------------------------------------------
vtkVolume* Stage::AddVolume(vtkImageData* image, vtkVolumeProperty* medium)
{
  vtkNew<vtkSingleScatteringVolumeMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetIntegratorToFixedStep();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(medium);
  this->GetView()->AddVolume(volume);
  return volume;
}

//------------------------------------------------------------------------------
vtkSingleScatteringVolumeMapper* Stage::GetMapper(vtkVolume* volume)
{
  return vtkSingleScatteringVolumeMapper::SafeDownCast(volume->GetMapper());
}

//------------------------------------------------------------------------------
vtkActor* Stage::AddActor(vtkPolyDataAlgorithm* source, const glm::dvec3& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color.r, color.g, color.b);
  this->GetView()->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkLight* Stage::AddSun(const glm::dvec3& towards, const glm::dvec3& color, double irradiance)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(towards.x, towards.y, towards.z);
  light->SetFocalPoint(0, 0, 0);
  light->SetColor(color.r, color.g, color.b);
  light->SetIntensity(irradiance);
  this->GetView()->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
vtkLight* Stage::AddLamp(const glm::dvec3& place, const glm::dvec3& color, double irradiance)
{
  vtkLight* light = this->AddSun(place, color, irradiance);
  light->PositionalOn();
  light->SetConeAngle(180);
  return light;
}

//------------------------------------------------------------------------------
void Stage::LookFrom(const glm::dvec3& direction, double zoom)
{
  vtkCamera* camera = this->GetView()->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(direction.x, direction.y, direction.z);
  camera->SetViewUp(0, 0, 1);
  this->GetView()->ResetCamera();
  camera->Zoom(zoom);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Stage::Blobs(const glm::ivec3& points)
{
  return Stage::Voxels(points, [](const glm::dvec3& x) {
    const glm::dvec3 fade = 1.0 - 16.0 * x * x * x * x; // 1 in the middle, 0 at a face
    return vtkMediumFixtures::SmoothDensity(x + 0.5, 1) * fade.x * fade.y * fade.z;
  });
}

//------------------------------------------------------------------------------
vtkCamera* Stage::LookAtPosts()
{
  this->AddVolume(Stage::Blobs(glm::ivec3(32)), Stage::Medium(12, glm::dvec3(1)));
  this->AddSun({ -2, -2, 2 }, glm::dvec3(1), 16);
  for (int side : { -1, 1 })
  {
    vtkNew<vtkCubeSource> post;
    post->SetXLength(0.06);
    post->SetYLength(0.06);
    post->SetZLength(0.9);
    post->SetCenter(0.15 * side, -0.4 * side, 0);
    this->AddActor(post, glm::dvec3(0.5));
  }
  this->LookFrom({ 0.6, -3, 0.8 }, 1.4);
  return this->GetView()->GetActiveCamera();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeProperty> Stage::Medium(double extinction, const glm::dvec3& albedo)
{
  // Straight in extinction is curved in opacity; 64 pieces follow it to better than 1 grey level.
  constexpr int Pieces = 64;
  constexpr double UnitDistance = 0.01;
  vtkNew<vtkPiecewiseFunction> opacity;
  for (int piece = 0; piece <= Pieces; ++piece)
  {
    const double density = piece / static_cast<double>(Pieces);
    opacity->AddPoint(density, -std::expm1(-extinction * density * UnitDistance));
  }
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0, albedo.r, albedo.g, albedo.b);
  color->AddRGBPoint(1, albedo.r, albedo.g, albedo.b);
  auto medium = vtkSmartPointer<vtkVolumeProperty>::New();
  medium->SetScalarOpacity(opacity);
  medium->SetColor(color);
  medium->SetScalarOpacityUnitDistance(UnitDistance);
  medium->SetInterpolationTypeToLinear();
  return medium;
}
