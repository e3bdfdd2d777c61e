// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Every bad medium is refused by a message that names the value, and the next good one is accepted.
#include "MediumInput.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{
const double NotANumber = std::numeric_limits<double>::quiet_NaN();
const double Infinite = std::numeric_limits<double>::infinity();

struct BadMedium
{
  const char* Name;
  std::function<void(MediumInput&)> Break;
  std::vector<std::string> Words; ///< that the message must have
};

vtkSmartPointer<vtkDoubleArray> MakeTable(std::initializer_list<double> values)
{
  auto table = vtkSmartPointer<vtkDoubleArray>::New();
  for (double value : values)
  {
    table->InsertNextValue(value);
  }
  return table;
}

void UseTable(MediumInput& input, std::initializer_list<double> values)
{
  input.Medium->SetPhaseFunctionToTabulated();
  input.Medium->SetPhaseTable(MakeTable(values));
}

void UseFunction(MediumInput& input, double y)
{
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0, 0);
  function->AddPoint(26, y);
  input.Medium->SetExtinctionArrayName("ramp");
  input.Medium->SetExtinctionFunction(function);
}

using I = MediumInput;
const BadMedium BadMedia[] = {
  { "NegativeExtinction", [](I& i) { i.Medium->SetExtinction(1, -0.5, 1); },
    { "Extinction", "-0.5", ">= 0" } },
  { "NaNExtinction", [](I& i) { i.Medium->SetExtinction(1, NotANumber, 1); },
    { "Extinction", "nan" } },
  { "InfiniteExtinction", [](I& i) { i.Medium->SetExtinction(Infinite); },
    { "Extinction", "inf" } },
  { "AlbedoAboveOne", [](I& i) { i.Medium->SetAlbedo(1.25); }, { "Albedo", "1.25", "0 to 1" } },
  { "NegativeAlbedo", [](I& i) { i.Medium->SetAlbedo(-0.1); }, { "Albedo", "-0.1" } },
  { "NegativeEmission", [](I& i) { i.Medium->SetEmission(-3); }, { "Emission", "-3" } },
  { "NegativeAbsorption",
    [](I& i) {
      i.Medium->SetParametrizationToAbsorptionAndScattering();
      i.Medium->SetAbsorption(-3);
    },
    { "Absorption", "-3" } },
  { "NegativeScattering",
    [](I& i) {
      i.Medium->SetParametrizationToAbsorptionAndScattering();
      i.Medium->SetScattering(-4);
    },
    { "Scattering", "-4" } },
  { "AnisotropyOutOfRange", [](I& i) { i.Medium->SetAnisotropy(1.5); },
    { "Anisotropy", "1.5", "-1 to 1" } },
  { "NaNAnisotropy", [](I& i) { i.Medium->SetAnisotropy(NotANumber); }, { "Anisotropy", "nan" } },
  { "AnisotropyArrayOutOfRange", [](I& i) { i.Medium->SetAnisotropyArrayName("ramp"); },
    { "Anisotropy", "ramp", "26" } },
  { "MissingArray", [](I& i) { i.Medium->SetExtinctionArrayName("missing"); },
    { "Extinction", "\"missing\"", "\"ramp\"", "\"vector\"", "\"cells\"" } },
  { "NoScalars", [](I& i) { i.Medium->SetExtinctionArrayName(""); },
    { "Extinction", "no active scalars", "\"ramp\"" } },
  { "NegativeArray", [](I& i) { i.Medium->SetExtinctionArrayName("signed"); },
    { "Extinction", "signed", "-13" } },
  { "AlbedoArrayAboveOne", [](I& i) { i.Medium->SetAlbedoArrayName("ramp"); },
    { "Albedo", "ramp", "26" } },
  { "FiveComponents", [](I& i) { i.Medium->SetExtinctionArrayName("five"); },
    { "five", "5 components", "1 to 4" } },
  { "ComponentOutOfRange",
    [](I& i) {
      i.Medium->SetExtinctionArrayName("vector");
      i.Medium->SetExtinctionComponent(3);
    },
    { "ExtinctionComponent", "3", "vector" } },
  { "AnisotropyOfAVector", [](I& i) { i.Medium->SetAnisotropyArrayName("vector"); },
    { "Anisotropy", "vector", "SetAnisotropyComponent" } },
  { "WrongLength",
    [](I& i) {
      i.Image->GetPointData()->GetArray("ramp")->SetNumberOfTuples(9);
      i.Medium->SetExtinctionArrayName("ramp");
    },
    { "ramp", "9 tuples", "27 points" } },
  { "NothingFinite", [](I& i) { i.Medium->SetExtinctionArrayName("nothing"); },
    { "nothing", "no finite value" } },
  { "NegativeScale",
    [](I& i) {
      i.Medium->SetExtinctionArrayName("ramp");
      i.Medium->SetExtinctionScale(-2);
    },
    { "ExtinctionScale", "-2" } },
  { "NegativeFunction", [](I& i) { UseFunction(i, -26); }, { "Extinction", "function", ">= 0" } },
  { "NaNFunction", [](I& i) { UseFunction(i, NotANumber); }, { "Extinction", "function", "nan" } },
  { "NegativeDensityScale", [](I& i) { i.Medium->SetDensityScale(-1); }, { "DensityScale", "-1" } },
  { "NaNDensityScale", [](I& i) { i.Medium->SetDensityScale(NotANumber); },
    { "DensityScale", "nan" } },
  { "ZeroLengthUnit", [](I& i) { i.Medium->SetLengthUnit(0); }, { "LengthUnit", "0" } },
  { "TinyLengthUnit",
    [](I& i) {
      i.Medium->SetDensityScale(1e100);
      i.Medium->SetLengthUnit(1e-250);
    },
    { "LengthUnit", "1e-250", "1e+100" } },
  { "ExtinctionOverflows",
    [](I& i) {
      i.Medium->SetExtinction(1e200);
      i.Medium->SetDensityScale(1e150);
      i.Medium->SetAlbedo(0);
    },
    { "extinction", "inf", "1e+150" } },
  { "EmissionOverflows", [](I& i) { i.Medium->SetEmission(0, 0, 1e300); },
    { "emission", "1e+300" } },
  { "BackAnisotropyOutOfRange",
    [](I& i) {
      i.Medium->SetPhaseFunctionToDoubleHenyeyGreenstein();
      i.Medium->SetBackAnisotropy(-1.5);
    },
    { "BackAnisotropy", "-1.5" } },
  { "WeightOutOfRange",
    [](I& i) {
      i.Medium->SetPhaseFunctionToDoubleHenyeyGreenstein();
      i.Medium->SetForwardWeight(2);
    },
    { "ForwardWeight", "2" } },
  { "NegativeDraineAlpha",
    [](I& i) {
      i.Medium->SetPhaseFunctionToDraine();
      i.Medium->SetDraineAlpha(-1);
    },
    { "DraineAlpha", "-1" } },
  { "DraineAlphaBeyondFloat",
    [](I& i) {
      i.Medium->SetPhaseFunctionToDraine();
      i.Medium->SetDraineAlpha(1e39);
    },
    { "DraineAlpha", "1e+39", "1e+30" } },
  { "DropletTooSmall",
    [](I& i) {
      i.Medium->SetPhaseFunctionToDroplets();
      i.Medium->SetDropletDiameter(1);
    },
    { "DropletDiameter", "5 to 50" } },
  { "NoTable", [](I& i) { i.Medium->SetPhaseFunctionToTabulated(); }, { "PhaseTable", "two" } },
  { "ShortTable", [](I& i) { UseTable(i, { 0.08 }); }, { "PhaseTable", "1 values" } },
  { "TableTooBright",
    [](I& i) {
      UseTable(i, { 0.25, 0.25 });
    },
    { "PhaseTable", "3.14159", "divide" } },
  { "NegativeTable",
    [](I& i) {
      UseTable(i, { 0.3, -0.1, 0.1 });
    },
    { "PhaseTable", "-0.1" } },
  { "NaNTable",
    [](I& i) {
      UseTable(i, { 0.3, NotANumber, 0.1 });
    },
    { "PhaseTable", "nan" } },
};

