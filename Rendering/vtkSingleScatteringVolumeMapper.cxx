// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkMediumImages.h"
#include "vtkMediumRenderer.h"
#include "vtkMediumSettings.h"
#include "vtkMediumStatistics.h"
#include "vtkMediumUserCode.h"
#include "vtkParticipatingMedium.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace
{
const char* const NoImage =
  "There is no complete image; render a frame first, with depth peeling of volumes "
  "switched off (UseDepthPeelingForVolumesOff).";
const char* const NothingToFill = "The image to fill is null; give a vtkImageData.";
const char* const PeelingOfOtherThings =
  "Depth peeling of volumes mixes radiance with geometry in the window, and nothing else; set "
  "SetOutputToRadiance, SetBlendModeToComposite and RenderToImageOff, or switch it off for volumes "
  "(UseDepthPeelingForVolumesOff).";

//------------------------------------------------------------------------------
const char* NameOfBlendMode(vtkVolumeMapper& mapper)
{
  switch (mapper.GetBlendMode())
  {
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return "maximum intensity";
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return "minimum intensity";
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      return "average intensity";
    case vtkVolumeMapper::ISOSURFACE_BLEND:
      return "isosurface";
    case vtkVolumeMapper::SLICE_BLEND:
      return "slice";
    default:
      return "unknown";
  }
}
}

vtkStandardNewMacro(vtkSingleScatteringVolumeMapper);

//------------------------------------------------------------------------------
vtkSingleScatteringVolumeMapper::vtkSingleScatteringVolumeMapper()
  : Statistics(vtkSmartPointer<vtkMediumStatistics>::New())
  , Drawing(new vtkMediumRenderer)
{
}

