// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What a vtkParticipatingMedium states is what the scene evaluates.
#include "MediumInput.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{
void ExpectNear(const glm::dvec3& found, const glm::dvec3& expected, double tolerance = 1e-12)
{
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(found[c], expected[c], tolerance * (1 + std::abs(expected[c]))) << "channel " << c;
  }
}
}

TEST(ParticipatingMedium, DefaultIsAHomogeneousWhiteMediumThatNeedsNoArray)
{
  MediumInput input;
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_TRUE(input.Scene.Content.Fields.empty());
  EXPECT_TRUE(input.Scene.Content.Functions.empty());
  EXPECT_FALSE(input.Scene.Content.ChromaticExtinction);
  const auto found = input.Scene.Evaluate({ 0.3, 0.5, 0.9 });
  ExpectNear(found.Extinction, glm::dvec3(1));
  ExpectNear(found.Scattering, glm::dvec3(1));
  ExpectNear(found.Emission, glm::dvec3(0));
  EXPECT_EQ(found.Anisotropy, 0);
}

TEST(ParticipatingMedium, AlbedoIsTheScatteredPartOfTheExtinction)
{
  MediumInput input;
  input.Medium->SetExtinction(2, 3, 4);
  input.Medium->SetAlbedo(0.5, 0.25, 1);
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_TRUE(input.Scene.Content.ChromaticExtinction);
  const auto found = input.Scene.Evaluate(glm::dvec3(0.5));
  ExpectNear(found.Extinction, { 2, 3, 4 });
  ExpectNear(found.Scattering, { 1, 0.75, 4 });
}

TEST(ParticipatingMedium, ExtinctionIsTheSumOfAbsorptionAndScattering)
{
  MediumInput input;
  input.Medium->SetParametrizationToAbsorptionAndScattering();
  input.Medium->SetAbsorption(0.5);
  input.Medium->SetScattering(1, 2, 3);
  input.Medium->SetExtinction(-7); // not looked at
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_TRUE(input.Scene.Content.ChromaticExtinction);
  const auto found = input.Scene.Evaluate(glm::dvec3(0.5));
  ExpectNear(found.Extinction, { 1.5, 2.5, 3.5 });
  ExpectNear(found.Scattering, { 1, 2, 3 });
}

TEST(ParticipatingMedium, DensityAndLengthUnitScaleAllButTheAlbedo)
{
  for (bool absorption : { false, true })
  {
    MediumInput input;
    input.Medium->SetParametrization(absorption);
    input.Medium->SetAbsorption(2);
    input.Medium->SetScattering(6);
    input.Medium->SetExtinction(8);
    input.Medium->SetAlbedo(0.75);
    input.Medium->SetEmission(1, 2, 3);
    input.Medium->SetDensityScale(5);
    input.Medium->SetLengthUnit(1000); // coefficients per metre, world in millimetres
    ASSERT_EQ(input.GatherMedium(), "");
    const auto found = input.Scene.Evaluate(glm::dvec3(0.5));
    ExpectNear(found.Extinction, glm::dvec3(0.04));
    ExpectNear(found.Scattering, glm::dvec3(0.03));
    ExpectNear(found.Emission, { 0.005, 0.01, 0.015 });
  }
}

