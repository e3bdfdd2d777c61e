// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumExtinctionGrid.h"

#include "vtkMediumExtinctionProjection.h"
#include "vtkMediumLatticeRows.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Coefficient = vtkMediumScene::Coefficient;

// How a coefficient enters the extinction.
enum Operations
{
  Set,
  Add,
  MultiplyByOnePlus,
};

// A function that stays within this part of its range from the chord counts as affine; it is below
// what half floats resolve.
constexpr double AffineTolerance = 1e-5;

//------------------------------------------------------------------------------
float Combine(Operations operation, float old, double value)
{
  switch (operation)
  {
    case Add:
      return static_cast<float>(old + value);
    case MultiplyByOnePlus:
      return static_cast<float>(old * (1 + value));
    default:
      return static_cast<float>(value);
  }
}

//------------------------------------------------------------------------------
bool SameLattice(const vtkMediumField& field, const vtkMediumExtinctionGrid& grid)
{
  return field.Dimensions == grid.GetDimensions() && field.OnCells == grid.IsOnCells() &&
    field.Linear == grid.IsLinear();
}

//------------------------------------------------------------------------------
int ComponentOf(const Coefficient& coefficient, const vtkMediumField& field, int channel)
{
  if (coefficient.Source != Coefficient::Field)
  {
    return 0;
  }
  return coefficient.Component >= 0 ? coefficient.Component : field.Components < 3 ? 0 : channel;
}

//------------------------------------------------------------------------------
// One number of a coefficient from the scalar it depends on.
class Curve
{
public:
  Curve(const vtkMediumScene::Medium& medium, const Coefficient& coefficient, int channel)
    : Scale(coefficient.Scale[channel])
  {
    if (coefficient.Source == Coefficient::FunctionRGB ||
      coefficient.Source == Coefficient::FunctionAlpha)
    {
      this->Function = &medium.Functions[coefficient.FunctionIndex];
      this->Channel = coefficient.Source == Coefficient::FunctionRGB ? channel : 3;
    }
  }

  double operator()(double scalar) const
  {
    return this->Scale *
      (this->Function ? this->Function->Evaluate(scalar)[this->Channel] : scalar);
  }

  bool IsAffine(double minimum, double maximum) const
  {
    if (!this->Function)
    {
      return true;
    }
    const double first = (*this)(minimum), last = (*this)(maximum);
    const int samples = 2 * static_cast<int>(this->Function->GetSamples().size());
    double deviation = 0, largest = std::max(std::abs(first), std::abs(last));
    for (int i = 1; i < samples; ++i)
    {
      const double f = static_cast<double>(i) / samples;
      const double value = (*this)(minimum + f * (maximum - minimum));
      deviation = std::max(deviation, std::abs(value - (first + f * (last - first))));
      largest = std::max(largest, std::abs(value));
    }
    return deviation <= AffineTolerance * largest;
  }

private:
  double Scale;
  const vtkMediumFunction* Function = nullptr;
  int Channel = 0;
};

//------------------------------------------------------------------------------
void ApplyConstant(std::vector<float>& values, double value, Operations operation)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(values.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      values[i] = Combine(operation, values[i], value);
    }
  });
}

//------------------------------------------------------------------------------
// Calls body(row, target) for each row of a field, where target is the row's place in the values.
template <typename Body>
void ForEachRow(
  const vtkMediumField& field, int component, std::vector<float>& values, const Body& body)
{
  const vtkMediumLatticeRows rows(field, component);
  const glm::ivec3 n = field.Dimensions;
  vtkSMPTools::For(0, static_cast<vtkIdType>(n.y) * n.z, [&](vtkIdType begin, vtkIdType end) {
    std::vector<double> row(n.x);
    for (vtkIdType r = begin; r < end; ++r)
    {
      rows.Read(static_cast<int>(r % n.y), static_cast<int>(r / n.y), row.data());
      body(row, values.data() + r * n.x);
    }
  });
}

//------------------------------------------------------------------------------
void ApplyRows(const vtkMediumField& field, int component, const Curve& curve, double scale,
  Operations operation, std::vector<float>& values)
{
  ForEachRow(field, component, values, [&](const std::vector<double>& row, float* target) {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      target[i] = Combine(operation, target[i], scale * curve(row[i]));
    }
  });
}

//------------------------------------------------------------------------------
// As parts of the field's range, which a float may not hold, nor tell its ends apart.
void ReadParts(const vtkMediumField& field, int component, std::vector<float>& values)
{
  const double range = field.Maximum - field.Minimum;
  ForEachRow(field, component, values, [&](const std::vector<double>& row, float* target) {
    std::transform(row.begin(), row.end(), target, [&](double value) {
      return range > 0 ? static_cast<float>((value - field.Minimum) / range) : 0.0f;
    });
  });
}

