// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumReferenceContent.h"

#include <algorithm>
#include <limits>

namespace
{
using Coefficient = vtkMediumScene::Coefficient;

//------------------------------------------------------------------------------
bool IsFunction(const Coefficient& coefficient)
{
  return coefficient.Source == Coefficient::FunctionRGB ||
    coefficient.Source == Coefficient::FunctionAlpha;
}

//------------------------------------------------------------------------------
// Enters a field in the list of those that are read, and counts it by that list.
void UseField(std::vector<int>& fields, int& field)
{
  const auto found = std::find(fields.begin(), fields.end(), field);
  const int index = static_cast<int>(found - fields.begin());
  if (found == fields.end())
  {
    fields.push_back(field);
  }
  field = index;
}

//------------------------------------------------------------------------------
void UseField(std::vector<int>& fields, Coefficient& coefficient)
{
  if (!coefficient.IsConstant())
  {
    UseField(fields, coefficient.FieldIndex);
  }
}
}

//------------------------------------------------------------------------------
bool vtkMediumBoxRay::Clip(double& begin, double& end) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = this->Origin[axis], direction = this->Direction[axis];
    if (direction == 0)
    {
      if (origin < 0 || origin > 1)
      {
        return false;
      }
      continue;
    }
    const double face0 = -origin / direction, face1 = (1 - origin) / direction;
    begin = std::max(begin, std::min(face0, face1));
    end = std::min(end, std::max(face0, face1));
  }
  return begin < end;
}

//------------------------------------------------------------------------------
void vtkMediumReferenceContent::Update(const vtkMediumScene& scene)
{
  vtkMediumScene::Medium& medium = this->Medium;
  medium = scene.Content;
  std::vector<int> fields;
  UseField(fields, medium.Extinction);
  this->ExtinctionCubic = !IsFunction(medium.Extinction);
  if (medium.ExtinctionIsAbsorption)
  {
    UseField(fields, medium.Scattering);
    this->ExtinctionCubic = this->ExtinctionCubic && !IsFunction(medium.Scattering) &&
      (!medium.ScatteringIsAlbedo || medium.Scattering.IsConstant());
  }
  for (int& mask : medium.Masks) // constant in a voxel: what is cubic stays so
  {
    UseField(fields, mask);
  }
  this->ExtinctionFields = static_cast<int>(fields.size());
  if (!medium.ExtinctionIsAbsorption)
  {
    UseField(fields, medium.Scattering);
  }
  UseField(fields, medium.Emission);
  UseField(fields, medium.Anisotropy);

  this->Values.resize(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    if (!this->Values[i])
    {
      this->Values[i] = std::make_unique<vtkMediumLatticeValues>();
    }
    this->Values[i]->Update(medium.Fields[fields[i]]);
  }
  this->Functions.clear();
  this->FacetError = 0;
  for (const vtkMediumFunction& function : medium.Functions)
  {
    this->Functions.emplace_back(function);
    this->FacetError = std::max(this->FacetError, this->Functions.back().GetFacetError());
  }
}