//------------------------------------------------------------------------------
vtkSingleScatteringVolumeMapper::~vtkSingleScatteringVolumeMapper()
{
  this->ReleaseGraphicsResources(this->Drawing->GetWindow());
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  if (renderer->GetSelector())
  {
    this->Report(this->RenderToImage ? std::string() : this->Draw(renderer, volume));
    return;
  }
  const double start = vtkTimerLog::GetUniversalTime();
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  this->Report(this->Draw(renderer, volume));
  this->TimeToDraw = vtkTimerLog::GetUniversalTime() - start;
  this->Statistics->FrameMilliseconds = 1e3 * this->TimeToDraw;
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::Report(const std::string& refusal)
{
  if (!refusal.empty() && refusal != this->LastRefusal)
  {
    vtkErrorMacro(<< refusal);
  }
  this->LastRefusal = refusal;
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringVolumeMapper::Draw(vtkRenderer* renderer, vtkVolume* volume)
{
  const std::string refusal = this->CheckContract();
  if (!refusal.empty())
  {
    return refusal;
  }
  vtkMediumRenderer::Request request;
  request.Renderer = renderer;
  request.Volume = volume;
  request.Input = vtkImageData::SafeDownCast(this->GetDataObjectInput());
  request.Mapper = this;
  request.Mask = this->MaskInput;
  int onCells = 0;
  request.Scalars = vtkVolumeMapper::GetScalars(request.Input, this->ScalarMode,
    this->ArrayAccessMode, this->ArrayId, this->ArrayName, onCells);
  request.ScalarsOnCells = onCells != 0;
  request.Medium = this->Medium;
  request.Anisotropy = this->Anisotropy;
  request.Phase = this->PhaseFunction == Schlick ? vtkParticipatingMedium::Schlick
                                                 : vtkParticipatingMedium::HenyeyGreenstein;
  request.MaximumError = this->MaximumError;
  request.Show = !this->RenderToImage;
  request.Progress = [this, renderer](double fraction) {
    this->InvokeEvent(vtkCommand::VolumeMapperRenderProgressEvent, &fraction);
    return renderer->GetRenderWindow()->CheckAbortStatus() == 0;
  };

  request.Settings = vtkMediumSettingsOf(this);
  auto code = std::make_shared<vtkMediumUserCode>(volume);
  if (!code->Refusal.empty())
  {
    return code->Refusal;
  }
  if (!code->IsEmpty())
  {
    request.Settings.UserCode = code;
  }
  request.OpaqueShadows = this->OpaqueShadows;
  request.PixelEdge = this->ImageSampleDistance;
  request.Seconds =
    this->AutoAdjustSampleDistances ? volume->GetAllocatedRenderTime() : VTK_DOUBLE_MAX;
  request.AlwaysCache = this->LightCaches == CachesAlways;

  request.Selector = renderer->GetSelector();
  if (request.Selector)
  {
    return this->Drawing->Select(request);
  }
  request.Peeling = vtkMediumPeel::FindCaller(this, volume);
  if (request.Peeling && (!request.Show || request.Settings.Output != Radiance))
  {
    return PeelingOfOtherThings;
  }
  const std::string problem = this->Drawing->Draw(request, this->Statistics);
  if (problem.empty() && this->Drawing->GetNonFinite() > 0)
  {
    vtkWarningMacro(<< this->Drawing->GetNonFinite()
                    << " values of the input are NaN or infinite; NaN and -Inf are drawn as the "
                       "smallest, +Inf as the largest finite value.");
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringVolumeMapper::CheckContract()
{
  std::ostringstream text;
  vtkDataObject* input = this->GetDataObjectInput();
  if (!vtkImageData::SafeDownCast(input))
  {
    text
      << "The input is " << (input ? input->GetClassName() : "missing")
      << ", but this mapper takes a vtkImageData; connect one (SetInputConnection, SetInputData), "
         "or resample the data to one (vtkResampleToImage).";
  }
  else if (this->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND &&
    this->GetBlendMode() != vtkVolumeMapper::ADDITIVE_BLEND)
  {
    text << "The blend mode is " << this->GetBlendMode() << " (" << NameOfBlendMode(*this)
         << "), but a participating medium has composite blending (SetBlendModeToComposite), and "
            "additive blending (SetBlendModeToAdditive) for the light that is lost along a ray.";
  }
  else if (std::isnan(this->ImageSampleDistance)) // all that clamping lets through
  {
    text << "The image sample distance is " << this->ImageSampleDistance
         << "; set 1 to 10 pixels between eye rays (SetImageSampleDistance).";
  }
  return text.str();
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::GetColorImage(vtkImageData* image)
{
  if (!image)
  {
    vtkErrorMacro(<< NothingToFill);
    return;
  }
  vtkMediumFrame& frame = this->Drawing->GetFrame();
  const std::vector<float> radiance = frame.DownloadRadiance();
  if (radiance.empty() || this->Drawing->IsInPieces())
  {
    vtkErrorMacro(<< NoImage);
    return;
  }
  const std::vector<float> hits = frame.DownloadHits();
  const int output = this->Drawing->GetOutput();
  const std::vector<float> pixels = output == ErrorEstimate
    ? vtkMediumImages::Errors(radiance, this->Drawing->GetCoarserFrame().DownloadRadiance(), hits)
    : vtkMediumImages::Values(radiance, hits, this->Drawing->GetScene(), output);
  vtkMediumImages::Copy(pixels, 4, frame.GetViewport().GetRays(), image);
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::GetDepthImage(vtkImageData* image)
{
  if (!image)
  {
    vtkErrorMacro(<< NothingToFill);
    return;
  }
  vtkMediumFrame& frame = this->Drawing->GetFrame();
  const std::vector<float> hits = frame.DownloadHits();
  if (hits.empty() || this->Drawing->IsInPieces())
  {
    vtkErrorMacro(<< NoImage);
    return;
  }
  const glm::ivec2 size = frame.GetViewport().GetRays();
  vtkMediumImages::Copy(
    vtkMediumImages::WindowDepths(hits, this->Drawing->GetScene().Eye, size), 1, size, image);
}

//------------------------------------------------------------------------------
double vtkSingleScatteringVolumeMapper::GetEstimatedError()
{
  return this->Integrator == ErrorControlled ? this->Drawing->GetEstimatedError() : -1;
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::SetMedium(vtkParticipatingMedium* medium)
{
  if (this->Medium != medium)
  {
    this->Medium = medium;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::SetMaskInput(vtkImageData* mask)
{
  if (this->MaskInput != mask)
  {
    this->MaskInput = mask;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkSingleScatteringVolumeMapper::GetMaskInput()
{
  return this->MaskInput;
}

//------------------------------------------------------------------------------
vtkParticipatingMedium* vtkSingleScatteringVolumeMapper::GetMedium()
{
  return this->Medium;
}

//------------------------------------------------------------------------------
vtkMediumStatistics* vtkSingleScatteringVolumeMapper::GetStatistics()
{
  return this->Statistics;
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* volume = vtkVolumeMapper::SafeDownCast(mapper))
  {
    this->SetInputConnection(
      volume->GetNumberOfInputConnections(0) > 0 ? volume->GetInputConnection(0, 0) : nullptr);
    this->SetBlendMode(volume->GetBlendMode());
    this->SetCropping(volume->GetCropping());
    this->SetCroppingRegionPlanes(volume->GetCroppingRegionPlanes());
    this->SetCroppingRegionFlags(volume->GetCroppingRegionFlags());
    this->SetScalarMode(volume->GetScalarMode());
    if (volume->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME && volume->GetArrayName())
    {
      this->SelectScalarArray(volume->GetArrayName());
    }
    else
    {
      this->SelectScalarArray(volume->GetArrayId());
    }
  }
  if (auto* other = vtkSingleScatteringVolumeMapper::SafeDownCast(mapper))
  {
    this->SetMaskInput(other->MaskInput);
    this->SetMedium(other->Medium);
    this->SetAnisotropy(other->Anisotropy);
    this->SetPhaseFunction(other->PhaseFunction);
    this->SetIntegrator(other->Integrator);
    this->SetMaximumError(other->MaximumError);
    this->SetLightCaches(other->LightCaches);
    this->SetOpaqueShadows(other->OpaqueShadows);
    this->SetOpaqueShadowResolution(other->OpaqueShadowResolution);
    this->SetSampleDistance(other->SampleDistance);
    this->SetLightSampleDistance(other->LightSampleDistance);
    this->SetAutoAdjustSampleDistances(other->AutoAdjustSampleDistances);
    this->SetImageSampleDistance(other->ImageSampleDistance);
    this->SetBinarySearchIterations(other->BinarySearchIterations);
    this->SetJitter(other->Jitter);
    this->SetTransmittanceThreshold(other->TransmittanceThreshold);
    this->SetPaperThreshold(other->PaperThreshold);
    this->SetAssumeConvex(other->AssumeConvex);
    this->SetOutput(other->Output);
    this->SetDepthDefinition(other->DepthDefinition);
    this->SetDepthTransmittance(other->DepthTransmittance);
    this->SetRenderToImage(other->RenderToImage);
  }
  this->Superclass::ShallowCopy(mapper);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkSingleScatteringVolumeMapper::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  time = this->Medium ? std::max(time, this->Medium->GetMTime()) : time;
  return this->MaskInput ? std::max(time, this->MaskInput->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkSingleScatteringVolumeMapper::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object, so that this class itself can say what is wrong with another one.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Drawing->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaskInput: " << this->MaskInput.Get() << "\n";
  os << indent << "Medium: " << this->Medium.Get() << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "Integrator: " << this->Integrator << "\n";
  os << indent << "LightCaches: " << this->LightCaches << "\n";
  os << indent << "OpaqueShadows: " << (this->OpaqueShadows ? "On" : "Off") << "\n";
  os << indent << "OpaqueShadowResolution: " << this->OpaqueShadowResolution << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent << "AutoAdjustSampleDistances: " << (this->AutoAdjustSampleDistances ? "On" : "Off")
     << "\n";
  os << indent << "ImageSampleDistance: " << this->ImageSampleDistance << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "LightSampleDistance: " << this->LightSampleDistance << "\n";
  os << indent << "BinarySearchIterations: " << this->BinarySearchIterations << "\n";
  os << indent << "Jitter: " << this->Jitter << "\n";
  os << indent << "TransmittanceThreshold: " << this->TransmittanceThreshold << "\n";
  os << indent << "PaperThreshold: " << this->PaperThreshold << "\n";
  os << indent << "AssumeConvex: " << (this->AssumeConvex ? "On" : "Off") << "\n";
  os << indent << "Output: " << this->Output << "\n";
  os << indent << "DepthDefinition: " << this->DepthDefinition << "\n";
  os << indent << "DepthTransmittance: " << this->DepthTransmittance << "\n";
  os << indent << "RenderToImage: " << (this->RenderToImage ? "On" : "Off") << "\n";
  os << indent << "Statistics:\n";
  this->Statistics->PrintSelf(os, indent.GetNextIndent());
}
