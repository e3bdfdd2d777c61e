// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSingleScatteringReference.h"

#include "vtkMediumReferenceEyeRay.h"
#include "vtkMediumReferenceIntegrator.h"
#include "vtkParticipatingMedium.h"
#include "vtkSingleScatteringReferenceGathered.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkVolume.h"

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

// clang-format off
vtkSingleScatteringReferenceObjectMacro(InputData, vtkImageData)
vtkSingleScatteringReferenceObjectMacro(MaskInput, vtkImageData)
vtkSingleScatteringReferenceObjectMacro(Medium, vtkParticipatingMedium)
vtkSingleScatteringReferenceObjectMacro(Volume, vtkVolume)
vtkSingleScatteringReferenceObjectMacro(Renderer, vtkRenderer)
  // clang-format on

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
  const double length = std::hypot(direction[0], direction[1], direction[2]);
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
  glm::dvec3 local;
  const std::string problem = this->FindPlace(origin, &local[0]);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  const vtkMediumReferenceIntegrator integrator(
    this->Scene->Facts, this->Scene->Content, this->Tolerance);
  const auto result = integrator.Evaluate(
    local, glm::make_vec3(direction) / length, 0, std::numeric_limits<double>::infinity(), 0);
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
  glm::dvec3 from, to;
  std::string problem = this->FindPlace(a, &from[0]);
  problem = problem.empty() ? this->FindPlace(b, &to[0]) : problem;
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return;
  }
  const vtkMediumOpticalDepth evaluator(this->Scene->Facts, this->Scene->Content, this->Tolerance);
  const glm::dvec3 depth = evaluator.EvaluateBetween(from, to);
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
  os << indent << "MaskInput: " << this->MaskInput << "\n";
  os << indent << "Medium: " << this->Medium << "\n";
  os << indent << "Volume: " << this->Volume << "\n";
  os << indent << "Renderer: " << this->Renderer << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "ImageSize: " << this->ImageSize[0] << " x " << this->ImageSize[1] << "\n";
  os << indent << "PixelStride: " << this->PixelStride << "\n";
  os << indent << "AbortExecute: " << this->AbortExecute << "\n";
}
