// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzedScene.h"

#include "vtkColorTransferFunction.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"

#include <cmath>
#include <limits>

namespace vtkMediumStress
{
using vtkMediumTest::Picture;

namespace
{
constexpr int Types[] = { VTK_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
  VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_FLOAT, VTK_DOUBLE };
}

//------------------------------------------------------------------------------
FuzzedScene::FuzzedScene(unsigned seed, vtkRenderWindow* window)
  : Generator(seed)
  , Printed(new PrintedErrors)
  , Scene(
      new vtkMediumTest::Scene(vtkMediumTest::MakeBox(), 4 + static_cast<int>(seed % 13), window))
{
  this->Watch.Start(this->Scene->Window);
  this->Interruptions = this->Chance(0.2) ? 0.3 : 0;
  this->Listen();
}

//------------------------------------------------------------------------------
FuzzedScene::~FuzzedScene()
{
  this->Interruptions = 0;
  this->Watch.Stop(this->Scene->Window);
}

//------------------------------------------------------------------------------
double FuzzedScene::Unit()
{
  return this->Generator() / 4294967296.0; // the same on every platform, unlike a distribution
}

//------------------------------------------------------------------------------
int FuzzedScene::Whole(int count)
{
  return static_cast<int>(this->Unit() * count);
}

//------------------------------------------------------------------------------
double FuzzedScene::Length()
{
  return std::pow(10.0, 6 * this->Unit() - 3);
}

//------------------------------------------------------------------------------
double FuzzedScene::Odd()
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double values[] = { 0.0, -0.0, 1.0, -1.0, 1e-300, -1e-300, 1e-40, 1e-12, 1e12, 1e38, 1e39,
    1e300, -1e300, 5e-324, infinity, -infinity, std::nan("") };
  return values[this->Whole(sizeof(values) / sizeof(values[0]))];
}

//------------------------------------------------------------------------------
double FuzzedScene::Or(double sensible)
{
  return this->Chance(0.015) ? this->Odd() : sensible;
}

//------------------------------------------------------------------------------
void FuzzedScene::ChangeImage()
{
  const bool cells = this->Chance(0.2);
  glm::ivec3 points;
  for (int axis = 0; axis < 3; ++axis)
  {
    points[axis] = this->Chance(0.01) ? 1 : 2 + this->Whole(9);
  }
  const int type = Types[this->Whole(9)];
  const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
  const double scale = real ? this->Or(1) : 100;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points.x, points.y, points.z);
  const glm::ivec3 lattice = cells ? glm::max(points - 1, 0) : points;
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName("density");
  array->SetNumberOfComponents(this->Chance(0.8) ? 1 : 1 + this->Whole(5));
  array->SetNumberOfTuples(static_cast<vtkIdType>(lattice.x) * lattice.y * lattice.z);
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    const double value = scale * this->Unit();
    array->SetVariantValue(i, real && this->Chance(0.002) ? this->Odd() : value);
  }
  if (!this->Chance(0.01))
  {
    cells ? image->GetCellData()->SetScalars(array) : image->GetPointData()->SetScalars(array);
  }
  this->Size = this->Length();
  const double spacing = this->Size / 10;
  image->SetSpacing(this->Or(spacing * (0.5 + this->Unit())), this->Or(spacing), this->Or(spacing));
  const double far = this->Chance(0.1) ? 1e6 * this->Size : 0;
  image->SetOrigin(this->Or(far - this->Size / 2), this->Or(-this->Size / 2), -this->Size / 2);
  this->Scene->Mapper->SetInputData(image);
  this->Scene->Mapper->SetScalarMode(this->Whole(4));
}

//------------------------------------------------------------------------------
void FuzzedScene::ChangeMatrix()
{
  vtkNew<vtkMatrix4x4> matrix;
  const bool general = this->Chance(0.5);
  for (int row = 0; general && row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, this->Or(2 * this->Unit() - 1));
    }
  }
  this->Scene->Volume->SetUserMatrix(matrix);
  this->Scene->Volume->SetScale(this->Or(1), 1, this->Chance(0.2) ? -1 : 1);
}

