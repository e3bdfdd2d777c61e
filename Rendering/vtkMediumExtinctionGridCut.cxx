// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMediumExtinctionGrid::CutAway.
#include "vtkMediumExtinctionGrid.h"

#include "vtkMediumCut.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
//------------------------------------------------------------------------------
// The shares of voxels on the kept side of planes.
class Shares
{
public:
  Shares(const vtkMediumCut& cut, const glm::dmat3& voxel)
    : Cut(cut)
    , Voxel(voxel)
  {
  }

  /// Of the voxel around a point, as if planes cut it independently of each other.
  double Find(const glm::dvec3& local) const
  {
    double share = 1;
    for (const vtkMediumCut::Plane& plane : this->Cut.Planes)
    {
      share *= this->Behind(plane, local);
    }
    return share > 0 && this->Cut.CutsRegions() ? share * this->InRegions(local) : share;
  }

private:
  // The distance over the voxel's width along the normal: exact for a plane along faces.
  double Behind(const vtkMediumCut::Plane& plane, const glm::dvec3& local) const
  {
    const double width = std::abs(glm::dot(plane.Normal, this->Voxel[0])) +
      std::abs(glm::dot(plane.Normal, this->Voxel[1])) +
      std::abs(glm::dot(plane.Normal, this->Voxel[2]));
    return std::clamp(0.5 + plane.Distance(local) / width, 0.0, 1.0);
  }

  double InRegions(const glm::dvec3& local) const
  {
    double parts[3][3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double lower = this->Behind(this->Cut.Lower[axis], local);
      const double upper = this->Behind(this->Cut.Upper[axis], local);
      parts[axis][0] = 1 - lower;
      parts[axis][1] = lower - upper;
      parts[axis][2] = upper;
    }
    double sum = 0;
    for (int region = 0; region < 27; ++region)
    {
      const bool kept = this->Cut.Regions >> region & 1;
      sum += kept ? parts[0][region % 3] * parts[1][region / 3 % 3] * parts[2][region / 9] : 0;
    }
    return sum;
  }

  const vtkMediumCut& Cut;
  glm::dmat3 Voxel;
};
}

//------------------------------------------------------------------------------
void vtkMediumExtinctionGrid::CutAway(const vtkMediumCut& cut)
{
  const Shares shares(cut, this->LatticeToLocalAxes);
  const glm::ivec3 n = this->Dimensions;
  vtkSMPTools::For(0, static_cast<vtkIdType>(n.y) * n.z, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType row = begin; row < end; ++row)
    {
      float* values = this->Values.data() + row * n.x;
      for (int i = 0; i < n.x; ++i)
      {
        const glm::dvec3 at(i, static_cast<int>(row % n.y), static_cast<int>(row / n.y));
        values[i] *= static_cast<float>(shares.Find(this->LatticeToLocal(at)));
      }
    }
  });
  this->FindStatistics();
}
