// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumExtinctionProjection.h"

#include "vtkMediumFunction.h"

#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace
{
constexpr int Intervals = 8192; // of the table; twice those of a vtkMediumFunction
// Of the largest extinction: how far a function may be from straight over a cell and be left alone.
constexpr float StraightTolerance = 1e-3f;
// Three-point Gauss-Legendre over [0, 1].
constexpr int Nodes = 3;
constexpr float Node[Nodes] = { 0.1127016653792583f, 0.5f, 0.8872983346207417f };
constexpr float Weight[Nodes] = { 5.0f / 18, 8.0f / 18, 5.0f / 18 };

//------------------------------------------------------------------------------
float Trilinear(const float corners[8], float x, float y, float z)
{
  return glm::mix(
    glm::mix(glm::mix(corners[0], corners[1], x), glm::mix(corners[2], corners[3], x), y),
    glm::mix(glm::mix(corners[4], corners[5], x), glm::mix(corners[6], corners[7], x), y), z);
}

//------------------------------------------------------------------------------
// Hats of points on the lattice's faces are halves, quarters, eighths of one.
void Normalize(const glm::ivec3& dimensions, std::vector<float>& averages)
{
  std::size_t index = 0;
  for (int k = 0; k < dimensions.z; ++k)
  {
    for (int j = 0; j < dimensions.y; ++j)
    {
      const float row = (k == 0 || k == dimensions.z - 1 ? 2.0f : 1.0f) *
        (j == 0 || j == dimensions.y - 1 ? 2.0f : 1.0f);
      for (int i = 0; i < dimensions.x; ++i, ++index)
      {
        averages[index] *= i == 0 || i == dimensions.x - 1 ? 2 * row : row;
      }
    }
  }
}

//------------------------------------------------------------------------------
// The hat functions of a cell's corners at a point of the cell.
float Hat(int corner, float x, float y, float z)
{
  return (corner & 1 ? x : 1 - x) * (corner & 2 ? y : 1 - y) * (corner & 4 ? z : 1 - z);
}
}

//------------------------------------------------------------------------------
vtkMediumExtinctionProjection::vtkMediumExtinctionProjection(
  double minimum, double maximum, const std::function<double(double)>& extinction)
  : Minimum(static_cast<float>(minimum))
  , Scale(maximum > minimum ? static_cast<float>(Intervals / (maximum - minimum)) : 0.0f)
  , Table(Intervals + 1)
  , Turns(Intervals + 1, 0.0f)
{
  float largest = 0;
  for (int i = 0; i <= Intervals; ++i)
  {
    const double value = extinction(vtkMediumFunction::GetPlace(minimum, maximum, i, Intervals));
    this->Table[i] = static_cast<float>(value);
    largest = std::max(largest, this->Table[i]);
  }
  for (int i = 1; i <= Intervals; ++i)
  {
    const float bend =
      i < Intervals ? this->Table[i - 1] - 2 * this->Table[i] + this->Table[i + 1] : 0;
    this->Turns[i] = this->Turns[i - 1] + (largest > 0 ? std::abs(bend) / largest : 0);
  }
}

//------------------------------------------------------------------------------
bool vtkMediumExtinctionProjection::Bends(float least, float largest) const
{
  const int first = static_cast<int>((least - this->Minimum) * this->Scale) - 1;
  const int last = static_cast<int>((largest - this->Minimum) * this->Scale) + 1;
  const float turn = this->Turns[std::min(std::max(last, 0), Intervals)] -
    this->Turns[std::min(std::max(first, 0), Intervals)];
  return 0.25f * turn * static_cast<float>(last - first) > StraightTolerance;
}

//------------------------------------------------------------------------------
float vtkMediumExtinctionProjection::Evaluate(float scalar) const
{
  const float position = (scalar - this->Minimum) * this->Scale;
  const int i = std::min(std::max(static_cast<int>(position), 0), Intervals - 1);
  return glm::mix(this->Table[i], this->Table[i + 1], position - static_cast<float>(i));
}

//------------------------------------------------------------------------------
// What the difference adds to the average under each corner's hat; the hat's integral is 1.
bool vtkMediumExtinctionProjection::AverageCell(const float scalars[8], float averages[8]) const
{
  const auto range = std::minmax_element(scalars, scalars + 8);
  if (!this->Bends(*range.first, *range.second))
  {
    return false;
  }
  float corners[8];
  for (int corner = 0; corner < 8; ++corner)
  {
    corners[corner] = this->Evaluate(scalars[corner]);
    averages[corner] = 0;
  }
  for (int node = 0; node < Nodes * Nodes * Nodes; ++node)
  {
    const int i = node % Nodes, j = node / Nodes % Nodes, k = node / (Nodes * Nodes);
    const float x = Node[i], y = Node[j], z = Node[k];
    const float difference =
      this->Evaluate(Trilinear(scalars, x, y, z)) - Trilinear(corners, x, y, z);
    for (int corner = 0; corner < 8; ++corner)
    {
      averages[corner] += Weight[i] * Weight[j] * Weight[k] * Hat(corner, x, y, z) * difference;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkMediumExtinctionProjection::AverageLayer(const glm::ivec3& dimensions,
  const std::vector<float>& scalars, int layer, std::vector<float>& averages) const
{
  const std::size_t row = dimensions.x, slice = row * dimensions.y;
  for (int j = 0; j < dimensions.y - 1; ++j)
  {
    for (int i = 0; i < dimensions.x - 1; ++i)
    {
      const std::size_t first = i + row * j + slice * layer;
      auto index = [&](int corner) {
        return first + (corner & 1) + (corner & 2 ? row : 0) + (corner & 4 ? slice : 0);
      };
      float cell[8], added[8];
      for (int corner = 0; corner < 8; ++corner)
      {
        cell[corner] = scalars[index(corner)];
      }
      if (this->AverageCell(cell, added))
      {
        for (int corner = 0; corner < 8; ++corner)
        {
          averages[index(corner)] += added[corner];
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkMediumExtinctionProjection::Apply(const glm::ivec3& dimensions,
  const std::vector<float>& scalars, std::vector<float>& extinctions) const
{
  std::vector<float> averages(extinctions.size(), 0.0f);
  // A layer of cells writes to its two layers of points, so that every other one may run at once.
  for (int odd = 0; odd < 2; ++odd)
  {
    vtkSMPTools::For(0, (dimensions.z - odd) / 2, [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType pair = begin; pair < end; ++pair)
      {
        this->AverageLayer(dimensions, scalars, static_cast<int>(2 * pair) + odd, averages);
      }
    });
  }
  Normalize(dimensions, averages);
  const std::ptrdiff_t strides[3] = { 1, dimensions.x,
    static_cast<std::ptrdiff_t>(dimensions.x) * dimensions.y };
  vtkSMPTools::For(0, dimensions.z, [&](vtkIdType begin, vtkIdType end) {
    const std::ptrdiff_t last = end * strides[2];
    for (std::ptrdiff_t index = begin * strides[2]; index < last; ++index)
    {
      const glm::ivec3 at(
        index % dimensions.x, index / strides[1] % dimensions.y, index / strides[2]);
      const float center = averages[index];
      float differences = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const bool first = at[axis] == 0, end = at[axis] == dimensions[axis] - 1;
        const float below = first ? 0 : averages[index - strides[axis]] - center;
        const float above = end ? 0 : averages[index + strides[axis]] - center;
        differences += first || end ? 2 * (below + above) : below + above;
      }
      if (center != 0 || differences != 0)
      {
        extinctions[index] = std::max(extinctions[index] + center - differences * (1.0f / 6), 0.0f);
      }
    }
  });
}