//------------------------------------------------------------------------------
void FuzzedScene::ChangeMapper()
{
  vtkSingleScatteringVolumeMapper* mapper = this->Scene->Mapper;
  mapper->SetMedium(this->Chance(0.6) ? this->Scene->Medium.Get() : nullptr);
  mapper->SetIntegrator(this->Whole(4));
  mapper->SetOutput(this->Chance(0.5) ? Mapper::Radiance : this->Whole(8));
  mapper->SetDepthDefinition(this->Whole(3));
  mapper->SetDepthTransmittance(this->Or(0.1 + 0.8 * this->Unit()));
  mapper->SetPhaseFunction(this->Whole(2));
  mapper->SetAnisotropy(this->Or(2 * this->Unit() - 1));
  mapper->SetMaximumError(this->Or(0.003 + 0.1 * this->Unit()));
  mapper->SetLightCaches(this->Whole(3));
  const double odd[] = { 0, -1, 1e300, std::numeric_limits<double>::infinity(), std::nan("") };
  const double eye = this->Size * (0.05 + 0.5 * this->Unit()),
               light = this->Size * (0.1 + this->Unit());
  mapper->SetSampleDistance(this->Chance(0.02) ? odd[this->Whole(5)] : eye);
  mapper->SetLightSampleDistance(this->Chance(0.02) ? odd[this->Whole(5)] : light);
  mapper->SetBinarySearchIterations(this->Whole(12));
  mapper->SetJitter(this->Or(0.99 * this->Unit()));
  mapper->SetTransmittanceThreshold(this->Or(0.1 * this->Unit()));
  mapper->SetPaperThreshold(this->Or(this->Unit()));
  mapper->SetAssumeConvex(this->Chance(0.3));
  mapper->SetRenderToImage(this->Chance(0.2));
  mapper->GetStatistics()->SetCountTaps(this->Chance(0.2));
  mapper->SetBlendMode(this->Chance(0.02) ? this->Whole(6) : 0);
  this->Scene->Property->SetInterpolationType(this->Whole(2));
}

//------------------------------------------------------------------------------
void FuzzedScene::ChangeCuts()
{
  vtkSingleScatteringVolumeMapper* mapper = this->Scene->Mapper;
  mapper->SetCropping(this->Chance(0.2));
  mapper->SetCroppingRegionFlags(this->Whole(1 << 27));
  double planes[6];
  for (int i = 0; i < 6; ++i)
  {
    planes[i] = this->Or(this->Size * ((i % 2 ? 0.8 : 0.2) * this->Unit() - 0.4));
  }
  mapper->SetCroppingRegionPlanes(planes);
  mapper->RemoveAllClippingPlanes();
  for (int count = this->Chance(0.2) ? 1 + this->Whole(3) : 0; count > 0; --count)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(this->Or(0), 0, this->Size * (this->Unit() - 0.5));
    plane->SetNormal(this->Or(this->Unit() - 0.5), this->Unit() - 0.5, this->Unit() - 0.5);
    mapper->AddClippingPlane(plane);
  }
}