TEST(ParticipatingMedium, ArraysAreFoundInPointDataThenCellDataAndShareAField)
{
  MediumInput input;
  input.Add("rho", 1, [](vtkIdType i, int) { return 0.1 * i; });
  input.Add(
    "rho", 1, [](vtkIdType, int) { return 99.0; }, true);
  input.Add(
    "heat", 1, [](vtkIdType i, int) { return 1.0 + i; }, true);
  input.Medium->SetExtinctionArrayName("rho");
  input.Medium->SetExtinctionScale(3, 2, 1);
  input.Medium->SetEmissionArrayName("heat");
  input.Medium->SetAnisotropyArrayName("rho");
  input.Medium->SetAnisotropyFunction(nullptr);
  input.Medium->SetAlbedo(0.5);
  std::string problem = input.GatherMedium();
  ASSERT_NE(problem, ""); // rho reaches 2.6, which is no anisotropy
  EXPECT_NE(problem.find("Anisotropy array \"rho\""), std::string::npos) << problem;

  vtkNew<vtkPiecewiseFunction> cosine;
  cosine->AddPoint(0, -0.5);
  cosine->AddPoint(2.6, 0.8);
  input.Medium->SetAnisotropyFunction(cosine);
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_EQ(input.Scene.Content.Fields.size(), 2u);
  EXPECT_TRUE(input.Scene.Content.ChromaticExtinction);
  const auto found = input.AtPoint(1, 2, 0); // point 7
  ExpectNear(found.Extinction, { 2.1, 1.4, 0.7 });
  ExpectNear(found.Scattering, { 1.05, 0.7, 0.35 });
  EXPECT_NEAR(found.Anisotropy, -0.5 + 0.5 * 0.7, 1e-9);
  // The centre of the cell (1, 0, 1), which is cell 5.
  ExpectNear(input.Scene.Evaluate({ 0.75, 0.25, 0.75 }).Emission, glm::dvec3(6));
}

TEST(ParticipatingMedium, TheEmptyNameIsTheScalarsOfTheMapper)
{
  MediumInput input;
  input.Scalars = input.Add(
    "chosen", 1, [](vtkIdType i, int) { return double(i); }, true);
  input.OnCells = true;
  input.Medium->SetExtinctionArrayName("");
  ASSERT_EQ(input.GatherMedium(), "");
  ASSERT_EQ(input.Scene.Content.Fields.size(), 1u);
  EXPECT_TRUE(input.Scene.Content.Fields[0].OnCells);
  ExpectNear(input.Scene.Evaluate({ 0.75, 0.75, 0.25 }).Extinction, glm::dvec3(3));
  input.Medium->SetExtinctionArrayName(nullptr);
  ASSERT_EQ(input.GatherMedium(), "");
  ExpectNear(input.Scene.Evaluate({ 0.75, 0.75, 0.25 }).Extinction, glm::dvec3(1));
}

TEST(ParticipatingMedium, AFunctionWithoutAnArrayReadsTheScalars)
{
  MediumInput input;
  input.Scalars = input.Add("chosen", 1, [](vtkIdType i, int) { return double(i); });
  vtkNew<vtkPiecewiseFunction> half;
  half->AddPoint(0, 0);
  half->AddPoint(26, 13);
  input.Medium->SetExtinctionFunction(half);
  input.Medium->SetAnisotropyFunction(nullptr);
  ASSERT_EQ(input.GatherMedium(), "");
  ExpectNear(input.AtPoint(1, 1, 1).Extinction, glm::dvec3(6.5), 1e-9);
  input.Medium->SetExtinctionFunction(nullptr);
  ASSERT_EQ(input.GatherMedium(), "");
  ExpectNear(input.AtPoint(1, 1, 1).Extinction, glm::dvec3(1));
}