//------------------------------------------------------------------------------
// For a field on another lattice than the grid's.
void ApplyResampled(const vtkMediumField& field, int component, const Curve& curve, double scale,
  Operations operation, const vtkMediumExtinctionGrid& grid, std::vector<float>& values)
{
  const glm::ivec3 n = grid.GetDimensions();
  const glm::dvec3 lower = grid.GetLower(), size = grid.GetUpper() - lower;
  vtkSMPTools::For(0, static_cast<vtkIdType>(n.y) * n.z, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType r = begin; r < end; ++r)
    {
      float* target = values.data() + r * n.x;
      for (int i = 0; i < n.x; ++i)
      {
        const glm::dvec3 at(i, static_cast<int>(r % n.y), static_cast<int>(r / n.y));
        const double scalar = field.Interpolate((at - lower) / size)[component];
        target[i] = Combine(operation, target[i], scale * curve(scalar));
      }
    }
  });
}
}

//------------------------------------------------------------------------------
void vtkMediumExtinctionGrid::ChooseLattice(const vtkMediumScene& scene)
{
  const vtkMediumScene::Medium& medium = scene.Content;
  const vtkMediumField* chosen = nullptr;
  for (const Coefficient* coefficient : { &medium.Extinction, &medium.Scattering })
  {
    const bool used = coefficient == &medium.Extinction || medium.ExtinctionIsAbsorption;
    if (!used || coefficient->IsConstant())
    {
      continue;
    }
    const vtkMediumField& field = medium.Fields[coefficient->FieldIndex];
    if (!chosen ||
      glm::dvec3(field.Dimensions).x * field.Dimensions.y * field.Dimensions.z >
        glm::dvec3(chosen->Dimensions).x * chosen->Dimensions.y * chosen->Dimensions.z)
    {
      chosen = &field;
    }
  }
  this->Dimensions = chosen ? chosen->Dimensions : glm::ivec3(2);
  this->OnCells = chosen && chosen->OnCells;
  this->Linear = !chosen || chosen->Linear;

  const vtkMediumScene::Box& box = scene.Geometry;
  const glm::dvec3 size = this->GetUpper() - this->GetLower();
  for (int axis = 0; axis < 3; ++axis)
  {
    this->LatticeToLocalAxes[axis] = box.BoxToLocalAxes[axis] / size[axis];
  }
  this->LatticeToLocalOrigin = box.BoxToLocalOrigin - this->LatticeToLocalAxes * this->GetLower();
  this->LocalToLatticeAxes = glm::inverse(this->LatticeToLocalAxes);
}

//------------------------------------------------------------------------------
void vtkMediumExtinctionGrid::Build(const vtkMediumScene& scene, int channel)
{
  const vtkMediumScene::Medium& medium = scene.Content;
  this->ChooseLattice(scene);
  this->Affine = true;
  this->Values.resize(this->GetIndex(0, 0, this->Dimensions.z));

  auto apply = [&](const Coefficient& coefficient, double scale, Operations operation) {
    if (coefficient.IsConstant())
    {
      ApplyConstant(this->Values, scale * coefficient.Scale[channel], operation);
      return;
    }
    const vtkMediumField& field = medium.Fields[coefficient.FieldIndex];
    const Curve curve(medium, coefficient, channel);
    const int component = ComponentOf(coefficient, field, channel);
    const bool same = SameLattice(field, *this);
    this->Affine = this->Affine && same &&
      (!this->Linear || curve.IsAffine(field.Minimum, field.Maximum)) &&
      !(operation == MultiplyByOnePlus && this->Linear);
    if (same)
    {
      ApplyRows(field, component, curve, scale, operation, this->Values);
    }
    else
    {
      ApplyResampled(field, component, curve, scale, operation, *this, this->Values);
    }
  };
  apply(medium.Extinction, scene.Geometry.Length, Set);
  if (medium.ExtinctionIsAbsorption && medium.ScatteringIsAlbedo)
  {
    apply(medium.Scattering, 1, MultiplyByOnePlus);
  }
  else if (medium.ExtinctionIsAbsorption)
  {
    apply(medium.Scattering, scene.Geometry.Length, Add);
  }
  if (this->Linear && !this->Affine && !medium.ExtinctionIsAbsorption)
  {
    this->Project(scene, channel);
  }
  this->FindStatistics();
}

