// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkMediumFrame.h"
#include "vtkMediumImages.h"
#include "vtkMediumPlan.h"
#include "vtkMediumProgram.h"
#include "vtkMediumStatistics.h"
#include "vtkMediumTextures.h"
#include "vtkParticipatingMedium.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMediumOpenGL.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstring>
#include <sstream>

vtkStandardNewMacro(vtkSingleScatteringVolumeMapper);

//------------------------------------------------------------------------------
struct vtkSingleScatteringVolumeMapper::Internals
{
  using Mapper = vtkSingleScatteringVolumeMapper;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkMediumScene Scene;
  vtkMediumTextures Textures;
  vtkMediumProgram Programs;
  vtkMediumFrame Frame;
  int FrameOutput = Radiance; ///< what the frame holds

  // The story of a frame. Each part returns an empty string, or why the frame cannot be drawn right.
  std::string Draw(Mapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
  std::string UseWindow(Mapper* mapper, vtkRenderer* renderer);
  std::string Gather(Mapper* mapper, vtkRenderer* renderer, vtkVolume* volume);
  std::string DrawFrame(Mapper* mapper, vtkRenderer* renderer, const vtkMediumPlan& plan);

  static std::string CheckContract(Mapper* mapper);
  static vtkMediumPlan::Settings FindSettings(Mapper* mapper);
  static vtkMediumPlan::Capabilities FindCapabilities();
};

//------------------------------------------------------------------------------
vtkSingleScatteringVolumeMapper::vtkSingleScatteringVolumeMapper()
  : Statistics(vtkSmartPointer<vtkMediumStatistics>::New())
  , Resources(new Internals)
{
}

//------------------------------------------------------------------------------
vtkSingleScatteringVolumeMapper::~vtkSingleScatteringVolumeMapper()
{
  this->ReleaseGraphicsResources(this->Resources->Window);
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  const double start = vtkTimerLog::GetUniversalTime();
  this->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent, nullptr);
  const std::string refusal = this->Resources->Draw(this, renderer, volume);
  if (refusal.empty())
  {
    this->LastRefusal.clear();
    ++this->Statistics->Frames;
  }
  else if (refusal != this->LastRefusal)
  {
    vtkErrorMacro(<< refusal);
    this->LastRefusal = refusal;
  }
  this->TimeToDraw = vtkTimerLog::GetUniversalTime() - start;
  this->Statistics->FrameMilliseconds = 1e3 * this->TimeToDraw;
  this->InvokeEvent(vtkCommand::VolumeMapperRenderEndEvent, nullptr);
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringVolumeMapper::Internals::Draw(
  Mapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  if (renderer->GetSelector())
  {
    return {}; // the volume is not part of a hardware selection
  }
  const double start = vtkTimerLog::GetUniversalTime();
  std::string refusal = this->UseWindow(mapper, renderer);
  if (refusal.empty())
  {
    refusal = this->Gather(mapper, renderer, volume);
  }
  if (!refusal.empty())
  {
    return refusal;
  }
  const vtkMediumPlan plan(this->Scene, FindSettings(mapper), FindCapabilities());
  if (!plan.Refusal.empty())
  {
    return plan.Refusal;
  }
  const double planned = vtkTimerLog::GetUniversalTime();

  refusal = this->Textures.Update(this->Window, this->Scene, plan);
  if (!refusal.empty())
  {
    return refusal;
  }
  if (this->Textures.GetNonFinite() > 0)
  {
    vtkWarningWithObjectMacro(mapper,
      << this->Textures.GetNonFinite()
      << " values of the input are NaN or infinite; NaN and -Inf are drawn as the smallest, +Inf as "
         "the largest finite value.");
  }
  const double uploaded = vtkTimerLog::GetUniversalTime();

  refusal = this->DrawFrame(mapper, renderer, plan);
  if (!refusal.empty())
  {
    return refusal;
  }
  vtkMediumStatistics* statistics = mapper->Statistics;
  statistics->GatherMilliseconds = 1e3 * (planned - start);
  statistics->UploadMilliseconds = 1e3 * (uploaded - planned);
  statistics->IntegrateMilliseconds = 1e3 * (vtkTimerLog::GetUniversalTime() - uploaded) -
    statistics->CompileMilliseconds;
  statistics->Passes = this->Frame.GetDraws();
  statistics->TextureUploads = this->Textures.GetUploads();
  statistics->ProgramCompiles = this->Programs.GetCompiles();
  statistics->GPUBytes = this->Textures.GetBytes() + this->Frame.GetBytes();
  return {};
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringVolumeMapper::Internals::UseWindow(
  Mapper* mapper, vtkRenderer* renderer)
{
  vtkOpenGLRenderWindow* window =
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  int major = 0, minor = 0;
  if (window)
  {
    window->GetOpenGLVersion(major, minor);
  }
  if (major < 3 || (major == 3 && minor < 2))
  {
    std::ostringstream text;
    text << "The render window ("
         << (renderer->GetRenderWindow() ? renderer->GetRenderWindow()->GetClassName() : "none")
         << ") has OpenGL " << major << '.' << minor << ", but 3.2 is needed; use a vtkOpenGLRenderWindow on a driver that offers it.";
    return text.str();
  }
  if (this->Window != window)
  {
    mapper->ReleaseGraphicsResources(this->Window);
    this->Window = window;
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringVolumeMapper::Internals::CheckContract(Mapper* mapper)
{
  std::ostringstream text;
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND)
  {
    text << "The blend mode is " << mapper->GetBlendMode()
         << ", but a participating medium has only composite blending (SetBlendModeToComposite).";
  }
  else if (mapper->GetCropping())
  {
    text << "Cropping is on, but this mapper does not crop; switch it off (CroppingOff) and extract "
            "the region from the image instead (vtkExtractVOI).";
  }
  else if (mapper->GetNumberOfClippingPlanes() > 0)
  {
    text << mapper->GetNumberOfClippingPlanes()
         << " clipping planes are set, but this mapper does not clip; remove them "
            "(RemoveAllClippingPlanes).";
  }
  return text.str();
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringVolumeMapper::Internals::Gather(
  Mapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  std::string refusal = CheckContract(mapper);
  if (!refusal.empty())
  {
    return refusal;
  }
  vtkDataObject* object = mapper->GetDataObjectInput();
  vtkImageData* input = vtkImageData::SafeDownCast(object);
  if (!input)
  {
    return std::string("The input is ") + (object ? object->GetClassName() : "missing") +
      ", but this mapper takes a vtkImageData; connect one (SetInputConnection, SetInputData), or "
      "resample the data to one (vtkResampleToImage).";
  }
  int cellFlag = 0;
  vtkDataArray* scalars = vtkVolumeMapper::GetScalars(
    input, mapper->ScalarMode, mapper->ArrayAccessMode, mapper->ArrayId, mapper->ArrayName, cellFlag);

  vtkMediumScene& scene = this->Scene;
  refusal = scene.GatherVolume(
    input, scalars, cellFlag != 0, volume, mapper->Medium, mapper->Anisotropy);
  if (!refusal.empty())
  {
    return refusal;
  }
  if (!mapper->Medium)
  {
    scene.Content.Phase = mapper->PhaseFunction == Schlick ? vtkMediumScene::Schlick
                                                         : vtkMediumScene::HenyeyGreenstein;
  }
  refusal = scene.GatherLights(renderer);
  if (!refusal.empty())
  {
    return refusal;
  }
  vtkMatrix4x4 *worldToClip, *worldToView, *viewToClip;
  vtkMatrix3x3* normals;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  vtkNew<vtkMatrix4x4> columns; // the camera keeps its matrices transposed for OpenGL
  vtkMatrix4x4::Transpose(worldToClip, columns);
  return scene.GatherView(columns);
}

//------------------------------------------------------------------------------
vtkMediumPlan::Settings vtkSingleScatteringVolumeMapper::Internals::FindSettings(
  Mapper* mapper)
{
  vtkMediumPlan::Settings settings;
  settings.Integrator = mapper->Integrator;
  settings.Output = mapper->Output;
  settings.SampleDistance = mapper->SampleDistance;
  settings.LightSampleDistance = mapper->LightSampleDistance;
  settings.BinarySearchIterations = mapper->BinarySearchIterations;
  settings.Jitter = mapper->Jitter;
  settings.TransmittanceThreshold = mapper->TransmittanceThreshold;
  settings.PaperThreshold = mapper->PaperThreshold;
  settings.AssumeConvex = mapper->AssumeConvex;
  settings.CountTaps = mapper->Statistics->CountTaps;
  settings.DepthDefinition = mapper->DepthDefinition;
  settings.DepthTransmittance = mapper->DepthTransmittance;
  return settings;
}

//------------------------------------------------------------------------------
vtkMediumPlan::Capabilities vtkSingleScatteringVolumeMapper::Internals::FindCapabilities()
{
  vtkMediumPlan::Capabilities device;
  const char* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const bool software = !name || std::strstr(name, "llvmpipe") || std::strstr(name, "softpipe");
  if (!software)
  {
    device.LoopIterations = 1 << 22; // short enough draws that no driver's watchdog ends one
    device.CoarseFilter = true;
  }
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &device.TextureSize3D);
  return device;
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringVolumeMapper::Internals::DrawFrame(
  Mapper* mapper, vtkRenderer* renderer, const vtkMediumPlan& plan)
{
  vtkMediumFrame::Viewport viewport;
  renderer->GetTiledSizeAndOrigin(
    &viewport.Size.x, &viewport.Size.y, &viewport.Origin.x, &viewport.Origin.y);
  if (viewport.Size.x < 1 || viewport.Size.y < 1)
  {
    return {}; // a viewport without pixels shows nothing
  }
  const std::string refusal = this->Frame.Begin(this->Window, viewport, plan.Passes.size() > 1 || plan.IterationBudget > 0);
  if (!refusal.empty())
  {
    return refusal;
  }
  const char* broken = "A shader did not compile on this device; the compiler's words are above.";
  if (!this->Frame.Integrate(this->Programs, this->Textures, this->Scene, plan))
  {
    return broken;
  }
  mapper->Statistics->CompileMilliseconds = this->Programs.GetCompileMilliseconds();
  if (!mapper->RenderToImage)
  {
    if (!this->Frame.Show(this->Programs, vtkMediumImages::FindShown(this->Scene, mapper->Output)))
    {
      return broken;
    }
    mapper->Statistics->CompileMilliseconds += this->Programs.GetCompileMilliseconds();
  }
  glFinish(); // so that TimeToDraw is the time it took
  mapper->Statistics->Taps = mapper->Statistics->Rays = 0;
  if (mapper->Statistics->CountTaps)
  {
    const std::vector<float> hits = this->Frame.DownloadHits();
    vtkMediumImages::Count(hits, mapper->Statistics->Taps, mapper->Statistics->Rays);
  }
  this->FrameOutput = mapper->Output;
  return {};
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::GetColorImage(vtkImageData* image)
{
  Internals& own = *this->Resources;
  const std::vector<float> radiance = own.Frame.DownloadRadiance();
  if (radiance.empty())
  {
    vtkErrorMacro(<< "There is no image yet; render a frame first.");
    return;
  }
  const std::vector<float> pixels =
    vtkMediumImages::Values(radiance, own.Frame.DownloadHits(), own.Scene, own.FrameOutput);
  vtkMediumImages::Copy(pixels, 4, own.Frame.GetViewport().Size, image);
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::GetDepthImage(vtkImageData* image)
{
  Internals& own = *this->Resources;
  const std::vector<float> hits = own.Frame.DownloadHits();
  if (hits.empty())
  {
    vtkErrorMacro(<< "There is no image yet; render a frame first.");
    return;
  }
  const glm::ivec2 size = own.Frame.GetViewport().Size;
  vtkMediumImages::Copy(
    vtkMediumImages::WindowDepths(hits, own.Scene.Eye, size), 1, size, image);
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
vtkMTimeType vtkSingleScatteringVolumeMapper::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Medium ? std::max(own, this->Medium->GetMTime()) : own;
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
  if (window)
  {
    this->Resources->Textures.ReleaseGraphicsResources(window);
    this->Resources->Programs.ReleaseGraphicsResources(window);
    this->Resources->Frame.ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkSingleScatteringVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Medium: " << this->Medium.Get() << "\n";
  os << indent << "Anisotropy: " << this->Anisotropy << "\n";
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "Integrator: " << this->Integrator << "\n";
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
