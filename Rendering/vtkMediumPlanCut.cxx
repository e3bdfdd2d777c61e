// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What clipping and cropping ask of a plan.
#include "vtkMediumPlan.h"

#include <algorithm>
#include <sstream>

//------------------------------------------------------------------------------
void vtkMediumPlan::ValidateCut(const vtkMediumCut& cut)
{
  const int planes = static_cast<int>(cut.Planes.size());
  if (this->Refusal.empty() && planes > MostClippingPlanes)
  {
    std::ostringstream text;
    text << planes << " clipping planes, with those of a cropped box, cut the volume, but at most "
         << MostClippingPlanes << " can be honoured; remove some (RemoveClippingPlane).";
    this->Refusal = text.str();
  }
}

//------------------------------------------------------------------------------
// Whether a light ray from what is kept may pass through what is cut away.
bool vtkMediumPlan::CutsLightRays(const vtkMediumScene& scene)
{
  return std::any_of(
    scene.Lights.begin(), scene.Lights.end(), [&scene](const vtkMediumScene::Light& light) {
      const bool directional = light.Type == vtkMediumScene::Light::Directional;
      return !scene.Cut.HoldsWaysTo(directional ? -light.Direction : light.Position, directional);
    });
}
