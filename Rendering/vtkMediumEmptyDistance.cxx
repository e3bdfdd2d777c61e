// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumEmptyDistance.h"

#include "vtkMediumCoefficientBounds.h"
#include "vtkMediumLatticeRows.h"

#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace
{
constexpr float Far = 1e12f; // squared distance where nothing is known yet

//------------------------------------------------------------------------------
// Tells which cells of a lattice may hold medium.
class CellTest
{
public:
  CellTest(
    const vtkMediumScene& scene, const vtkMediumExtinctionGrid& grid, const vtkMediumBricks& bricks)
    : Grid(grid)
    , Bricks(bricks)
    , N(grid.GetDimensions())
  {
    const vtkMediumScene::Medium& medium = scene.Content;
    if (medium.ExtinctionIsAbsorption || !medium.Emission.IsZero() ||
      medium.Extinction.IsConstant())
    {
      return; // by bricks
    }
    this->ByValue = grid.IsAffine() && !medium.ChromaticExtinction;
    const vtkMediumField& field = medium.Fields[medium.Extinction.FieldIndex];
    this->Bounds.Build(medium, medium.Extinction);
    if (!this->ByValue && this->Bounds.GetFirstComponent() == this->Bounds.GetLastComponent())
    {
      this->Rows.reset(new vtkMediumLatticeRows(field, this->Bounds.GetFirstComponent()));
    }
  }

  /// Sets occupied[x] for the row of cells (y, z); cells beyond the lattice's end do not exist.
  void Test(int y, int z, std::vector<unsigned char>& occupied, std::vector<double>& scratch) const
  {
    const glm::ivec3 cells = glm::max(this->N - 1, glm::ivec3(1));
    for (int x = 0; x < cells.x; ++x)
    {
      const glm::ivec3 brick = glm::ivec3(x, y, z) / vtkMediumBricks::Edge;
      occupied[x] = this->Bricks.GetClass(brick) != vtkMediumBricks::Empty;
    }
    if (this->ByValue)
    {
      this->TestValues(y, z, cells.x, occupied);
    }
    else if (this->Rows && std::find(occupied.begin(), occupied.end(), 1) != occupied.end())
    {
      this->TestRanges(y, z, cells.x, occupied, scratch);
    }
  }

private:
  void TestValues(int y, int z, int cells, std::vector<unsigned char>& occupied) const
  {
    for (int x = 0; x < cells; ++x)
    {
      bool any = false;
      for (int corner = 0; corner < 8 && occupied[x] && !any; ++corner)
      {
        const glm::ivec3 at =
          glm::min(glm::ivec3(x, y, z) + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1),
            this->N - 1);
        any = this->Grid.GetValues()[this->Grid.GetIndex(at.x, at.y, at.z)] > 0;
      }
      occupied[x] = any;
    }
  }

  void TestRanges(int y, int z, int cells, std::vector<unsigned char>& occupied,
    std::vector<double>& scratch) const
  {
    const int nx = this->N.x;
    scratch.resize(3 * nx);
    double *row = scratch.data(), *least = row + nx, *largest = least + nx;
    for (int r = 0; r < 4; ++r)
    {
      this->Rows->Read(
        std::min(y + (r & 1), this->N.y - 1), std::min(z + (r >> 1), this->N.z - 1), row);
      for (int x = 0; x < nx; ++x)
      {
        least[x] = r == 0 ? row[x] : std::min(least[x], row[x]);
        largest[x] = r == 0 ? row[x] : std::max(largest[x], row[x]);
      }
    }
    for (int x = 0; x < cells; ++x)
    {
      const int next = std::min(x + 1, nx - 1);
      const glm::dvec2 range(std::min(least[x], least[next]), std::max(largest[x], largest[next]));
      occupied[x] = occupied[x] && this->Bounds.Evaluate(range).y > 0;
    }
  }

  const vtkMediumExtinctionGrid& Grid;
  const vtkMediumBricks& Bricks;
  glm::ivec3 N;
  bool ByValue = false;
  vtkMediumCoefficientBounds Bounds;
  std::unique_ptr<vtkMediumLatticeRows> Rows;
};

