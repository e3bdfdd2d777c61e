// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumContent.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkParticipatingMedium.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace
{
using Coefficient = vtkMediumScene::Coefficient;
using Source = vtkParticipatingMedium::Source;

/// What a coefficient must be.
struct Law
{
  const char* Name;
  double Minimum;
  double Maximum;
  bool ReadsLast;    ///< of 2 or 4 components the last, as an opacity does
  bool MayBeColor;   ///< grey or RGB, else one value
  const char* Range; ///< in words
};

constexpr double Unbounded = std::numeric_limits<double>::max();
const Law Extinction = { "Extinction", 0, Unbounded, true, true, "finite values >= 0" };
const Law Absorption = { "Absorption", 0, Unbounded, true, true, "finite values >= 0" };
const Law Scattering = { "Scattering", 0, Unbounded, false, true, "finite values >= 0" };
const Law Emission = { "Emission", 0, Unbounded, false, true, "finite values >= 0" };
const Law Albedo = { "Albedo", 0, 1 + vtkMediumAlbedoTolerance, false, true, "values from 0 to 1" };
const Law Anisotropy = { "Anisotropy", -1, 1, false, false,
  "values from -1 to 1 (beyond +-0.999 they are taken as +-0.999)" };

//------------------------------------------------------------------------------
bool IsWithin(const Law& law, double value)
{
  return std::isfinite(value) && value >= law.Minimum && value <= law.Maximum;
}

//------------------------------------------------------------------------------
// "" or that the smallest or the largest of some values breaks the law.
std::string CheckRange(const Law& law, const std::string& what, double minimum, double maximum)
{
  const bool low = !IsWithin(law, minimum);
  if (!low && IsWithin(law, maximum))
  {
    return {};
  }
  std::ostringstream problem;
  problem << "The medium's " << law.Name << what << " has the value " << (low ? minimum : maximum)
          << "; give it " << law.Range << ".";
  return problem.str();
}

//------------------------------------------------------------------------------
/// Turns the sources of a medium into coefficients, with one field for each array, and one table
/// for two functions of the same field where one fills the colour and the other the alpha channel.
struct Lowering
{
  vtkMediumScene::Medium& Content;
  std::vector<vtkMediumScene::ColorTable>& ColorTables;
  vtkImageData* Input;
  vtkDataArray* Scalars;
  bool OnCells;
  vtkVolumeProperty* Property;

  struct Table
  {
    int Field;
    bool HasColor, HasAlpha;
    std::vector<double> Knots;
  };
  std::vector<Table> Tables; ///< of Content.Functions

  std::string Lower(Coefficient& result, const Law& law, const Source& source);
  std::string LowerField(Coefficient& result, const Law& law, const Source& source);
  std::string LowerFunction(Coefficient& result, const Law& law, const Source& source);
  std::string FindArray(const Law& law, const Source& source, vtkDataArray*& array, bool& onCells);
  std::string FindField(vtkDataArray* array, bool onCells, int first, int components, int& index);
  int FindTable(int field, bool alpha);
};

//------------------------------------------------------------------------------
std::string Quoted(vtkDataArray* array)
{
  return array->GetName() ? " array \"" + std::string(array->GetName()) + "\"" : " array";
}

//------------------------------------------------------------------------------
std::string ListArrays(vtkImageData* input)
{
  std::ostringstream list;
  vtkDataSetAttributes* const attributes[2] = { input->GetPointData(), input->GetCellData() };
  for (int i = 0; i < 2; ++i)
  {
    list << (i == 0 ? "point arrays:" : "; cell arrays:");
    int count = 0;
    for (int j = 0; j < attributes[i]->GetNumberOfArrays(); ++j)
    {
      vtkDataArray* array = attributes[i]->GetArray(j);
      if (array && array->GetName())
      {
        list << (count++ ? ", \"" : " \"") << array->GetName() << "\"";
      }
    }
    list << (count ? "" : " none");
  }
  return list.str();
}

//------------------------------------------------------------------------------
std::string Lowering::FindArray(
  const Law& law, const Source& source, vtkDataArray*& array, bool& onCells)
{
  array = this->Scalars;
  onCells = this->OnCells;
  std::ostringstream problem;
  if (!source.ArrayName.empty())
  {
    array = this->Input->GetPointData()->GetArray(source.ArrayName.c_str());
    onCells = array == nullptr;
    if (onCells)
    {
      array = this->Input->GetCellData()->GetArray(source.ArrayName.c_str());
    }
  }
  if (!array)
  {
    problem << "The medium's " << law.Name << " is to come from "
            << (source.ArrayName.empty()
                   ? "the scalars, but the image has no active scalars"
                   : "the array \"" + source.ArrayName + "\", which the image does not have")
            << "; it has " << ListArrays(this->Input) << ". Name one of them.";
    return problem.str();
  }
  const int components = array->GetNumberOfComponents();
  if (components < 1 || components > 4)
  {
    problem << "The medium's " << law.Name << Quoted(array) << " has " << components
            << " components; give an array of 1 to 4.";
  }
  else if (source.Component < -1 || source.Component >= components)
  {
    problem << "The medium's " << law.Name << "Component is " << source.Component << ", but its"
            << Quoted(array) << " has " << components << " components; set -1 to " << components - 1
            << ".";
  }
  else if (!law.MayBeColor && source.Component < 0 && components > 1)
  {
    problem << "The medium's " << law.Name << Quoted(array) << " has " << components
            << " components, but it is one value; pick one with Set" << law.Name << "Component.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
std::string Lowering::FindField(
  vtkDataArray* array, bool onCells, int first, int components, int& index)
{
  const auto& fields = this->Content.Fields;
  for (index = 0; index < static_cast<int>(fields.size()); ++index)
  {
    if (fields[index].Array == array && fields[index].OnCells == onCells &&
      fields[index].FirstComponent == first && fields[index].Components == components)
    {
      return {};
    }
  }
  vtkMediumField field;
  field.FirstComponent = first;
  field.Components = components;
  std::string problem = vtkMediumFieldFromArray(field, this->Input, array, onCells, this->Property);
  if (problem.empty())
  {
    this->Content.Fields.push_back(field);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string Lowering::LowerField(Coefficient& result, const Law& law, const Source& source)
{
  vtkDataArray* array = nullptr;
  bool onCells = false;
  std::string problem = this->FindArray(law, source, array, onCells);
  if (!problem.empty())
  {
    return problem;
  }
  const int components = array->GetNumberOfComponents();
  result.Source = Coefficient::Field;
  result.Component = source.Component;
  if (result.Component < 0 && components % 2 == 0)
  {
    result.Component = law.ReadsLast ? components - 1 : components == 2 ? 0 : -1;
  }
  result.Component = components == 1 ? -1 : result.Component;
  problem = this->FindField(array, onCells, 0, components, result.FieldIndex);
  for (int c = 0; c < 3 && problem.empty(); ++c)
  {
    const int read = components == 1 ? 0 : result.Component < 0 ? c : result.Component;
    double range[2];
    array->GetFiniteRange(range, read);
    problem = CheckRange(law, Quoted(array) + " (times its scale)", range[0] * result.Scale[c],
      range[1] * result.Scale[c]);
  }
  return problem;
}

//------------------------------------------------------------------------------
int Lowering::FindTable(int field, bool alpha)
{
  int index = 0;
  for (; index < static_cast<int>(this->Tables.size()); ++index)
  {
    const Table& table = this->Tables[index];
    if (table.Field == field && !(alpha ? table.HasAlpha : table.HasColor))
    {
      return index;
    }
  }
  this->Tables.push_back({ field, false, false, {} });
  this->Content.Functions.emplace_back();
  return index;
}

//------------------------------------------------------------------------------
std::string Lowering::LowerFunction(Coefficient& result, const Law& law, const Source& source)
{
  vtkDataArray* array = nullptr;
  bool onCells = false;
  std::string problem = this->FindArray(law, source, array, onCells);
  if (!problem.empty())
  {
    return problem;
  }
  const int last = array->GetNumberOfComponents() - 1;
  const int component = source.Component >= 0 ? source.Component : law.ReadsLast ? last : 0;
  problem = this->FindField(array, onCells, component, 1, result.FieldIndex);
  if (!problem.empty())
  {
    return problem;
  }

  const bool alpha = !source.ColorFunction && (law.ReadsLast || !law.MayBeColor);
  result.FunctionIndex = this->FindTable(result.FieldIndex, alpha);
  result.Source = alpha ? Coefficient::FunctionAlpha : Coefficient::FunctionRGB;
  Table& table = this->Tables[result.FunctionIndex];
  (alpha ? table.HasAlpha : table.HasColor) = true;
  source.ColorFunction ? vtkMediumAppendKnots(table.Knots, source.ColorFunction)
                       : vtkMediumAppendKnots(table.Knots, source.Function);

  const vtkMediumField& field = this->Content.Fields[result.FieldIndex];
  vtkMediumFunction& function = this->Content.Functions[result.FunctionIndex];
  const vtkMediumFunction other = function;
  std::vector<glm::dvec3> colors;
  if (source.ColorFunction)
  {
    colors =
      vtkMediumSampleColors(this->ColorTables, source.ColorFunction, field.Minimum, field.Maximum);
  }
  std::size_t index = 0; // the values come in ascending order
  std::string invalid;
  function.Sample(field.Minimum, field.Maximum, table.Knots, [&](double value) {
    glm::dvec4 sample = other.GetSamples().empty() ? glm::dvec4(0) : other.Evaluate(value);
    const glm::dvec3 rgb =
      source.ColorFunction ? colors[index++] : glm::dvec3(source.Function->GetValue(value));
    for (int c = 0; c < 3; ++c)
    {
      (alpha ? sample[3] : sample[c]) = rgb[c];
      const double scaled = rgb[c] * result.Scale[c];
      if (invalid.empty() && !IsWithin(law, scaled))
      {
        std::ostringstream where;
        where << " function (times its scale) at " << value;
        invalid = CheckRange(law, where.str(), scaled, scaled);
      }
    }
    return sample;
  });
  return invalid;
}

//------------------------------------------------------------------------------
std::string Lowering::Lower(Coefficient& result, const Law& law, const Source& source)
{
  const bool isFunction = source.Function || source.ColorFunction;
  const auto& scale = source.HasArray || isFunction ? source.Scale : source.Value;
  result = Coefficient();
  result.Scale = glm::dvec3(scale[0], scale[1], scale[2]);
  for (double one : scale)
  {
    if (!source.HasArray && !isFunction)
    {
      const std::string problem = CheckRange(law, "", one, one);
      if (!problem.empty())
      {
        return problem;
      }
    }
    else if (!(one >= 0) || !std::isfinite(one))
    {
      std::ostringstream problem;
      problem << "The medium's " << law.Name << "Scale is (" << scale[0] << ", " << scale[1] << ", "
              << scale[2] << "); set finite values >= 0.";
      return problem.str();
    }
  }
  return isFunction   ? this->LowerFunction(result, law, source)
    : source.HasArray ? this->LowerField(result, law, source)
                      : std::string();
}

//------------------------------------------------------------------------------
std::string CheckUnits(vtkParticipatingMedium* medium)
{
  std::ostringstream problem;
  const double density = medium->GetDensityScale();
  const double unit = medium->GetLengthUnit();
  if (!(density >= 0) || !std::isfinite(density))
  {
    problem << "The medium's DensityScale is " << density << "; set a finite number >= 0.";
  }
  else if (!(unit > 0) || !std::isfinite(unit))
  {
    problem << "The medium's LengthUnit is " << unit
            << "; set the length, in world units, of the unit of the coefficients: finite and > 0.";
  }
  else if (!std::isfinite(density / unit))
  {
    problem << "The medium's DensityScale is " << density << " and its LengthUnit " << unit
            << ", whose quotient is more than a number can say; set a longer unit (SetLengthUnit).";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
bool IsChromatic(const vtkMediumScene::Medium& content, const Coefficient& coefficient)
{
  const bool rgb = coefficient.Source == Coefficient::FunctionRGB ||
    (coefficient.Source == Coefficient::Field && coefficient.Component < 0 &&
      content.Fields[coefficient.FieldIndex].Components >= 3);
  return rgb || coefficient.Scale != glm::dvec3(coefficient.Scale.x);
}

//------------------------------------------------------------------------------
bool HasAnisotropy(vtkMediumScene::Phases phase)
{
  return phase != vtkParticipatingMedium::Isotropic && phase != vtkParticipatingMedium::Rayleigh &&
    phase != vtkParticipatingMedium::Tabulated && phase != vtkParticipatingMedium::Droplets;
}
}

//------------------------------------------------------------------------------
std::string vtkMediumContentFromMedium(vtkMediumScene::Medium& content,
  std::vector<vtkMediumScene::ColorTable>& tables, vtkImageData* input, vtkDataArray* scalars,
  bool onCells, vtkVolumeProperty* property, vtkParticipatingMedium* medium)
{
  using M = vtkParticipatingMedium;
  content.ExtinctionIsAbsorption = medium->GetParametrization() == M::AbsorptionAndScattering;
  content.ScatteringIsAlbedo = !content.ExtinctionIsAbsorption;
  content.DensityScale = medium->GetDensityScale() / medium->GetLengthUnit();

  const bool absorption = content.ExtinctionIsAbsorption;
  Lowering lowering{ content, tables, input, scalars, onCells, property, {} };
  std::string problem = CheckUnits(medium);
  const auto lower = [&](Coefficient& result, const Law& law, M::Coefficients coefficient) {
    if (problem.empty())
    {
      problem = lowering.Lower(result, law, medium->GetSource(coefficient));
    }
  };
  lower(content.Extinction, absorption ? Absorption : Extinction,
    absorption ? M::AbsorptionCoefficient : M::ExtinctionCoefficient);
  lower(content.Scattering, absorption ? Scattering : Albedo,
    absorption ? M::ScatteringCoefficient : M::AlbedoCoefficient);
  lower(content.Emission, Emission, M::EmissionCoefficient);
  if (problem.empty())
  {
    problem = vtkMediumPhaseFromMedium(content, medium);
  }
  if (HasAnisotropy(content.Phase))
  {
    lower(content.Anisotropy, Anisotropy, M::AnisotropyCoefficient);
  }
  content.ChromaticExtinction = problem.empty() &&
    (IsChromatic(content, content.Extinction) ||
      (absorption && IsChromatic(content, content.Scattering)));
  return problem;
}
