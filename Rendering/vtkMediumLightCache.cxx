// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightCache.h"

#include "vtkMediumLightRays.h"
#include "vtkMediumLightStencil.h"

namespace
{
// Extinction > 0 is looked up in the cells next to it (1), with the second differences there (2).
constexpr int Reach = 2;

// Rays a lattice step, for point lights. The rays cost as its square; the points that need one of
// their own grow as it falls. Between 0.5, cheapest on smooth fields, and 1, cheapest on rough ones.
constexpr double RayDensity = 0.75;
}

//------------------------------------------------------------------------------
void vtkMediumLightCache::Build(
  const vtkMediumExtinctionGrid& grid, const vtkMediumScene::Light& light)
{
  this->Dimensions = grid.GetDimensions();
  this->Marches = 0;
  if (light.Type == vtkMediumScene::Light::Directional)
  {
    vtkMediumLightStencil stencil;
    stencil.Build(grid, light.Direction);
    stencil.Apply(grid, Reach, this->Depths);
  }
  else
  {
    this->Marches =
      vtkMediumLightRays::Build(grid, light, RayDensity, this->Tolerance, Reach, this->Depths);
  }
  ++this->Builds;
}

//------------------------------------------------------------------------------
bool vtkMediumLightCache::HaveSamePose(
  const vtkMediumScene::Light& a, const vtkMediumScene::Light& b)
{
  using Light = vtkMediumScene::Light;
  return a.Type == b.Type && (a.Type == Light::Directional || a.Position == b.Position) &&
    (a.Type == Light::Point || a.Direction == b.Direction) &&
    (a.Type != Light::Spot || a.CosCone == b.CosCone);
}