//------------------------------------------------------------------------------
// One line of the squared distance transform: values[i] becomes the least of values[q] + (i - q)^2.
void TransformLine(float* values, std::ptrdiff_t stride, int n, std::vector<float>& line,
  std::vector<int>& apex, std::vector<float>& border)
{
  int last = -1;
  for (int q = 0; q < n; ++q)
  {
    line[q] = values[q * stride];
    if (line[q] >= Far)
    {
      continue;
    }
    float from = -Far;
    while (last >= 0)
    {
      const int v = apex[last];
      from = 0.5f * ((line[q] - line[v]) / (q - v) + (q + v));
      if (from > border[last])
      {
        break;
      }
      --last;
    }
    ++last;
    apex[last] = q;
    border[last] = last == 0 ? -Far : from;
  }
  if (last < 0)
  {
    return;
  }
  border[last + 1] = Far;
  for (int i = 0, k = 0; i < n; ++i)
  {
    while (border[k + 1] < i)
    {
      ++k;
    }
    const float way = static_cast<float>(i - apex[k]);
    values[i * stride] = line[apex[k]] + way * way;
  }
}

//------------------------------------------------------------------------------
// Lines along y or z are taken 16 at a time, so that a cache line is fetched once and not 16 times.
void TransformAxis(std::vector<float>& values, const glm::ivec3& n, int axis)
{
  constexpr int Lines = 16;
  const std::ptrdiff_t strides[3] = { 1, n.x, static_cast<std::ptrdiff_t>(n.x) * n.y };
  const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  const int blocks = (n[a] + Lines - 1) / Lines;
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks) * n[b], [&](vtkIdType begin, vtkIdType end) {
    std::vector<float> line(n[axis]), border(n[axis] + 2), block(n[axis] * Lines);
    std::vector<int> apex(n[axis] + 1);
    for (vtkIdType job = begin; job < end; ++job)
    {
      const int from = Lines * static_cast<int>(job % blocks), count = std::min(Lines, n[a] - from);
      float* first = values.data() + from * strides[a] + (job / blocks) * strides[b];
      for (int i = 0; i < n[axis]; ++i)
      {
        for (int l = 0; l < count; ++l)
        {
          block[i * Lines + l] = first[i * strides[axis] + l * strides[a]];
        }
      }
      for (int l = 0; l < count; ++l)
      {
        TransformLine(block.data() + l, Lines, n[axis], line, apex, border);
      }
      for (int i = 0; i < n[axis]; ++i)
      {
        for (int l = 0; l < count; ++l)
        {
          first[i * strides[axis] + l * strides[a]] = block[i * Lines + l];
        }
      }
    }
  });
}
}

//------------------------------------------------------------------------------
void vtkMediumEmptyDistance::Build(
  const vtkMediumScene& scene, const vtkMediumExtinctionGrid& grid, const vtkMediumBricks& bricks)
{
  const glm::ivec3 n = grid.GetDimensions();
  const CellTest test(scene, grid, bricks);
  const int cellsY = std::max(n.y - 1, 1), cellsZ = std::max(n.z - 1, 1);
  this->Values.resize(grid.GetValues().size());

  // A lattice point is at distance 0 if a cell around it may hold medium.
  vtkSMPTools::For(0, n.z, [&](vtkIdType begin, vtkIdType end) {
    std::vector<unsigned char> occupied(n.x);
    std::vector<double> scratch;
    for (int z = static_cast<int>(begin); z < end; ++z)
    {
      float* slice = this->Values.data() + grid.GetIndex(0, 0, z);
      std::fill(slice, slice + static_cast<std::size_t>(n.x) * n.y, Far);
      for (int cz = std::max(z - 1, 0); cz <= std::min(z, cellsZ - 1); ++cz)
      {
        for (int cy = 0; cy < cellsY; ++cy)
        {
          std::fill(occupied.begin(), occupied.end(), 0);
          test.Test(cy, cz, occupied, scratch);
          for (int y = cy; y <= std::min(cy + 1, n.y - 1); ++y)
          {
            for (int x = 0; x < n.x; ++x)
            {
              const bool near = occupied[x] || (x > 0 && occupied[x - 1]);
              slice[static_cast<std::size_t>(y) * n.x + x] =
                near ? 0 : slice[static_cast<std::size_t>(y) * n.x + x];
            }
          }
        }
      }
    }
  });
  for (int axis = 0; axis < 3; ++axis)
  {
    TransformAxis(this->Values, n, axis);
  }

  std::atomic<bool> leaps{ false };
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(this->Values.size()), [&](vtkIdType begin, vtkIdType end) {
      bool any = false;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const float distance = std::min(std::sqrt(this->Values[i]), Maximum);
        const float value = distance * (1 - 1.0f / 1024) - 0.8661f; // just over sqrt(3)/2
        this->Values[i] = std::max(value, 0.0f);
        any = any || value > 0;
      }
      if (any)
      {
        leaps = true;
      }
    });
  this->Leaps = leaps;
}