TEST(ParticipatingMedium, ComponentsMeanWhatTheyMeanToAVolumeProperty)
{
  struct
  {
    int Components;
    glm::dvec3 Scattering, Absorption;
  } const table[] = { { 1, { 1, 1, 1 }, { 1, 1, 1 } }, { 2, { 1, 1, 1 }, { 2, 2, 2 } },
    { 3, { 1, 2, 3 }, { 1, 2, 3 } }, { 4, { 1, 2, 3 }, { 4, 4, 4 } } };
  for (const auto& row : table)
  {
    SCOPED_TRACE(row.Components);
    MediumInput input;
    input.Scalars = input.Add("all", row.Components, [](vtkIdType, int c) { return c + 1.0; });
    input.Medium->SetParametrizationToAbsorptionAndScattering();
    input.Medium->SetAbsorptionArrayName("");
    input.Medium->SetScatteringArrayName("all");
    ASSERT_EQ(input.GatherMedium(), "");
    EXPECT_EQ(input.Scene.Content.Fields.size(), 1u);
    const auto found = input.Scene.Evaluate(glm::dvec3(0.4));
    ExpectNear(found.Scattering, row.Scattering);
    ExpectNear(found.Extinction, row.Scattering + row.Absorption);
    for (int c = 0; c < row.Components; ++c)
    {
      input.Medium->SetAbsorptionComponent(c);
      ASSERT_EQ(input.GatherMedium(), "");
      ExpectNear(input.Scene.Evaluate(glm::dvec3(0.4)).Extinction, row.Scattering + (c + 1.0));
    }
  }
}

TEST(ParticipatingMedium, AFunctionOfAComponentReadsThatComponent)
{
  MediumInput input;
  input.Add("pair", 2, [](vtkIdType i, int c) { return c == 0 ? i / 26.0 : 4.0 - i / 13.0; });
  vtkNew<vtkPiecewiseFunction> square;
  square->AddPoint(0, 0);
  square->AddPoint(4, 8);
  input.Medium->SetExtinctionArrayName("pair");
  input.Medium->SetExtinctionFunction(square);
  input.Medium->SetExtinctionScale(0.5);
  ASSERT_EQ(input.GatherMedium(), "");
  ExpectNear(input.AtPoint(1, 1, 1).Extinction, glm::dvec3(3), 1e-9); // the last component
  input.Medium->SetExtinctionComponent(0);
  ASSERT_EQ(input.GatherMedium(), "");
  ExpectNear(input.AtPoint(1, 1, 1).Extinction, glm::dvec3(0.5), 1e-9);
}

TEST(ParticipatingMedium, FunctionsOfOneArrayShareATableWhereTheyFit)
{
  MediumInput input;
  input.Add("t", 1, [](vtkIdType i, int) { return double(i); });
  vtkNew<vtkPiecewiseFunction> density;
  density->AddPoint(0, 0);
  density->AddPoint(26, 13);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0, 1, 0, 0);
  color->AddRGBPoint(26, 0, 1, 0.5);
  vtkNew<vtkColorTransferFunction> fire;
  fire->AddRGBPoint(0, 0, 0, 0);
  fire->AddRGBPoint(26, 9, 3, 1);
  input.Medium->SetExtinctionArrayName("t");
  input.Medium->SetAlbedoArrayName("t");
  input.Medium->SetEmissionArrayName("t");
  input.Medium->SetExtinctionFunction(density);
  input.Medium->SetAlbedoColorFunction(color);
  input.Medium->SetEmissionColorFunction(fire);
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_EQ(input.Scene.Content.Fields.size(), 1u);
  EXPECT_EQ(input.Scene.Content.Functions.size(), 2u);
  EXPECT_FALSE(input.Scene.Content.ChromaticExtinction);
  const auto found = input.AtPoint(1, 1, 1); // t = 13
  ExpectNear(found.Extinction, glm::dvec3(6.5), 1e-9);
  ExpectNear(found.Scattering, glm::dvec3(6.5) * glm::dvec3(0.5, 0.5, 0.25), 1e-6);
  ExpectNear(found.Emission, { 4.5, 1.5, 0.5 }, 1e-6);

  input.Medium->SetExtinctionColorFunction(fire);
  EXPECT_EQ(input.Medium->GetExtinctionFunction(), nullptr);
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_TRUE(input.Scene.Content.ChromaticExtinction);
  ExpectNear(input.AtPoint(1, 1, 1).Extinction, { 4.5, 1.5, 0.5 }, 1e-6);
}

