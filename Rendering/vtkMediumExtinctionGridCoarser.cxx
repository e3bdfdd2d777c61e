// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMediumExtinctionGrid::BuildCoarser.
#include "vtkMediumExtinctionGrid.h"

#include "vtkSMPTools.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
//------------------------------------------------------------------------------
// One axis: where its points are among finer ones, and the means that they take of those.
struct Axis
{
  struct Mean
  {
    int First = 0;
    std::vector<float> Weights;
  };

  int Count;
  double Step;  // lattice steps of the finer points
  double First; // the first point's finer coordinate
  std::vector<Mean> Means;

  Axis(int fine, bool onCells)
    : Count(std::max((fine + 1) / 2, std::min(fine, 2)))
    , Step(onCells   ? static_cast<double>(fine) / this->Count
          : fine > 1 ? static_cast<double>(fine - 1) / (this->Count - 1)
                     : 1)
    , First(onCells ? 0.5 * this->Step - 0.5 : 0)
    , Means(this->Count)
  {
    for (int i = 0; i < this->Count; ++i)
    {
      const double center = this->First + i * this->Step;
      Mean& mean = this->Means[i];
      mean.First = std::max(static_cast<int>(std::floor(center - this->Step)) + 1, 0);
      const int last = std::min(static_cast<int>(std::ceil(center + this->Step)) - 1, fine - 1);
      double sum = 0;
      for (int at = mean.First; at <= last; ++at)
      {
        mean.Weights.push_back(static_cast<float>(1 - std::abs(at - center) / this->Step));
        sum += mean.Weights.back();
      }
      for (float& weight : mean.Weights)
      {
        weight = static_cast<float>(weight / sum);
      }
    }
  }
};

//------------------------------------------------------------------------------
// Of lines of `count` values that follow each other: their mean.
void TakeMean(const float* lines, const Axis::Mean& mean, std::size_t count, float* target)
{
  std::fill_n(target, count, 0.0f);
  for (std::size_t line = 0; line < mean.Weights.size(); ++line)
  {
    const float* values = lines + (mean.First + line) * count;
    const float weight = mean.Weights[line];
    for (std::size_t i = 0; i < count; ++i)
    {
      target[i] += weight * values[i];
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkMediumExtinctionGrid::BuildCoarser(const vtkMediumExtinctionGrid& fine)
{
  const glm::ivec3 n = fine.Dimensions;
  const Axis x(n.x, fine.OnCells), y(n.y, fine.OnCells), z(n.z, fine.OnCells);
  this->Dimensions = { x.Count, y.Count, z.Count };
  this->OnCells = fine.OnCells;
  this->Linear = fine.Linear;
  this->Affine = fine.Affine;
  const glm::dvec3 steps(x.Step, y.Step, z.Step);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->LatticeToLocalAxes[axis] = fine.LatticeToLocalAxes[axis] * steps[axis];
  }
  this->LocalToLatticeAxes = glm::inverse(this->LatticeToLocalAxes);
  this->LatticeToLocalOrigin = fine.LatticeToLocal({ x.First, y.First, z.First });
  this->Values.resize(static_cast<std::size_t>(x.Count) * y.Count * z.Count);
  vtkSMPTools::For(0, z.Count, [&](vtkIdType begin, vtkIdType end) {
    const std::size_t rowLength = n.x;
    std::vector<float> slice(rowLength * n.y), row(rowLength);
    for (vtkIdType k = begin; k < end; ++k)
    {
      TakeMean(fine.Values.data(), z.Means[k], slice.size(), slice.data());
      for (int j = 0; j < y.Count; ++j)
      {
        TakeMean(slice.data(), y.Means[j], rowLength, row.data());
        float* target = this->Values.data() + this->GetIndex(0, j, static_cast<int>(k));
        for (int i = 0; i < x.Count; ++i)
        {
          TakeMean(row.data(), x.Means[i], 1, target + i);
        }
      }
    }
  });
  this->FindStatistics();
}
