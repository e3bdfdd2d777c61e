// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSingleScatteringReference.h"

#include "vtkMediumReferenceEyeRay.h"
#include "vtkMediumReferenceIntegrator.h"
#include "vtkParticipatingMedium.h"

#include "vtkAbstractMapper.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Pixels along each axis that are estimated for the peak.
constexpr int PeakSamples = 12;

// Between two progress events; a divisor of the work that keeps all threads busy.
constexpr int ProgressSteps = 40;

//------------------------------------------------------------------------------
double Mean(const glm::dvec3& rgb)
{
  return (rgb.x + rgb.y + rgb.z) / 3;
}

//------------------------------------------------------------------------------
double Alpha(const glm::dvec3& opticalDepth)
{
  return -Mean(
    { std::expm1(-opticalDepth.x), std::expm1(-opticalDepth.y), std::expm1(-opticalDepth.z) });
}
}

//------------------------------------------------------------------------------
// What was gathered for the last question, and the state that it was gathered from.
struct vtkSingleScatteringReference::Gathered
{
  vtkMediumScene Facts;
  vtkMediumReferenceContent Content;
  vtkMTimeType Time = 0;
  bool Lit = false;
};

vtkStandardNewMacro(vtkSingleScatteringReference);

//------------------------------------------------------------------------------
vtkSingleScatteringReference::vtkSingleScatteringReference()
  : Scene(std::make_unique<Gathered>())
{
}

//------------------------------------------------------------------------------
vtkSingleScatteringReference::~vtkSingleScatteringReference() = default;