//------------------------------------------------------------------------------
void FuzzedScene::ChangeMedium()
{
  vtkParticipatingMedium* medium = this->Scene->Medium;
  const bool field = this->Chance(0.6);
  const double extinction = 3 * this->Length() / this->Size;
  medium->SetParametrization(this->Whole(2));
  medium->SetExtinction(this->Or(extinction));
  medium->SetAbsorption(this->Or(extinction), this->Or(0.5 * extinction), extinction);
  medium->SetScattering(this->Or(extinction));
  medium->SetExtinctionArrayName(field ? "" : nullptr);
  medium->SetExtinctionScale(
    this->Or(extinction), this->Chance(0.5) ? extinction : 2 * extinction, extinction);
  medium->SetExtinctionComponent(this->Chance(0.05) ? this->Whole(5) : -1);
  medium->SetScatteringArrayName(this->Chance(0.2) ? "density" : nullptr);
  medium->SetScatteringScale(this->Or(extinction));
  medium->SetAlbedo(this->Or(this->Unit()), this->Or(this->Unit()), this->Or(this->Unit()));
  medium->SetAlbedoArrayName(this->Chance(0.02) ? "missing" : nullptr);
  medium->SetEmission(this->Chance(0.3) ? this->Or(this->Unit() / this->Size) : 0);
  medium->SetDensityScale(this->Or(this->Unit()));
  medium->SetLengthUnit(this->Or(1));
  medium->SetPhaseFunction(this->Whole(9));
  medium->SetAnisotropy(this->Or(2 * this->Unit() - 1));
  medium->SetBackAnisotropy(this->Or(-this->Unit()));
  medium->SetForwardWeight(this->Or(this->Unit()));
  medium->SetDraineAlpha(this->Or(this->Unit()));
  medium->SetDropletDiameter(this->Or(5 + 45 * this->Unit()));
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(this->Or(0), this->Or(this->Unit()));
  function->AddPoint(this->Or(1), this->Or(this->Unit()));
  medium->SetExtinctionFunction(this->Chance(0.2) ? function.Get() : nullptr);
}

//------------------------------------------------------------------------------
void FuzzedScene::ChangeProperty()
{
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkNew<vtkColorTransferFunction> color;
  const double range = this->Chance(0.5) ? 1 : 100;
  for (int count = this->Whole(5); count > 0; --count)
  {
    opacity->AddPoint(
      this->Or(range * this->Unit()), this->Or(this->Unit()), this->Unit(), this->Unit());
    color->AddRGBPoint(
      this->Or(range * this->Unit()), this->Or(this->Unit()), this->Unit(), this->Unit());
  }
  this->Scene->Property->SetScalarOpacity(opacity);
  this->Scene->Property->SetColor(color);
  this->Scene->Property->SetScalarOpacityUnitDistance(this->Or(this->Size * (0.01 + this->Unit())));
}

//------------------------------------------------------------------------------
void FuzzedScene::ChangeLights()
{
  this->Scene->Renderer->RemoveAllLights();
  for (int count = this->Chance(0.1) ? 20 : this->Whole(4); count > 0; --count)
  {
    const double reach = this->Size * 2;
    vtkSmartPointer<vtkLight> light = this->Scene->AddPointLight({ 0, 0, 0 });
    light->SetLightType(1 + this->Whole(3));
    light->SetPositional(this->Chance(0.5));
    light->SetPosition(this->Or(reach * (this->Unit() - 0.5)), reach * (this->Unit() - 0.5),
      this->Or(reach * (this->Unit() - 0.5)));
    light->SetFocalPoint(this->Or(0), 0, 0);
    light->SetConeAngle(this->Or(180 * this->Unit()));
    light->SetExponent(this->Or(10 * this->Unit()));
    light->SetIntensity(this->Or(this->Length()));
    light->SetDiffuseColor(this->Or(this->Unit()), this->Unit(), this->Unit());
    light->SetAttenuationValues(this->Or(this->Unit()), this->Or(0), this->Or(this->Unit()));
  }
}