//------------------------------------------------------------------------------
int vtkMediumReferenceContent::GetGreyComponent(const Coefficient& coefficient) const
{
  if (coefficient.Source != Coefficient::Field)
  {
    return coefficient.Source == Coefficient::FunctionAlpha ? 0 : -1;
  }
  const bool oneValue = this->Values[coefficient.FieldIndex]->GetComponents() < 3;
  return oneValue ? std::max(coefficient.Component, 0) : coefficient.Component;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumReferenceContent::EvaluateCoefficient(
  const Coefficient& coefficient, const glm::dvec4* fields) const
{
  if (coefficient.IsConstant())
  {
    return coefficient.Scale;
  }
  const glm::dvec4& field = fields[coefficient.FieldIndex];
  if (IsFunction(coefficient))
  {
    const glm::dvec4 value = this->Functions[coefficient.FunctionIndex].Evaluate(field.x);
    return coefficient.Scale *
      (coefficient.Source == Coefficient::FunctionRGB ? glm::dvec3(value) : glm::dvec3(value.w));
  }
  const int component = this->GetGreyComponent(coefficient);
  return coefficient.Scale * (component < 0 ? glm::dvec3(field) : glm::dvec3(field[component]));
}

//------------------------------------------------------------------------------
double vtkMediumReferenceContent::EvaluateDensity(const glm::dvec4* fields) const
{
  double density = this->Medium.DensityScale;
  for (int mask : this->Medium.Masks)
  {
    density *= fields[mask].x;
  }
  return density;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumReferenceContent::EvaluateExtinction(
  const glm::dvec4* fields, glm::dvec3& scattering) const
{
  const double density = this->EvaluateDensity(fields);
  glm::dvec3 extinction = density * this->EvaluateCoefficient(this->Medium.Extinction, fields);
  scattering = this->EvaluateCoefficient(this->Medium.Scattering, fields);
  if (!this->Medium.ScatteringIsAlbedo)
  {
    scattering *= density;
    extinction += this->Medium.ExtinctionIsAbsorption ? scattering : glm::dvec3(0);
    return extinction;
  }
  if (this->Medium.ExtinctionIsAbsorption) // sigma_a = (1 - albedo) sigma_t
  {
    extinction /= 1.0 - scattering;
  }
  scattering *= extinction;
  return extinction;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumReferenceContent::EvaluateExtinction(const glm::dvec4* fields) const
{
  if (!this->Medium.ExtinctionIsAbsorption)
  {
    return this->EvaluateDensity(fields) *
      this->EvaluateCoefficient(this->Medium.Extinction, fields);
  }
  glm::dvec3 scattering;
  return this->EvaluateExtinction(fields, scattering);
}

//------------------------------------------------------------------------------
vtkMediumScene::Coefficients vtkMediumReferenceContent::Evaluate(const glm::dvec4* fields) const
{
  vtkMediumScene::Coefficients result;
  result.Extinction = this->EvaluateExtinction(fields, result.Scattering);
  result.Emission =
    this->EvaluateDensity(fields) * this->EvaluateCoefficient(this->Medium.Emission, fields);
  result.Anisotropy = this->EvaluateCoefficient(this->Medium.Anisotropy, fields).x;
  return result;
}

//------------------------------------------------------------------------------
vtkMediumRayCells::vtkMediumRayCells(const vtkMediumReferenceContent& content, int fields,
  const vtkMediumBoxRay& ray, double begin, double end)
  : Content(content)
  , Begin(begin)
  , End(begin)
  , Last(end)
{
  for (; this->Count < fields; ++this->Count)
  {
    const vtkMediumLatticeValues& values = content.GetValues(this->Count);
    Field& field = this->Fields[this->Count];
    field.Components = values.GetComponents();
    field.Linear = values.GetLattice().Linear;
    field.Walk = vtkMediumCellWalk(values.GetLattice(), ray.Origin, ray.Direction, begin);
  }
}

//------------------------------------------------------------------------------
bool vtkMediumRayCells::Next()
{
  this->Begin = this->End;
  if (!(this->Begin < this->Last))
  {
    return false;
  }
  this->End = this->Last;
  for (int i = 0; i < this->Count; ++i)
  {
    this->Fields[i].Walk.Advance(this->Begin);
    this->End = std::min(this->End, this->Fields[i].Walk.GetExit());
  }
  for (int i = 0; i < this->Count; ++i)
  {
    Field& field = this->Fields[i];
    const vtkMediumLatticeValues& values = this->Content.GetValues(i);
    for (int c = 0; c < field.Components; ++c)
    {
      values.GetCorners(field.Walk.GetCell(), c, field.Corners[c]);
    }
    field.Fraction = field.Walk.GetFraction();
  }
  return true;
}

//------------------------------------------------------------------------------
double vtkMediumRayCells::InterpolateComponent(const Field& field, int component, double t) const
{
  return field.Linear
    ? vtkMediumTrilinear(field.Corners[component], field.Fraction + t * field.Walk.GetSlope())
    : field.Corners[component][0];
}

//------------------------------------------------------------------------------
void vtkMediumRayCells::Interpolate(double t, glm::dvec4* values) const
{
  for (int i = 0; i < this->Count; ++i)
  {
    const Field& field = this->Fields[i];
    for (int c = 0; c < field.Components; ++c)
    {
      values[i][c] = this->InterpolateComponent(field, c, t);
    }
  }
}

//------------------------------------------------------------------------------
vtkMediumScene::Coefficients vtkMediumRayCells::Evaluate(double t) const
{
  glm::dvec4 values[MaximumFields];
  this->Interpolate(t, values);
  return this->Content.Evaluate(values);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumRayCells::EvaluateExtinction(double t) const
{
  glm::dvec4 values[MaximumFields];
  this->Interpolate(t, values);
  return this->Content.EvaluateExtinction(values);
}

//------------------------------------------------------------------------------
void vtkMediumRayCells::AppendKinks(std::vector<double>& cuts) const
{
  const vtkMediumScene::Medium& medium = this->Content.GetMedium();
  for (const Coefficient* coefficient :
    { &medium.Extinction, &medium.Scattering, &medium.Emission, &medium.Anisotropy })
  {
    if (!IsFunction(*coefficient))
    {
      continue;
    }
    for (int i = 0; i < this->Count; ++i)
    {
      const Field& field = this->Fields[i];
      if (i != coefficient->FieldIndex || !field.Linear)
      {
        continue;
      }
      const auto& kinks = this->Content.GetFunction(coefficient->FunctionIndex).GetKinks();
      const auto range = std::minmax_element(field.Corners[0], field.Corners[0] + 8);
      const auto first = std::upper_bound(kinks.begin(), kinks.end(), *range.first);
      if (first == kinks.end() || *first >= *range.second)
      {
        continue;
      }
      const double third = (this->End - this->Begin) / 3;
      const vtkMediumCubic cubic({ this->InterpolateComponent(field, 0, this->Begin),
        this->InterpolateComponent(field, 0, this->Begin + third),
        this->InterpolateComponent(field, 0, this->End - third),
        this->InterpolateComponent(field, 0, this->End) });
      cubic.AppendCrossings(kinks, this->Begin, this->End - this->Begin, cuts);
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumRayCells::OpticalDepth(
  double begin, double u0, double u1, double tolerance, double length) const
{
  const auto extinction = [&](double u) { return this->EvaluateExtinction(begin + u); };
  if (this->Content.IsExtinctionCubic())
  {
    return length * vtkMediumGaussLegendre<2>::Integrate(u0, u1, extinction);
  }
  const vtkMediumAgreement agreement{ tolerance / length,
    std::max(this->Content.GetFacetError(), 1e-14) };
  return length * vtkMediumIntegrate(u0, u1, extinction, agreement, 40);
}
