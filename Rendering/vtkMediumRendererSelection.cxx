// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMediumRenderer::Select.
#include "vtkMediumRenderer.h"

#include "vtkMediumSelection.h"
#include "vtkMediumStatistics.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::Select(const Request& request)
{
  Request selection = request;
  selection.Settings = vtkMediumSelection::FindSettings(request.Settings);
  selection.Seconds = 1e9; // it is not hurried, and no frame's time is learnt from it
  const vtkMediumScene shown = this->Scene;
  const vtkMediumFrameBudget::Economy economy = this->Economy;
  vtkNew<vtkMediumStatistics> unseen;
  const std::string refusal = this->Draw(selection, unseen);
  this->Scene = shown;
  this->Economy = economy;
  return refusal;
}

//------------------------------------------------------------------------------
std::string vtkMediumRenderer::DrawSelection(const Request& request, const vtkMediumPlan& plan)
{
  const vtkMediumFrame::Viewport viewport = FindViewport(request.Renderer);
  if (viewport.Size.x < 1 || viewport.Size.y < 1)
  {
    return {};
  }
  vtkMediumFrame frame;
  std::string refusal = frame.Begin(this->Window, viewport, plan.NeedsState(), true);
  refusal = refusal.empty() ? this->Integrate(frame, plan) : refusal;
  if (refusal.empty())
  {
    glm::ivec3 points;
    request.Input->GetDimensions(&points[0]);
    refusal = vtkMediumSelection::Draw(
      this->Window, this->Programs, frame, this->Scene, points, request.Selector);
  }
  frame.ReleaseGraphicsResources(this->Window);
  return refusal;
}