//------------------------------------------------------------------------------
void FuzzedScene::ChangeCamera()
{
  vtkCamera* camera = this->Scene->Camera;
  const double reach = this->Size * (this->Chance(0.3) ? 0.5 : 4);
  camera->SetPosition(this->Or(reach * (this->Unit() - 0.5)), reach * (this->Unit() - 0.5),
    reach * (this->Unit() - 0.5));
  camera->SetFocalPoint(this->Size * 0.2 * this->Unit(), 0, this->Or(0));
  camera->SetViewUp(0, this->Or(1), 0);
  camera->SetViewAngle(this->Chance(0.05) ? 179.9 * this->Unit() : 30);
  camera->SetParallelProjection(this->Chance(0.3));
  camera->SetParallelScale(this->Size * (0.2 + this->Unit()));
  camera->SetClippingRange(this->Size * 0.001, this->Size * 100);
  const int pixels = 1 + this->Whole(16);
  this->Scene->Window->SetSize(pixels, 1 + this->Whole(16));
}

//------------------------------------------------------------------------------
/// A step that is tiny asks for a hundred thousand samples, and gets them: not here.
void FuzzedScene::LengthenSteps()
{
  double bounds[6];
  this->Scene->Volume->GetBounds(bounds);
  const double least =
    glm::length(glm::dvec3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4])) /
    50;
  vtkSingleScatteringVolumeMapper* mapper = this->Scene->Mapper;
  if (mapper->GetSampleDistance() >= 0 && mapper->GetSampleDistance() < least)
  {
    mapper->SetSampleDistance(least);
  }
  if (mapper->GetLightSampleDistance() >= 0 && mapper->GetLightSampleDistance() < least)
  {
    mapper->SetLightSampleDistance(least);
  }
}

//------------------------------------------------------------------------------
std::string FuzzedScene::Frame(int number)
{
  const bool first = number == 0;
  using Change = void (FuzzedScene::*)();
  for (Change change :
    { &FuzzedScene::ChangeImage, &FuzzedScene::ChangeMatrix, &FuzzedScene::ChangeMapper,
      &FuzzedScene::ChangeCuts, &FuzzedScene::ChangeMedium, &FuzzedScene::ChangeProperty,
      &FuzzedScene::ChangeLights, &FuzzedScene::ChangeCamera, &FuzzedScene::ChangeRest })
  {
    if (first || this->Chance(0.3))
    {
      (this->*change)();
    }
  }
  if (this->Chance(0.05))
  {
    this->Scene->Mapper->ReleaseGraphicsResources(this->Scene->Window);
  }
  this->LengthenSteps();
  this->Scene->Errors.clear();
  this->Interrupted = false;
  this->Scene->Window->Render();
  this->Scene->Window->SetAbortRender(0);
  this->Refused = !this->Scene->Errors.empty();
  vtkNew<vtkImageData> image;
  if (!this->Refused && this->Scene->Mapper->GetStatistics()->GetFrames() > 0)
  {
    this->Scene->Mapper->GetColorImage(image);
  }
  const std::string problem = this->Judge(Picture(image));
  if (problem.empty())
  {
    this->Ask();
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string FuzzedScene::Judge(const Picture& picture)
{
  this->Scene->Window->MakeCurrent();
  if (!this->Watch.Look().empty())
  {
    return "OpenGL: " + this->Watch.Look()[0];
  }
  if (this->Interrupted) // errors and numbers may be of either of two settings
  {
    return {};
  }
  const std::size_t eyes = this->Scene->Window->GetStereoRender() ? 2 : 1;
  if (this->Scene->Errors.size() > eyes)
  {
    return "more than one error: " + this->Scene->Errors[0] + " / " + this->Scene->Errors[1];
  }
  const bool radiance = this->Scene->Mapper->GetOutput() == Mapper::Radiance;
  for (std::size_t i = 0; !this->Refused && i < picture.Values.size(); ++i)
  {
    const float value = picture.Values[i];
    if (!std::isfinite(value) || value < 0 || (radiance && i % 4 == 3 && value > 1))
    {
      return "a pixel is " + std::to_string(value) + " (integrator " +
        std::to_string(this->Scene->Mapper->GetIntegrator()) + ", output " +
        std::to_string(this->Scene->Mapper->GetOutput()) + ")";
    }
  }
  return {};
}
}
