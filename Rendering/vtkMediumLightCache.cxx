// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLightCache.h"

#include "vtkMediumHalf.h"
#include "vtkMediumLightRays.h"
#include "vtkMediumLightStencil.h"
#include "vtkMediumTargetClones.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
// Extinction > 0 is looked up in the cells next to it (1), with the second differences there (2).
constexpr int Reach = 2;

// Rays a lattice step, for point lights. The rays cost as its square; the points that need one of
// their own grow as it falls. Between 0.5, cheapest on smooth fields, and 1, cheapest on rough ones.
constexpr double RayDensity = 0.75;

// Slabs need all lattice points, the exact form only those near extinction > 0: below this part of the
// lattice the exact form is the faster one.
constexpr double LeastOccupiedForSlabs = 0.15;

//------------------------------------------------------------------------------
// One row: center - 1/12 of the second differences along x, y and z.
void Prefilter(const float* center, const float* below, const float* above, const float* front,
  const float* back, int n, float* target)
{
  for (int x = 0; x < n; ++x)
  {
    const bool face = x == 0 || x == n - 1;
    const float left = center[face ? x : x - 1], right = center[face ? x : x + 1];
    target[x] = center[x] -
      (left + right + below[x] + above[x] + front[x] + back[x] - 6 * center[x]) * (1.0f / 12);
  }
}

//------------------------------------------------------------------------------
// One row: 1/8 of the magnitudes of the second differences along x, y and z.
void FindRoughness(const float* center, const float* below, const float* above, const float* front,
  const float* back, int n, float* target)
{
  for (int x = 0; x < n; ++x)
  {
    const bool face = x == 0 || x == n - 1;
    const float left = center[face ? x : x - 1], right = center[face ? x : x + 1];
    const float twice = 2 * center[x];
    target[x] = (std::abs(left + right - twice) + std::abs(below[x] + above[x] - twice) +
                  std::abs(front[x] + back[x] - twice)) *
      (1.0f / 8);
  }
}

//------------------------------------------------------------------------------
void MarkUnknown(const float* depths, int n, float* roughness)
{
  for (int x = 0; x < n; ++x)
  {
    roughness[x] = depths[x] < 0 ? 1.0f : roughness[x];
  }
}
}

//------------------------------------------------------------------------------
void vtkMediumLightCache::Build(
  const vtkMediumExtinctionGrid& grid, const vtkMediumScene::Light& light)
{
  this->Dimensions = grid.GetDimensions();
  this->Marches = 0;
  if (light.Type == vtkMediumScene::Light::Directional)
  {
    const bool slabs = this->Slabs && grid.GetOccupiedFraction() > LeastOccupiedForSlabs;
    vtkMediumLightStencil stencil;
    stencil.Build(grid, light.Direction, slabs);
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

//------------------------------------------------------------------------------
// Slices [begin, end) of the lattice, written to target from its start.
void vtkMediumLightCache::FilterSlices(
  double densityScale, Filters filter, int begin, int end, float* target) const
{
  const glm::ivec3 n = this->Dimensions;
  const std::size_t slice = static_cast<std::size_t>(n.x) * n.y;
  const int first = filter == Plain ? begin : std::max(begin - 1, 0);
  const int last = filter == Plain ? end : std::min(end + 1, n.z);
  std::vector<float> transmittance((last - first) * slice);
  const float scale = static_cast<float>(-densityScale);
  const float* depths = this->Depths.data() + first * slice;
  for (std::size_t i = 0; i < transmittance.size(); ++i)
  {
    transmittance[i] = std::exp(std::max(scale * std::max(depths[i], 0.0f), -80.0f));
  }
  for (int z = begin; z < end; ++z)
  {
    auto row = [&](int y, int k) {
      return transmittance.data() + y * static_cast<std::size_t>(n.x) + (k - first) * slice;
    };
    // On the lattice's faces nothing is known of the second difference across them; it counts as 0.
    const int acrossZ = z == 0 || z == n.z - 1 ? 0 : 1;
    for (int y = 0; y < n.y; ++y)
    {
      float* result = target + (z - begin) * slice + y * static_cast<std::size_t>(n.x);
      const int acrossY = y == 0 || y == n.y - 1 ? 0 : 1;
      switch (filter)
      {
        case Plain:
          std::copy(row(y, z), row(y, z) + n.x, result);
          break;
        case Prefiltered:
          Prefilter(row(y, z), row(y - acrossY, z), row(y + acrossY, z), row(y, z - acrossZ),
            row(y, z + acrossZ), n.x, result);
          break;
        case Roughness:
          FindRoughness(row(y, z), row(y - acrossY, z), row(y + acrossY, z), row(y, z - acrossZ),
            row(y, z + acrossZ), n.x, result);
          MarkUnknown(
            this->Depths.data() + z * slice + y * static_cast<std::size_t>(n.x), n.x, result);
          break;
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkMediumLightCache::Pack(
  double densityScale, Filters filter, std::uint16_t* target, std::size_t stride) const
{
  constexpr int Slab = 4; // slices at a time; two more are computed for them
  const std::size_t slice = static_cast<std::size_t>(this->Dimensions.x) * this->Dimensions.y;
  const int slabs = (this->Dimensions.z + Slab - 1) / Slab;
  vtkSMPTools::For(0, slabs, 1, [&](vtkIdType begin, vtkIdType end) {
    std::vector<float> values(Slab * slice);
    for (int slab = static_cast<int>(begin); slab < end; ++slab)
    {
      const int first = slab * Slab, last = std::min(first + Slab, this->Dimensions.z);
      this->FilterSlices(densityScale, filter, first, last, values.data());
      vtkMediumPackHalf(
        values.data(), (last - first) * slice, target + first * slice * stride, stride);
    }
  });
}

//------------------------------------------------------------------------------
void vtkMediumLightCache::PackTransmittance(
  double densityScale, bool prefilter, std::uint16_t* target, std::size_t stride) const
{
  this->Pack(densityScale, prefilter ? Prefiltered : Plain, target, stride);
}

//------------------------------------------------------------------------------
void vtkMediumLightCache::PackWithRoughness(
  double densityScale, std::uint16_t* target, std::size_t stride) const
{
  this->Pack(densityScale, Prefiltered, target, stride);
  this->Pack(densityScale, Roughness, target + 1, stride);
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumLightCache::Get(double densityScale, Filters filter) const
{
  std::vector<float> values(this->Depths.size());
  if (!values.empty())
  {
    this->FilterSlices(densityScale, filter, 0, this->Dimensions.z, values.data());
  }
  return values;
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumLightCache::GetTransmittance(double densityScale, bool prefilter) const
{
  return this->Get(densityScale, prefilter ? Prefiltered : Plain);
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumLightCache::GetRoughness(double densityScale) const
{
  return this->Get(densityScale, Roughness);
}
