// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Media that mean nothing: one message that names the value and the fix, nothing drawn, and the next valid
// frame is that of a mapper which never saw them. All causes and their words are in Testing/Unit.
#include "BadInput.h"

#include "vtkDoubleArray.h"

using namespace vtkMediumTest;

namespace
{
vtkSmartPointer<vtkDoubleArray> MakeTable(std::initializer_list<double> values)
{
  auto table = vtkSmartPointer<vtkDoubleArray>::New();
  for (double value : values)
  {
    table->InsertNextValue(value);
  }
  return table;
}

/// Adds an array of a value to the image's points.
void AddArray(Scene& scene, const char* name, int components, double value)
{
  vtkImageData* image = vtkImageData::SafeDownCast(scene.Mapper->GetInput());
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  array->Fill(value);
  image->GetPointData()->AddArray(array);
}
}

TEST_F(BadInput, NegativeOrEndlessCoefficientsAreRefused)
{
  for (double value : { -0.5, NaN, Infinity })
  {
    std::ostringstream name;
    name << value;
    ExpectRefusal(
      { name.str(), "Extinction", ">= 0" },
      [value](Scene& scene) { scene.Medium->SetExtinction(value); },
      [](Scene& scene) { scene.Medium->SetExtinction(1); });
  }
}

TEST_F(BadInput, AlbedoAboveOneIsRefused)
{
  ExpectRefusal(
    { "Albedo", "1.25", "0 to 1" }, [](Scene& scene) { scene.Medium->SetAlbedo(1.25); },
    [](Scene& scene) { scene.Medium->SetAlbedo(1); });
}

TEST_F(BadInput, ArraysThatAreMissingOrUnfitAreRefused)
{
  const auto mend = [](Scene& scene) {
    scene.Medium->SetExtinctionArrayName(nullptr);
    scene.Medium->SetAnisotropyArrayName(nullptr);
  };
  ExpectRefusal(
    { "Extinction", "\"missing\"", "\"density\"" },
    [](Scene& scene) { scene.Medium->SetExtinctionArrayName("missing"); }, mend);
  ExpectRefusal(
    { "five", "5 components", "1 to 4" },
    [](Scene& scene) {
      AddArray(scene, "five", 5, 1);
      scene.Medium->SetExtinctionArrayName("five");
    },
    mend);
  ExpectRefusal(
    { "Extinction", "signed", "-13" },
    [](Scene& scene) {
      AddArray(scene, "signed", 1, -13);
      scene.Medium->SetExtinctionArrayName("signed");
    },
    mend);
  ExpectRefusal(
    { "Anisotropy", "wide", "26" },
    [](Scene& scene) {
      AddArray(scene, "wide", 1, 26);
      scene.Medium->SetAnisotropyArrayName("wide");
    },
    mend);
}

TEST_F(BadInput, TablesThatAreNoPhaseFunctionAreRefused)
{
  const auto mend = [](Scene& scene) {
    scene.Medium->SetPhaseTable(nullptr);
    scene.Medium->SetPhaseFunctionToIsotropic();
  };
  const auto use = [](std::initializer_list<double> values) {
    const vtkSmartPointer<vtkDoubleArray> table = MakeTable(values);
    return [table](Scene& scene) {
      scene.Medium->SetPhaseFunctionToTabulated();
      scene.Medium->SetPhaseTable(table);
    };
  };
  ExpectRefusal({ "PhaseTable", "3.14159", "divide" }, use({ 0.25, 0.25 }), mend);
  ExpectRefusal({ "PhaseTable", "-0.1" }, use({ 0.3, -0.1, 0.1 }), mend);
  ExpectRefusal({ "PhaseTable", "nan" }, use({ 0.3, NaN, 0.1 }), mend);
  ExpectRefusal(
    { "PhaseTable", "two" }, [](Scene& scene) { scene.Medium->SetPhaseFunctionToTabulated(); },
    mend);
}

// Beyond 0.999 a phase function would be a delta: it is held there, in silence, as documented.
TEST_F(BadInput, AnisotropyBeyondItsLimitIsHeld)
{
  ValidScene one, limit;
  one.Medium->SetPhaseFunctionToHenyeyGreenstein();
  limit.Medium->SetPhaseFunctionToHenyeyGreenstein();
  one.Medium->SetAnisotropy(1);
  limit.Medium->SetAnisotropy(0.999);
  EXPECT_EQ(one.Render().Values, limit.Render().Values);
  EXPECT_EQ(one.Errors.size(), 0u);
}

// The policy for voxels without a value: a frame is drawn, and one warning counts them.
TEST_F(BadInput, VoxelsThatAreNotNumbersAreCountedInOneWarning)
{
  ValidScene scene;
  scene.Medium->SetExtinctionArrayName("");
  std::vector<std::string> warnings;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&warnings);
  listener->SetCallback([](vtkObject*, unsigned long, void* said, void* words) {
    static_cast<std::vector<std::string>*>(said)->push_back(static_cast<const char*>(words));
  });
  const unsigned long tag = scene.Mapper->AddObserver(vtkCommand::WarningEvent, listener);
  vtkDataArray* density = scene.Mapper->GetInput()->GetPointData()->GetScalars();
  density->SetTuple1(7, NaN);
  density->SetTuple1(20, NaN);
  density->SetTuple1(21, Infinity);
  density->Modified();
  EXPECT_TRUE(scene.Render().IsLight());
  EXPECT_TRUE(scene.Render().IsLight());
  scene.Mapper->RemoveObserver(tag);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("3 "), std::string::npos) << warnings[0];
  EXPECT_EQ(scene.Errors.size(), 0u);
}