class ParticipatingMediumErrors : public ::testing::TestWithParam<BadMedium>
{
};
}

TEST_P(ParticipatingMediumErrors, OneMessageNamesTheValueAndTheFix)
{
  MediumInput input;
  input.Add("ramp", 1, [](vtkIdType i, int) { return double(i); });
  input.Add("signed", 1, [](vtkIdType i, int) { return i - 13.0; });
  input.Add("vector", 3, [](vtkIdType, int) { return 0.5; });
  input.Add("five", 5, [](vtkIdType, int) { return 0.5; });
  input.Add("nothing", 1, [](vtkIdType, int) { return NotANumber; });
  input.Add(
    "cells", 1, [](vtkIdType, int) { return 0.5; }, true);
  ASSERT_EQ(input.GatherMedium(), "");
  GetParam().Break(input);
  const std::string problem = input.GatherMedium();
  ASSERT_NE(problem, "");
  for (const std::string& word : GetParam().Words)
  {
    EXPECT_NE(problem.find(word), std::string::npos) << word << " not in: " << problem;
  }
  EXPECT_EQ(problem.back(), '.');
  EXPECT_EQ(problem.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Bad, ParticipatingMediumErrors, ::testing::ValuesIn(BadMedia),
  [](const ::testing::TestParamInfo<BadMedium>& info) { return info.param.Name; });

TEST(ParticipatingMediumErrors, LimitsThemselvesAreAccepted)
{
  MediumInput input;
  input.Medium->SetExtinction(0);
  input.Medium->SetAlbedo(0, 1, 1);
  input.Medium->SetAnisotropy(-1);
  input.Medium->SetDensityScale(0);
  EXPECT_EQ(input.GatherMedium(), "");
  const double isotropic = 0.25 / vtkMath::Pi();
  UseTable(input, { 0, 1.0005 * 2 * isotropic }); // within 1e-3 of 1
  EXPECT_EQ(input.GatherMedium(), "");
}

TEST(ParticipatingMediumErrors, NonFiniteVoxelsCountAsTheSmallestOrLargestFiniteValue)
{
  MediumInput input;
  input.Add("holes", 1, [](vtkIdType i, int) {
    return i == 0 ? NotANumber : i == 2 ? Infinite : i == 6 ? -Infinite : 2.0 + i;
  });
  input.Medium->SetExtinctionArrayName("holes");
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_EQ(input.AtPoint(0, 0, 0).Extinction.x, 3);
  EXPECT_EQ(input.AtPoint(2, 0, 0).Extinction.x, 28);
  EXPECT_EQ(input.AtPoint(0, 2, 0).Extinction.x, 3);
  EXPECT_EQ(input.AtPoint(1, 1, 1).Extinction.x, 15);
}