//------------------------------------------------------------------------------
void vtkMediumExtinctionGrid::Project(const vtkMediumScene& scene, int channel)
{
  const Coefficient& coefficient = scene.Content.Extinction;
  const vtkMediumField& field = scene.Content.Fields[coefficient.FieldIndex];
  std::vector<float> scalars(this->Values.size());
  ReadParts(field, ComponentOf(coefficient, field, channel), scalars);
  const Curve curve(scene.Content, coefficient, channel);
  const double length = scene.Geometry.Length;
  const vtkMediumExtinctionProjection projection(0, 1, [&](double part) {
    return length * curve(field.Minimum + part * (field.Maximum - field.Minimum));
  });
  projection.Apply(this->Dimensions, scalars, this->Values);
}

//------------------------------------------------------------------------------
glm::ivec2 vtkMediumExtinctionGrid::FindOccupied(const float* row, int n)
{
  glm::ivec2 occupied(0, n);
  while (occupied.y > 0 && row[occupied.y - 1] == 0)
  {
    --occupied.y;
  }
  while (occupied.x < occupied.y && row[occupied.x] == 0)
  {
    ++occupied.x;
  }
  return occupied;
}

//------------------------------------------------------------------------------
void vtkMediumExtinctionGrid::FindStatistics()
{
  struct Share
  {
    float Minimum = std::numeric_limits<float>::infinity();
    float Maximum = -std::numeric_limits<float>::infinity();
    vtkIdType Occupied = 0;
    glm::ivec3 First{ std::numeric_limits<int>::max() }, Last{ -1 };
  };
  const glm::ivec3 n = this->Dimensions;
  vtkSMPThreadLocal<Share> shares;
  vtkSMPTools::For(0, static_cast<vtkIdType>(n.y) * n.z, [&](vtkIdType begin, vtkIdType end) {
    Share share = shares.Local();
    for (vtkIdType row = begin; row < end; ++row)
    {
      const float* values = this->Values.data() + row * n.x;
      const vtkIdType before = share.Occupied;
      for (int i = 0; i < n.x; ++i)
      {
        share.Minimum = std::min(share.Minimum, values[i]);
        share.Maximum = std::max(share.Maximum, values[i]);
        share.Occupied += values[i] != 0 ? 1 : 0;
      }
      if (share.Occupied > before)
      {
        const glm::ivec2 occupied = FindOccupied(values, n.x);
        const glm::ivec3 at(0, static_cast<int>(row % n.y), static_cast<int>(row / n.y));
        share.First = glm::min(share.First, at + glm::ivec3(occupied.x, 0, 0));
        share.Last = glm::max(share.Last, at + glm::ivec3(occupied.y - 1, 0, 0));
      }
    }
    shares.Local() = share;
  });
  Share all;
  for (const Share& share : shares)
  {
    all.Minimum = std::min(all.Minimum, share.Minimum);
    all.Maximum = std::max(all.Maximum, share.Maximum);
    all.Occupied += share.Occupied;
    all.First = glm::min(all.First, share.First);
    all.Last = glm::max(all.Last, share.Last);
  }
  this->Minimum = all.Minimum;
  this->Maximum = all.Maximum;
  this->OccupiedFraction = static_cast<double>(all.Occupied) / this->Values.size();
  this->OccupiedPart =
    all.Occupied > 0 ? vtkMediumLatticePart{ all.First, all.Last + 1 } : vtkMediumLatticePart();
}

//------------------------------------------------------------------------------
double vtkMediumExtinctionGrid::Interpolate(const glm::dvec3& lattice) const
{
  const glm::dvec3 at = glm::clamp(lattice, glm::dvec3(0), glm::dvec3(this->Dimensions - 1));
  if (!this->Linear)
  {
    const glm::ivec3 nearest(glm::floor(at + 0.5));
    return this->Values[this->GetIndex(nearest.x, nearest.y, nearest.z)];
  }
  const glm::ivec3 lower = glm::min(glm::ivec3(at), glm::max(this->Dimensions - 2, 0));
  const glm::ivec3 upper = glm::min(lower + 1, this->Dimensions - 1);
  const glm::dvec3 f = at - glm::dvec3(lower);
  auto alongX = [&](int j, int k) {
    const std::size_t row = this->GetIndex(0, j, k);
    return glm::mix(double(this->Values[row + lower.x]), double(this->Values[row + upper.x]), f.x);
  };
  return glm::mix(glm::mix(alongX(lower.y, lower.z), alongX(upper.y, lower.z), f.y),
    glm::mix(alongX(lower.y, upper.z), alongX(upper.y, upper.z), f.y), f.z);
}