TEST(ParticipatingMedium, DropletsFollowThePublishedFit)
{
  MediumInput input;
  input.Medium->SetPhaseFunctionToDroplets();
  input.Medium->SetDropletDiameter(20);
  ASSERT_EQ(input.GatherMedium(), "");
  const vtkMediumScene::Medium& content = input.Scene.Content;
  EXPECT_EQ(content.Phase, vtkParticipatingMedium::Droplets);
  EXPECT_TRUE(content.Anisotropy.IsConstant());
  // Worked by hand from the paper's formulas.
  EXPECT_NEAR(content.BackAnisotropy, 0.994610, 1e-6);
  EXPECT_NEAR(content.Anisotropy.Scale.x, 0.593791, 1e-6);
  EXPECT_NEAR(content.DraineAlpha, 27.113694, 1e-5);
  EXPECT_NEAR(content.ForwardWeight, 0.498159, 1e-6);
}

TEST(ParticipatingMedium, EachPhaseFunctionReachesTheScene)
{
  MediumInput input;
  input.Medium->SetAnisotropy(0.3);
  vtkNew<vtkDoubleArray> table;
  table->InsertNextValue(0.25 / vtkMath::Pi());
  table->InsertNextValue(0.25 / vtkMath::Pi());
  input.Medium->SetPhaseTable(table);
  for (int phase = vtkParticipatingMedium::Isotropic; phase <= vtkParticipatingMedium::SchlickK;
       ++phase)
  {
    input.Medium->SetPhaseFunction(phase);
    ASSERT_EQ(input.GatherMedium(), "");
    EXPECT_EQ(input.Scene.Content.Phase, phase);
  }
  input.Medium->SetPhaseFunctionToDoubleHenyeyGreenstein();
  input.Medium->SetBackAnisotropy(-0.25);
  input.Medium->SetForwardWeight(0.75);
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_EQ(input.Scene.Content.Anisotropy.Scale.x, 0.3);
  EXPECT_EQ(input.Scene.Content.BackAnisotropy, -0.25);
  EXPECT_EQ(input.Scene.Content.ForwardWeight, 0.75);
  input.Medium->SetPhaseFunctionToTabulated();
  ASSERT_EQ(input.GatherMedium(), "");
  EXPECT_EQ(input.Scene.Content.PhaseTable.size(), 2u);
}

TEST(ParticipatingMedium, ChangesOfItsPartsCountAsItsOwn)
{
  vtkNew<vtkParticipatingMedium> medium;
  vtkMTimeType time = medium->GetMTime();
  const auto changed = [&]() {
    const vtkMTimeType before = time;
    time = medium->GetMTime();
    return time > before;
  };
  vtkNew<vtkPiecewiseFunction> curve;
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkDoubleArray> table;
  medium->SetExtinctionFunction(curve);
  EXPECT_TRUE(changed());
  curve->AddPoint(0, 1);
  EXPECT_TRUE(changed());
  medium->SetEmissionColorFunction(color);
  EXPECT_TRUE(changed());
  color->AddRGBPoint(0, 1, 1, 1);
  EXPECT_TRUE(changed());
  medium->SetPhaseTable(table);
  EXPECT_TRUE(changed());
  table->Modified();
  EXPECT_TRUE(changed());
  medium->SetAlbedo(0.5);
  EXPECT_TRUE(changed());
  medium->SetAlbedo(0.5);
  medium->SetExtinctionArrayName(nullptr);
  EXPECT_FALSE(changed());
  medium->SetExtinctionArrayName("");
  EXPECT_TRUE(changed());
}

TEST(ParticipatingMedium, PrintsEveryProperty)
{
  vtkNew<vtkParticipatingMedium> medium;
  std::ostringstream out;
  medium->Print(out);
  for (const char* name : { "Parametrization", "AbsorptionArrayName", "EmissionScale", "LengthUnit",
         "PhaseTable", "DropletDiameter", "AnisotropyComponent" })
  {
    EXPECT_NE(out.str().find(name), std::string::npos) << name;
  }
}
