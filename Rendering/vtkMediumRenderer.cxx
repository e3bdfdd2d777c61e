// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumRenderer.h"

#include "vtkMediumImages.h"
#include "vtkMediumStatistics.h"
#include "vtkMediumSurroundings.h"
#include "vtkMediumUserCode.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkMatrix4x4.h"
#include "vtkMediumOpenGL.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
/// Milliseconds since it was made, or since the last lap.
class Stopwatch
{
public:
  double Lap()
  {
    const double before = this->Start;
    this->Start = vtkTimerLog::GetUniversalTime();
    return 1e3 * (this->Start - before);
  }

private:
  double Start = vtkTimerLog::GetUniversalTime();
};
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::Draw(const Request& request, vtkMediumStatistics* statistics)
{
  Stopwatch watch;
  std::string refusal = this->UseWindow(request.Renderer);
  if (refusal.empty())
  {
    refusal = this->Gather(request);
  }
  if (!refusal.empty())
  {
    return refusal;
  }
  const vtkMediumPlan::Capabilities device = FindCapabilities();
  const vtkMediumPlan draft(this->Scene, request.Settings, device);
  if (!draft.Refusal.empty())
  {
    return draft.Refusal;
  }
  statistics->GatherMilliseconds = watch.Lap();
  this->ClosedForm = draft.ClosedForm;
  vtkMediumPlan::Settings settings = request.Settings;
  const glm::dvec2 pixels(FindViewport(request.Renderer).Size);
  this->Economy = draft.UseBricks ? this->Budget.Plan(request.Seconds, pixels.x * pixels.y)
                                  : vtkMediumFrameBudget::Economy();
  refusal = this->Prepare(request, device, draft, settings, statistics);
  if (!refusal.empty())
  {
    return refusal;
  }
  watch.Lap();
  const double compiledBefore = this->Programs.GetCompileMilliseconds();
  const vtkMediumPlan plan(this->Scene, settings, device);
  refusal = request.Selector ? this->DrawSelection(request, plan)
                             : this->DrawFrame(request, settings, plan);
  const double compiled = this->Programs.GetCompileMilliseconds();
  statistics->CompileMilliseconds = compiled;
  statistics->IntegrateMilliseconds = watch.Lap() - (compiled - compiledBefore);
  const bool complete = refusal.empty() && this->Frame.IsComplete();
  if (complete)
  {
    this->ReleaseUnread(request, draft);
    this->CountWork(plan, statistics);
  }
  if (complete && this->Economy.Hurried)
  {
    this->Budget.Learn(
      this->Economy, pixels.x * pixels.y, 1e-3 * statistics->IntegrateMilliseconds);
  }
  return refusal;
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::Prepare(const Request& request,
  const vtkMediumPlan::Capabilities& device, const vtkMediumPlan& draft,
  vtkMediumPlan::Settings& settings, vtkMediumStatistics* statistics)
{
  Stopwatch watch;
  std::string refusal = this->Textures.Update(this->Window, this->Scene, draft);
  refusal = refusal.empty() ? this->ShadowMap.Update(this->Window, this->Scene, draft) : refusal;
  statistics->UploadMilliseconds = watch.Lap();
  this->Programs.ResetCompileMilliseconds();
  if (!refusal.empty() || !draft.UseBricks)
  {
    statistics->BuildMilliseconds = statistics->CalibrateMilliseconds = 0;
    return refusal;
  }
  const vtkMediumStepControl::CacheUses caches = draft.CachedLights == 0
    ? vtkMediumStepControl::Never
    : request.AlwaysCache ? vtkMediumStepControl::Always
                          : vtkMediumStepControl::WhereAccurate;
  auto build = [&]() {
    const vtkMediumPlan plan(this->Scene, settings, device);
    return this->Accelerator.Update(this->Window, this->Scene, plan);
  };
  auto useFound = [&]() {
    settings.ControlledStep = this->StepControl.GetStep();
    settings.ControlledLightStep = this->StepControl.GetLightStep();
    settings.LightMethod = this->StepControl.GetLight().Method;
    settings.LightTolerance = this->StepControl.GetLight().Tolerance;
    settings.PixelTolerance = this->StepControl.GetLight().PixelTolerance;
    return build();
  };
  if (this->Economy.Hurried)
  {
    settings.Hurried = true;
    refusal = build();
    statistics->BuildMilliseconds = watch.Lap();
    const glm::dvec2 pixels(FindViewport(request.Renderer).Size);
    this->Economy =
      this->Budget.Plan(request.Seconds, pixels.x * pixels.y, 1e-3 * statistics->BuildMilliseconds);
    const double voxel = this->Scene.Geometry.VoxelLength / this->Scene.Geometry.Length;
    const double found = this->StepControl.GetStep();
    settings.ControlledStep = this->Economy.StepFactor * (found > 0 ? found : voxel);
    statistics->CalibrateMilliseconds = 0;
    return refusal;
  }
  const bool calibrated = this->StepControl.IsCalibrated(this->Scene, request.MaximumError, caches);
  refusal = calibrated ? useFound() : build();
  statistics->BuildMilliseconds = watch.Lap();
  if (refusal.empty() && !calibrated)
  {
    refusal = this->FindStep(request, device, caches);
    refusal = refusal.empty() ? useFound() : refusal;
  }
  statistics->CalibrateMilliseconds = watch.Lap() - this->Programs.GetCompileMilliseconds();
  return refusal;
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::UseWindow(vtkRenderer* renderer)
{
  vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
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
         << ") has OpenGL " << major << '.' << minor
         << ", but 3.2 is needed; use a vtkOpenGLRenderWindow on a driver that offers it.";
    return text.str();
  }
  if (this->Window != window)
  {
    this->ReleaseGraphicsResources(this->Window);
    this->Window = window;
  }
  return {};
}

//------------------------------------------------------------------------------
vtkMediumFrame::Viewport vtkMediumRenderer::FindViewport(vtkRenderer* renderer)
{
  vtkMediumFrame::Viewport viewport;
  renderer->GetTiledSizeAndOrigin(
    &viewport.Size.x, &viewport.Size.y, &viewport.Origin.x, &viewport.Origin.y);
  vtkWindow* window = renderer->GetRenderWindow();
  const int* size = window->GetSize(); // of all tiles together
  double tile[4], part[4];
  window->GetTileViewport(tile);
  renderer->GetViewport(part);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double before = (tile[axis] - part[axis]) * size[axis] + viewport.Origin[axis];
    viewport.FirstPixel[axis] = std::max(static_cast<int>(std::lround(before)), 0);
  }
  return viewport;
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::Gather(const Request& request)
{
  vtkMediumScene& scene = this->Scene;
  std::string refusal = scene.GatherVolume(request.Input, request.Scalars, request.ScalarsOnCells,
    request.Volume, request.Medium, request.Anisotropy);
  refusal = refusal.empty() ? scene.GatherMask(request.Input, request.Mask) : refusal;
  refusal = refusal.empty() ? scene.GatherCut(request.Mapper, request.Volume) : refusal;
  if (!refusal.empty())
  {
    return refusal;
  }
  const std::shared_ptr<const vtkMediumUserCode>& code = request.Settings.UserCode;
  if (code)
  {
    scene.Content.UserCode = code->GetSignature();
    scene.Content.Altered = code->Has(vtkMediumUserCode::Coefficients);
    scene.Content.ChromaticExtinction |= scene.Content.Altered;
  }
  if (!request.Medium)
  {
    scene.Content.Phase = request.Phase;
  }
  scene.Casters.clear();
  if (request.OpaqueShadows)
  {
    scene.GatherCasters(request.Renderer);
  }
  refusal = scene.GatherLights(request.Renderer);
  return refusal.empty() ? this->GatherView(request.Renderer) : refusal;
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::GatherView(vtkRenderer* renderer)
{
  vtkMatrix4x4 *worldToClip, *worldToView, *viewToClip;
  vtkMatrix3x3* normals;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  vtkNew<vtkMatrix4x4> columns; // the camera keeps its matrices transposed for OpenGL
  vtkMatrix4x4::Transpose(worldToClip, columns);
  return this->Scene.GatherView(columns);
}

//------------------------------------------------------------------------------
vtkMediumPlan::Capabilities vtkMediumRenderer::FindCapabilities()
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
std::string vtkMediumRenderer::DrawFrame(
  const Request& request, const vtkMediumPlan::Settings& settings, const vtkMediumPlan& plan)
{
  vtkMediumFrame::Viewport viewport = FindViewport(request.Renderer);
  viewport.PixelEdge = std::max(request.PixelEdge, double(this->Economy.PixelEdge));
  if (viewport.Size.x < 1 || viewport.Size.y < 1)
  {
    return {}; // a viewport without pixels shows nothing
  }
  this->InPieces = bool(request.Peeling);
  if (this->InPieces)
  {
    return this->DrawPieces(request, plan, viewport);
  }
  const vtkMediumSurroundings surroundings(request.Renderer, request.Volume);
  vtkMediumSignature signature = vtkMediumSignature::OfFrame(this->Scene, settings);
  signature.Add(surroundings.GetSignature());
  for (double value : { double(viewport.Size.x), double(viewport.Size.y),
         double(viewport.FirstPixel.x), double(viewport.FirstPixel.y), viewport.PixelEdge })
  {
    signature.Add(value);
  }
  this->Reused = surroundings.IsKnown() && signature == this->FrameSignature;
  std::string refusal;
  if (!this->Reused)
  {
    this->FrameSignature = vtkMediumSignature();
    refusal = this->IntegrateFrame(this->Frame, request, plan, viewport, surroundings.MayHide());
    if (refusal.empty() && this->Frame.IsComplete() && this->ShadowMap.IsComplete())
    {
      this->FrameSignature = signature;
    }
  }
  this->Output = request.Settings.Output;
  const bool inView = this->Frame.IsComplete() && this->Frame.GetDraws() > 0;
  if (refusal.empty() && request.Show && inView &&
    !this->Frame.Show(
      this->Programs, vtkMediumImages::FindShown(this->Scene, this->Output), this->Coarser))
  {
    refusal =
      "The shader that shows a frame did not compile on this device; the compiler's words are "
      "above.";
  }
  glFinish(); // so that the time that was measured is the time it took
  return refusal;
}

//------------------------------------------------------------------------------
void vtkMediumRenderer::CountWork(const vtkMediumPlan& plan, vtkMediumStatistics* statistics)
{
  ++statistics->Frames;
  statistics->FramesReused += this->Reused ? 1 : 0;
  statistics->Passes = this->Reused ? 0 : this->Frame.GetDraws();
  statistics->PixelEdge = this->Frame.GetViewport().PixelEdge;
  statistics->EyeStep = plan.EyeStep * this->Scene.Geometry.Length;
  statistics->LightMethod = plan.ClosedForm ? vtkMediumStatistics::LightInClosedForm
    : plan.CachedLights == 0                ? vtkMediumStatistics::LightMarched
    : plan.CacheRoughness                   ? vtkMediumStatistics::LightMarchedToItsCache
                                            : vtkMediumStatistics::LightLookedUp;
  statistics->TextureUploads = this->Textures.GetUploads();
  statistics->ProgramCompiles = this->Programs.GetCompiles();
  statistics->BrickBuilds = this->Accelerator.GetBrickBuilds();
  statistics->LightCacheBuilds = this->Accelerator.GetLightCacheBuilds();
  statistics->LightCacheUploads = this->Accelerator.GetLightCacheUploads();
  statistics->ShadowMapBuilds = this->ShadowMap.GetBuilds();
  statistics->OpaqueDepthCopies =
    this->Frame.GetDepthCopies() + this->Probe.GetDepthCopies() + this->Coarser.GetDepthCopies();
  statistics->Calibrations = this->StepControl.GetCalibrations();
  statistics->GPUBytes = this->Textures.GetBytes() + this->Accelerator.GetBytes() +
    this->ShadowMap.GetBytes() + this->Peel.GetBytes() + this->Frame.GetBytes() +
    this->Probe.GetBytes() + this->Coarser.GetBytes();
  const vtkMediumBricks& bricks = this->Accelerator.GetBricks();
  const std::size_t leapt =
    bricks.GetNumberOf(vtkMediumBricks::Empty) + this->Accelerator.GetBricksCutAway();
  const glm::ivec3& count = bricks.GetCount();
  statistics->BricksLeapt = plan.UseTiles ? static_cast<vtkTypeInt64>(leapt) : 0;
  statistics->BricksVisited = plan.UseBricks
    ? static_cast<vtkTypeInt64>(count.x) * count.y * count.z - statistics->BricksLeapt
    : 0;
  const vtkMediumImages::Counts counts = statistics->CountTaps && !this->Reused
    ? vtkMediumImages::Count(this->Frame.DownloadHits())
    : vtkMediumImages::Counts();
  statistics->Taps = counts.Taps;
  statistics->Rays = counts.Rays;
  statistics->RaysRefined = counts.Refined;
}

//------------------------------------------------------------------------------
void vtkMediumRenderer::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window)
  {
    this->Textures.ReleaseGraphicsResources(window);
    this->Accelerator.ReleaseGraphicsResources(window);
    this->ShadowMap.ReleaseGraphicsResources(window);
    this->Programs.ReleaseGraphicsResources(window);
    this->Peel.ReleaseGraphicsResources(window);
    this->Probe.ReleaseGraphicsResources(window);
    this->Coarser.ReleaseGraphicsResources(window);
    this->Frame.ReleaseGraphicsResources(window);
    this->FrameSignature = vtkMediumSignature();
  }
}

//------------------------------------------------------------------------------
vtkWindow* vtkMediumRenderer::GetWindow() const
{
  return this->Window;
}
