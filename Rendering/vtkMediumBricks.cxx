// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumBricks.h"

#include "vtkMediumLatticeRows.h"

#include "vtkSMPTools.h"

#include <glm/common.hpp>

#include <algorithm>

namespace
{
enum Parts
{
  Extinction,
  Scattering,
  Emission,
};

//------------------------------------------------------------------------------
glm::dvec2 Join(const glm::dvec2& a, const glm::dvec2& b)
{
  return { std::min(a.x, b.x), std::max(a.y, b.y) };
}

//------------------------------------------------------------------------------
glm::dvec2 Product(const glm::dvec2& a, const glm::dvec2& b)
{
  const double products[4] = { a.x * b.x, a.x * b.y, a.y * b.x, a.y * b.y };
  return { *std::min_element(products, products + 4), *std::max_element(products, products + 4) };
}
}

//------------------------------------------------------------------------------
void vtkMediumBricks::Build(const vtkMediumScene& scene, const vtkMediumExtinctionGrid& grid)
{
  const vtkMediumScene::Medium& medium = scene.Content;
  const bool moved = this->Dimensions != grid.GetDimensions() ||
    this->OnCells != grid.IsOnCells() || this->Linear != grid.IsLinear();
  this->Dimensions = grid.GetDimensions();
  this->OnCells = grid.IsOnCells();
  this->Linear = grid.IsLinear();
  this->Count = glm::max((this->Dimensions + Edge - 2) / Edge, glm::ivec3(1));
  this->LatticeToLocalAxes = grid.GetLatticeToLocalAxes();
  this->LatticeToLocalOrigin = grid.LatticeToLocal(glm::dvec3(0));

  this->Bounds[Extinction].Build(medium, medium.Extinction);
  this->Bounds[Scattering].Build(
    medium, medium.ExtinctionIsAbsorption ? medium.Scattering : vtkMediumScene::Coefficient());
  this->Bounds[Emission].Build(medium, medium.Emission);
  bool read = false;
  for (int part : { Extinction, Scattering, Emission })
  {
    const vtkMediumCoefficientBounds& bounds = this->Bounds[part];
    ScalarRanges& scalars = this->Scalars[part];
    if (bounds.GetFieldIndex() < 0)
    {
      scalars = ScalarRanges();
      continue;
    }
    const vtkMediumField& field = medium.Fields[bounds.GetFieldIndex()];
    const unsigned long long mTime = field.Array->GetMTime();
    const int first = field.FirstComponent + bounds.GetFirstComponent();
    const int last = field.FirstComponent + bounds.GetLastComponent();
    if (moved || scalars.Array != field.Array.Get() || scalars.MTime != mTime ||
      scalars.FirstComponent != first || scalars.LastComponent != last)
    {
      scalars = ScalarRanges{ field.Array.Get(), mTime, first, last, {} };
      const bool same = field.Dimensions == this->Dimensions && field.OnCells == this->OnCells &&
        field.Linear == this->Linear;
      this->ReadRanges(scalars, field, same);
      read = true;
    }
  }
  this->Reads += read ? 1 : 0;
  this->Classify(scene);
}

//------------------------------------------------------------------------------
void vtkMediumBricks::ReadRanges(
  ScalarRanges& scalars, const vtkMediumField& field, bool sameLattice) const
{
  if (!sameLattice)
  {
    scalars.Ranges.assign(1, glm::dvec2(field.Minimum, field.Maximum));
    return;
  }
  const glm::ivec3 n = this->Dimensions, count = this->Count;
  const glm::dvec2 nothing(field.Maximum, field.Minimum);
  scalars.Ranges.assign(static_cast<std::size_t>(count.x) * count.y * count.z, nothing);
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(count.y) * count.z, [&](vtkIdType begin, vtkIdType end) {
      std::vector<double> row(n.x);
      for (vtkIdType line = begin; line < end; ++line)
      {
        const int j = Edge * static_cast<int>(line % count.y);
        const int k = Edge * static_cast<int>(line / count.y);
        glm::dvec2* ranges = scalars.Ranges.data() + line * count.x;
        for (int component = scalars.FirstComponent; component <= scalars.LastComponent;
             ++component)
        {
          const vtkMediumLatticeRows rows(field, component - field.FirstComponent);
          for (int z = k; z <= std::min(k + Edge, n.z - 1); ++z)
          {
            for (int y = j; y <= std::min(j + Edge, n.y - 1); ++y)
            {
              rows.Read(y, z, row.data());
              for (int bx = 0; bx < count.x; ++bx)
              {
                const auto first = row.begin() + Edge * bx;
                const auto last = row.begin() + std::min(Edge * bx + Edge, n.x - 1) + 1;
                double least = *first, largest = *first;
                for (auto value = first + 1; value != last; ++value)
                {
                  least = std::min(least, *value);
                  largest = std::max(largest, *value);
                }
                ranges[bx] = Join(ranges[bx], glm::dvec2(least, largest));
              }
            }
          }
        }
      }
    });
}

//------------------------------------------------------------------------------
void vtkMediumBricks::Classify(const vtkMediumScene& scene)
{
  const vtkMediumScene::Medium& medium = scene.Content;
  const std::size_t count = static_cast<std::size_t>(this->Count.x) * this->Count.y * this->Count.z;
  this->Ranges.resize(count);
  this->Class.resize(count);
  std::fill(this->Numbers, this->Numbers + 3, 0);
  for (std::size_t brick = 0; brick < count; ++brick)
  {
    glm::dvec2 range[3];
    for (int part : { Extinction, Scattering, Emission })
    {
      const std::vector<glm::dvec2>& scalars = this->Scalars[part].Ranges;
      range[part] = this->Bounds[part].Evaluate(
        scalars.empty() ? glm::dvec2(0) : scalars[scalars.size() > 1 ? brick : 0]);
    }
    glm::dvec2 extinction = range[Extinction];
    if (medium.ExtinctionIsAbsorption)
    {
      extinction = medium.ScatteringIsAlbedo ? Product(extinction, 1.0 + range[Scattering])
                                             : extinction + range[Scattering];
    }
    const bool empty = extinction.y <= 0 && range[Emission].y <= 0;
    const bool uniform = extinction.x == extinction.y && range[Emission].x == range[Emission].y;
    this->Class[brick] = empty ? Empty : uniform ? Uniform : Mixed;
    this->Ranges[brick] = glm::vec2(extinction * scene.Geometry.Length);
    ++this->Numbers[this->Class[brick]];
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumBricks::GetLower(const glm::ivec3& brick) const
{
  glm::dvec3 lower(brick * Edge);
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis] -= this->OnCells && brick[axis] == 0 ? 0.5 : 0;
  }
  return lower;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumBricks::GetUpper(const glm::ivec3& brick) const
{
  glm::dvec3 upper;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool last = brick[axis] == this->Count[axis] - 1;
    upper[axis] =
      last ? this->Dimensions[axis] - (this->OnCells ? 0.5 : 1) : (brick[axis] + 1) * Edge;
  }
  return upper;
}
