// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// How vtkMediumRenderer integrates a frame: as a whole, or for depth peeling in two pieces of each ray, each a
// frame of its own.
#include "vtkMediumRenderer.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkOpenGLRenderWindow.h"

#include <array>

namespace
{
//------------------------------------------------------------------------------
std::string NameCompilerFault(const vtkMediumPlan& plan)
{
  return plan.UserCode ? "The shader code of the volume's vtkShaderProperty does not compile; the "
                         "compiler's words are "
                         "above. Correct it, or take it away (ClearAllFragmentShaderReplacements)."
                       : "A shader did not compile on this device; the compiler's words are above.";
}
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::Integrate(
  vtkMediumFrame& frame, const vtkMediumPlan& plan, const vtkMediumFrame::Progress& progress)
{
  const bool compiled =
    frame.Integrate({ this->Programs, this->Textures, this->Accelerator, this->ShadowMap },
      this->Scene, plan, progress);
  return compiled ? std::string() : NameCompilerFault(plan);
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::IntegrateFrame(vtkMediumFrame& frame, const Request& request,
  const vtkMediumPlan& plan, const vtkMediumFrame::Viewport& viewport, bool mayBeHidden,
  vtkTextureObject* ends)
{
  std::string refusal =
    frame.Begin(this->Window, viewport, plan.NeedsState(), mayBeHidden, plan.Finishes);
  if (refusal.empty())
  {
    if (ends)
    {
      frame.SetEnds(ends);
    }
    refusal = this->Integrate(frame, plan, request.Progress);
  }
  if (refusal.empty() && frame.IsComplete() &&
    request.Settings.Output == vtkSingleScatteringVolumeMapper::ErrorEstimate)
  {
    refusal = this->Coarser.Begin(this->Window, viewport, plan.NeedsState(), mayBeHidden);
    refusal = refusal.empty() ? this->Integrate(this->Coarser, plan.Coarser()) : refusal;
  }
  if (refusal.empty() && frame.IsComplete() && plan.Finishes &&
    !frame.Finish(this->Programs, this->Scene, plan))
  {
    refusal = NameCompilerFault(plan);
  }
  return refusal;
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::DrawPieces(
  const Request& request, const vtkMediumPlan& plan, const vtkMediumFrame::Viewport& viewport)
{
  this->FrameSignature = vtkMediumSignature();
  this->Reused = false;
  std::string refusal =
    this->Peel.Note(request.Peeling, this->Window, this->Programs, viewport.Size);
  vtkMediumFrame* const frames[vtkMediumPeel::Pieces] = { &this->Frame, &this->Probe };
  std::array<vtkTextureObject*, vtkMediumPeel::Pieces> radiance{};
  for (int piece = 0; piece < vtkMediumPeel::Pieces && refusal.empty(); ++piece)
  {
    refusal = this->IntegrateFrame(
      *frames[piece], request, plan, viewport, false, this->Peel.GetEnds(piece));
    if (refusal.empty() && !frames[piece]->IsComplete())
    {
      return {}; // aborted
    }
    radiance[piece] = frames[piece]->GetRadiance();
  }
  return refusal.empty()
    ? vtkMediumPeel::HandOver(request.Peeling, this->Window, this->Programs, radiance)
    : refusal;
}
