// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumShadowEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
//------------------------------------------------------------------------------
// Four voxels around an edge along axis w bend the depth unless two of the four faces that meet
// there are not seen: equal values on both sides of one plane. `upper` is the voxel on the upper side
// of both planes; outside the lattice is another value that is equal everywhere.
bool Bends(const vtkMediumLatticeValues& values, int u, const glm::ivec3& upper)
{
  const int v = (u + 1) % 3;
  const glm::ivec3 size = values.GetLattice().Dimensions;
  for (int c = 0; c < values.GetComponents(); ++c)
  {
    double around[4];
    for (int voxel = 0; voxel < 4; ++voxel)
    {
      glm::ivec3 at = upper;
      at[u] -= 1 - (voxel & 1);
      at[v] -= 1 - (voxel >> 1);
      double corners[8] = { std::numeric_limits<double>::infinity() };
      if (glm::clamp(at, glm::ivec3(0), size - 1) == at)
      {
        values.GetCorners(at, c, corners);
      }
      around[voxel] = corners[0];
    }
    const bool acrossU = around[0] == around[1] && around[2] == around[3];
    const bool acrossV = around[0] == around[2] && around[1] == around[3];
    if (!acrossU && !acrossV)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// The voxel faces of a nearest field along one axis: face 0 and face `Count` are those of the box.
struct Faces
{
  int Count;
  double First;

  Faces(const vtkMediumLattice& lattice, int axis)
    : Count(lattice.Dimensions[axis])
    , First(lattice.GetOffset())
  {
  }

  double operator[](int face) const
  {
    return face == 0 ? this->First : face == this->Count ? this->Count - this->First : face;
  }
};
}

//------------------------------------------------------------------------------
vtkMediumShadowEdges::vtkMediumShadowEdges(const vtkMediumReferenceContent& content,
  const vtkMediumScene::Box& box, const vtkMediumScene::Light& light, const vtkMediumBoxRay& ray)
  : Content(content)
  , Ray(ray)
  , Positional(light.Type != vtkMediumScene::Light::Directional)
  , Light(this->Positional ? box.LocalToBox(light.Position) : box.LocalToBoxAxes * -light.Direction)
{
}

//------------------------------------------------------------------------------
vtkMediumShadowEdges::Sweep vtkMediumShadowEdges::MakeSweep(
  const glm::dvec3& scale, double offset, double begin, double end) const
{
  return { scale * (this->Ray.Origin + begin * this->Ray.Direction) + offset,
    scale * (this->Ray.Origin + end * this->Ray.Direction) + offset, this->Positional,
    scale * this->Light + (this->Positional ? offset : 0.0) };
}

//------------------------------------------------------------------------------
// The fraction of the piece, in (0,1), at which the light ray meets the edge u = i, v = j, and where
// along the edge; false if it never does.
bool vtkMediumShadowEdges::Sweep::Cross(
  int u, double i, double j, double& fraction, double& height) const
{
  const int v = (u + 1) % 3, w = (u + 2) % 3;
  const auto side = [&](const glm::dvec3& at) {
    const glm::dvec3 way = this->ToLight(at);
    return (j - at[v]) * way[u] - (i - at[u]) * way[v];
  };
  const double begin = side(this->Begin), end = side(this->End);
  fraction = begin / (begin - end);
  if (!(fraction > 0 && fraction < 1))
  {
    return false;
  }
  const glm::dvec3 at = this->Begin + fraction * (this->End - this->Begin);
  const glm::dvec3 way = this->ToLight(at);
  const double reach =
    std::abs(way[u]) > std::abs(way[v]) ? (i - at[u]) / way[u] : (j - at[v]) / way[v];
  height = at[w] + reach * way[w];
  return reach > 0 && (!this->Positional || reach < 1);
}

//------------------------------------------------------------------------------
void vtkMediumShadowEdges::AppendBoxEdges(double begin, double end, std::vector<double>& cuts) const
{
  const Sweep sweep = this->MakeSweep(glm::dvec3(1), 0, begin, end);
  for (int edge = 0; edge < 12; ++edge)
  {
    double fraction, height;
    if (sweep.Cross(edge / 4, edge & 1, edge >> 1 & 1, fraction, height) && height >= 0 &&
      height <= 1)
    {
      cuts.push_back(begin + fraction * (end - begin));
    }
  }
}

//------------------------------------------------------------------------------
void vtkMediumShadowEdges::AppendVoxelEdges(
  double begin, double end, std::vector<double>& cuts) const
{
  for (int field = 0; field < this->Content.GetNumberOfExtinctionFields(); ++field)
  {
    const vtkMediumLatticeValues& values = this->Content.GetValues(field);
    const vtkMediumLattice& lattice = values.GetLattice();
    if (!lattice.Linear)
    {
      const Sweep sweep = this->MakeSweep(lattice.GetScale(), lattice.GetOffset(), begin, end);
      for (int u = 0; u < 3; ++u)
      {
        this->AppendVoxelEdges(values, sweep, u, begin, end, cuts);
      }
    }
  }
}

//------------------------------------------------------------------------------
// All edges along axis w between the light rays of the piece's two ends: for each face u = i on the
// way, the faces v = j between the points where the two rays meet it.
void vtkMediumShadowEdges::AppendVoxelEdges(const vtkMediumLatticeValues& values,
  const Sweep& sweep, int u, double begin, double end, std::vector<double>& cuts) const
{
  const int v = (u + 1) % 3, w = (u + 2) % 3;
  const glm::dvec3 wayA = sweep.ToLight(sweep.Begin), wayB = sweep.ToLight(sweep.End);
  if (!(wayA[u] * wayB[u] > 0))
  {
    return; // no face on the way, or none that both meet
  }
  const Faces facesU(values.GetLattice(), u), facesV(values.GetLattice(), v);
  const int step = wayA[u] > 0 ? 1 : -1;
  const double middle = 0.5 * (sweep.Begin[u] + sweep.End[u]);
  const int sizeW = values.GetLattice().Dimensions[w];
  for (int i = static_cast<int>(std::floor(middle)) + (step > 0 ? 1 : 0);
       i >= 0 && i <= facesU.Count; i += step)
  {
    const double reachA = (facesU[i] - sweep.Begin[u]) / wayA[u];
    const double reachB = (facesU[i] - sweep.End[u]) / wayB[u];
    if (sweep.Positional && std::min(reachA, reachB) > 1)
    {
      return;
    }
    const double vA = sweep.Begin[v] + reachA * wayA[v], vB = sweep.End[v] + reachB * wayB[v];
    const double low = std::min(vA, vB), high = std::max(vA, vB);
    const double limit = facesV.Count + 1.0; // one beyond the box, and safe to convert
    const int from = static_cast<int>(glm::clamp(std::floor(low), -1.0, limit));
    const int to = static_cast<int>(glm::clamp(std::ceil(high), -1.0, limit));
    for (int j = std::max(from, 0); j <= std::min(to, facesV.Count); ++j)
    {
      double fraction, height;
      if (facesV[j] < low || facesV[j] > high ||
        !sweep.Cross(u, facesU[i], facesV[j], fraction, height) || height < 0 || height >= sizeW)
      {
        continue;
      }
      glm::ivec3 upper;
      upper[u] = i;
      upper[v] = j;
      upper[w] = static_cast<int>(height);
      if (Bends(values, u, upper))
      {
        cuts.push_back(begin + fraction * (end - begin));
      }
    }
  }
}
