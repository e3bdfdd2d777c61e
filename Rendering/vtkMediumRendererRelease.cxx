// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What leaves the device after a frame that did not need it.
#include "vtkMediumRenderer.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkOpenGLRenderWindow.h"

//------------------------------------------------------------------------------
// What the next frame may need again without a change of settings is kept: light caches while an output
// needs no light, or while they are not accurate enough at rest, since hurried frames look light up in them;
// shadow maps while no geometry is there; tables, of some kilobytes, until the window goes. A selection is
// drawn between frames, and nothing leaves for it.
void vtkMediumRenderer::ReleaseUnread(const Request& request, const vtkMediumPlan& draft)
{
  if (request.Selector)
  {
    return;
  }
  this->Textures.ReleaseUnread(draft);
  this->Accelerator.ReleaseUnread(draft, this->Scene.Lights.empty());
  if (!request.OpaqueShadows)
  {
    this->ShadowMap.ReleaseGraphicsResources(this->Window);
  }
  if (!request.Peeling)
  {
    this->Peel.ReleaseGraphicsResources(this->Window);
  }
  const bool estimates = request.Settings.Output == vtkSingleScatteringVolumeMapper::ErrorEstimate;
  if (!estimates)
  {
    this->Coarser.ReleaseGraphicsResources(this->Window);
  }
  if (!draft.UseBricks && !request.Peeling)
  {
    this->Probe.ReleaseGraphicsResources(this->Window);
  }
}