//------------------------------------------------------------------------------
#define vtkSingleScatteringReferenceObjectMacro(name, type)                                        \
  void vtkSingleScatteringReference::Set##name(type* object)                                       \
  {                                                                                                \
    if (this->name != object)                                                                      \
    {                                                                                              \
      this->name = object;                                                                         \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  type* vtkSingleScatteringReference::Get##name()                                                  \
  {                                                                                                \
    return this->name;                                                                             \
  }

vtkSingleScatteringReferenceObjectMacro(InputData, vtkImageData)
  vtkSingleScatteringReferenceObjectMacro(Medium, vtkParticipatingMedium)
    vtkSingleScatteringReferenceObjectMacro(Volume, vtkVolume)
      vtkSingleScatteringReferenceObjectMacro(Renderer, vtkRenderer)

  //------------------------------------------------------------------------------
  vtkMTimeType vtkSingleScatteringReference::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  const auto include = [&time](vtkObject* object) {
    time = object ? std::max(time, object->GetMTime()) : time;
  };
  include(this->FindInput());
  include(this->Medium);
  if (this->Volume)
  {
    this->Volume->ComputeMatrix();
    include(this->Volume);
    include(this->Volume->GetMatrix());
    include(this->Volume->GetProperty());
    include(this->Volume->GetMapper());
  }
  if (this->Renderer)
  {
    include(this->Renderer);
    include(this->Renderer->IsActiveCameraCreated() ? this->Renderer->GetActiveCamera() : nullptr);
    vtkLightCollection* lights = this->Renderer->GetLights();
    include(lights);
    vtkCollectionSimpleIterator iterator;
    lights->InitTraversal(iterator);
    while (vtkLight* light = lights->GetNextLight(iterator))
    {
      include(light);
      include(light->GetTransformMatrix());
    }
  }
  return time;
}

//------------------------------------------------------------------------------
vtkImageData* vtkSingleScatteringReference::FindInput()
{
  if (this->InputData || !this->Volume || !this->Volume->GetMapper())
  {
    return this->InputData;
  }
  return vtkImageData::SafeDownCast(this->Volume->GetMapper()->GetDataObjectInput());
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringReference::GatherMedium()
{
  vtkImageData* input = this->FindInput();
  if (!input)
  {
    return "There is no vtkImageData; call SetInputData, or SetVolume with a volume whose mapper "
           "has "
           "one as its input.";
  }
  vtkAbstractVolumeMapper* mapper = this->Volume ? this->Volume->GetMapper() : nullptr;
  int cellFlag = 0;
  vtkDataArray* scalars = mapper
    ? vtkAbstractMapper::GetScalars(input, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
        mapper->GetArrayId(), mapper->GetArrayName(), cellFlag)
    : vtkAbstractMapper::GetScalars(
        input, VTK_SCALAR_MODE_DEFAULT, VTK_GET_ARRAY_BY_ID, 0, nullptr, cellFlag);
  if (!scalars && !this->Medium)
  {
    return "The input image has no scalars; give it point or cell scalars, or set a "
           "vtkParticipatingMedium.";
  }
  vtkSmartPointer<vtkVolume> volume = this->Volume;
  if (!volume)
  {
    volume = vtkSmartPointer<vtkVolume>::New();
  }
  volume->ComputeMatrix();
  const bool onCells = cellFlag != 0;
  const std::string problem = this->Scene->Facts.GatherVolume(
    input, scalars, onCells, volume, this->Medium, this->Anisotropy);
  if (problem.empty())
  {
    this->Scene->Content.Update(this->Scene->Facts);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringReference::GatherLights()
{
  if (!this->Renderer)
  {
    return "There is no renderer to take lights and camera from; call SetRenderer.";
  }
  return this->Scene->Facts.GatherLights(this->Renderer);
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringReference::GatherView(int size[2])
{
  const bool given = this->ImageSize[0] > 0 && this->ImageSize[1] > 0;
  const int* source =
    given || !this->Renderer->GetVTKWindow() ? this->ImageSize : this->Renderer->GetSize();
  std::copy(source, source + 2, size);
  if (size[0] < 1 || size[1] < 1)
  {
    return "The image would have " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " pixels; call SetImageSize with a width and a height > 0, or give the renderer a window.";
  }
  const double aspect =
    given ? static_cast<double>(size[0]) / size[1] : this->Renderer->GetTiledAspectRatio();
  return this->Scene->Facts.GatherView(
    this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1, 1));
}

//------------------------------------------------------------------------------
bool vtkSingleScatteringReference::Gather(bool lights)
{
  if (this->Scene->Time != 0 && this->Scene->Time == this->GetMTime() &&
    (this->Scene->Lit || !lights))
  {
    return true;
  }
  this->Scene->Time = 0;
  std::string problem = this->GatherMedium();
  if (problem.empty() && lights)
  {
    problem = this->GatherLights();
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  this->Scene->Lit = lights;
  this->Scene->Time = this->GetMTime();
  return true;
}

//------------------------------------------------------------------------------
double vtkSingleScatteringReference::EstimatePeak(const int size[2])
{
  const vtkMediumReferenceIntegrator integrator(
    this->Scene->Facts, this->Scene->Content, this->Tolerance);
  const int columns = std::min(PeakSamples, size[0]), rows = std::min(PeakSamples, size[1]);
  std::vector<double> radiances(static_cast<std::size_t>(columns) * rows);
  vtkSMPTools::For(0, columns * rows, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType sample = first; sample < last; ++sample)
    {
      const vtkIdType column = sample % columns, row = sample / columns;
      const int i = static_cast<int>((column + 0.5) * size[0] / columns);
      const int j = static_cast<int>((row + 0.5) * size[1] / rows);
      const vtkMediumReferenceEyeRay ray =
        vtkMediumReferenceEyeRayOf(this->Scene->Facts.Eye, size, i, j);
      const double end = std::numeric_limits<double>::infinity();
      radiances[sample] =
        vtkMediumMagnitude(integrator.Estimate(ray.Origin, ray.Direction, ray.Begin, end).Radiance);
    }
  });
  return *std::max_element(radiances.begin(), radiances.end());
}

//------------------------------------------------------------------------------
bool vtkSingleScatteringReference::GetColorImage(vtkImageData* image)
{
  if (!image)
  {
    vtkErrorMacro(<< "There is no image to fill; give GetColorImage a vtkImageData.");
    return false;
  }
  if (!this->Gather(true))
  {
    return false;
  }
  int size[2];
  const std::string problem = this->GatherView(size);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }

  this->AbortExecute = false;
  this->InvokeEvent(vtkCommand::StartEvent);
  const int stride = this->PixelStride;
  const int columns = (size[0] - 1) / stride + 1, rows = (size[1] - 1) / stride + 1;
  const vtkIdType pixels = static_cast<vtkIdType>(columns) * rows;
  const double peak = this->EstimatePeak(size);
  const vtkMediumReferenceIntegrator integrator(
    this->Scene->Facts, this->Scene->Content, this->Tolerance);
  vtkNew<vtkDoubleArray> colors;
  colors->SetName("Radiance");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(pixels);
  double* rgba = colors->GetPointer(0);
  for (int step = 0; step < ProgressSteps && !this->AbortExecute; ++step)
  {
    vtkSMPTools::For(pixels * step / ProgressSteps, pixels * (step + 1) / ProgressSteps, 1,
      [&](vtkIdType first, vtkIdType last) {
        for (vtkIdType pixel = first; pixel < last; ++pixel)
        {
          const vtkMediumReferenceEyeRay ray = vtkMediumReferenceEyeRayOf(this->Scene->Facts.Eye,
            size, static_cast<int>(pixel % columns) * stride,
            static_cast<int>(pixel / columns) * stride);
          const auto result = integrator.Evaluate(
            ray.Origin, ray.Direction, ray.Begin, std::numeric_limits<double>::infinity(), peak);
          double* out = rgba + 4 * pixel;
          std::copy(&result.Radiance[0], &result.Radiance[0] + 3, out);
          out[3] = Alpha(result.OpticalDepth);
        }
      });
    double progress = (step + 1.0) / ProgressSteps;
    this->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  }
  this->InvokeEvent(vtkCommand::EndEvent);
  if (this->AbortExecute)
  {
    return false;
  }
  image->Initialize();
  image->SetDimensions(columns, rows, 1);
  image->SetSpacing(stride, stride, 1);
  image->GetPointData()->SetScalars(colors);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSingleScatteringReference::Radiance(
  const double origin[3], const double direction[3], double rgba[4])
{
  std::fill(rgba, rgba + 4, 0.0);
  const double length = glm::length(glm::make_vec3(direction));
  if (!(length > 0) || !std::isfinite(length))
  {
    vtkErrorMacro(<< "The direction (" << direction[0] << ", " << direction[1] << ", "
                  << direction[2] << ") has the length " << length
                  << "; give one with a finite length > 0.");
    return false;
  }
  if (!this->Gather(true))
  {
    return false;
  }
  const vtkMediumReferenceIntegrator integrator(
    this->Scene->Facts, this->Scene->Content, this->Tolerance);
  const auto result =
    integrator.Evaluate(this->Scene->Facts.Geometry.WorldToLocal(glm::make_vec3(origin)),
      glm::make_vec3(direction) / length, 0, std::numeric_limits<double>::infinity(), 0);
  std::copy(&result.Radiance[0], &result.Radiance[0] + 3, rgba);
  rgba[3] = Alpha(result.OpticalDepth);
  return true;
}

//------------------------------------------------------------------------------
void vtkSingleScatteringReference::OpticalDepth(const double a[3], const double b[3], double rgb[3])
{
  std::fill(rgb, rgb + 3, std::numeric_limits<double>::quiet_NaN());
  if (!this->Gather(false))
  {
    return;
  }
  const vtkMediumScene::Box& box = this->Scene->Facts.Geometry;
  const glm::dvec3 way = (glm::make_vec3(b) - glm::make_vec3(a)) / box.Length;
  const double length = glm::length(way);
  glm::dvec3 depth(0);
  if (length > 0)
  {
    const vtkMediumOpticalDepth evaluator(this->Scene->Content, box, this->Tolerance);
    depth = evaluator.Evaluate(box.WorldToLocal(glm::make_vec3(a)), way / length, 0, length);
  }
  std::copy(&depth[0], &depth[0] + 3, rgb);
}

//------------------------------------------------------------------------------
double vtkSingleScatteringReference::OpticalDepth(const double a[3], const double b[3])
{
  glm::dvec3 rgb;
  this->OpticalDepth(a, b, &rgb[0]);
  return Mean(rgb);
}

//------------------------------------------------------------------------------
void vtkSingleScatteringReference::Transmittance(
  const double a[3], const double b[3], double rgb[3])
{
  this->OpticalDepth(a, b, rgb);
  std::transform(rgb, rgb + 3, rgb, [](double depth) { return std::exp(-depth); });
}

//------------------------------------------------------------------------------
double vtkSingleScatteringReference::Transmittance(const double a[3], const double b[3])
{
  glm::dvec3 rgb;
  this->Transmittance(a, b, &rgb[0]);
  return Mean(rgb);
}

//------------------------------------------------------------------------------
void vtkSingleScatteringReference::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InputData: " << this->InputData << "\n";
  os << indent << "Medium: " << this->Medium << "\n";
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "ImageSize: " << this->ImageSize[0] << " x " << this->ImageSize[1] << "\n";
  os << indent << "PixelStride: " << this->PixelStride << "\n";
  os << indent << "AbortExecute: " << this->AbortExecute << "\n";
}
