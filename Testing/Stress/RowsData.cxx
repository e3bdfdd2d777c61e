// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 41 to 46, 48, 55 and 56: what the image holds.
#include "StressRefusal.h"

#include "vtkFloatArray.h"
#include "vtkPiecewiseFunction.h"

#include <limits>

namespace vtkMediumStress
{
namespace
{
constexpr int Types[] = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE };

double SameFrames(const Trial& trial)
{
  return trial.Is(Mapper::ErrorControlled) ? 4 * ControlledError : Same;
}

void PointsAndCells(Trial& trial)
{
  const glm::dvec3 beam = glm::normalize(glm::dvec3(0.3, -0.8, -0.4));
  for (bool field : { false, true })
  {
    for (bool onCells : { false, true })
    {
      Stage stage(trial, MakeBox({ 1, 0.8, 0.5 }, onCells));
      if (field && !trial.Is(Mapper::Paper))
      {
        stage.SetField(2);
      }
      stage.SetSigma(2);
      stage.SetFineSteps(2);
      stage.Mapper->SetLightSampleDistance(0.1);
      stage.AddBeam(beam);
      stage.Look({ 0.2, 0.1, -1 }, 2);
      TruthA{ -beam, 2, Box({ 1, 0.8, 0.5 }) }.Check(stage, onCells ? "cell data" : "point data");
    }
  }
}

/// Values 0, 20, ... 100 along x, which each type has; `scale` makes them what they would be elsewhere.
vtkSmartPointer<vtkImageData> MakeLevels(int type, double scale = 1, double shift = 0)
{
  return MakeImage(
    { 6, 3, 3 }, glm::dvec3(1),
    [&](const glm::dvec3& p) { return scale * std::round(100 * (p.x + 0.5)) + shift; }, false,
    type);
}

struct LevelsStage : Stage
{
  LevelsStage(Trial& trial, vtkImageData* image, double unit = 1)
    : Stage(trial, image)
  {
    if (trial.Is(vtkMediumStress::Mapper::Paper))
    {
      this->Mapper->SetPaperThreshold(50 * unit);
      this->SetSigma(2);
    }
    else
    {
      this->SetField(0.03 / unit);
    }
    this->AddBeam({ 1, -0.7, -0.2 });
    this->Look({ 0.2, 0.1, -1 }, 2);
    this->SetSteps(0.02, 0.05);
  }
};

// A scale that is rounded otherwise may round a few values of light caches to the next half float.
constexpr double RoundedScale = 2e-6;

void ScalarTypes(Trial& trial)
{
  const Picture reference = LevelsStage(trial, MakeLevels(VTK_FLOAT)).Render();
  for (int type : Types)
  {
    CheckSame(trial, reference, LevelsStage(trial, MakeLevels(type)).Render(), RoundedScale,
      "scalar type " + std::to_string(type));
  }
}

void ExtremeValues(Trial& trial)
{
  const Picture reference = LevelsStage(trial, MakeLevels(VTK_FLOAT)).Render();
  for (double unit : { 1e-300, 1e-40, 1e30, 1e300 })
  {
    CheckSame(trial, reference, LevelsStage(trial, MakeLevels(VTK_DOUBLE, unit), unit).Render(),
      SameFrames(trial), "values times " + std::to_string(std::log10(unit)) + " powers of ten");
  }
  // Small differences on a large offset: levels of 1e-3 at 1e8, mapped by a function.
  if (!trial.Is(Mapper::Paper))
  {
    LevelsStage stage(trial, MakeLevels(VTK_DOUBLE, 1e-3 / 20, 1e8));
    vtkNew<vtkPiecewiseFunction> ramp;
    ramp->AddPoint(1e8, 0);
    ramp->AddPoint(1e8 + 5e-3, 3);
    stage.Medium->SetExtinctionScale(1);
    stage.Medium->SetExtinctionFunction(ramp);
    // A double at 1e8 resolves 1.5e-8 of a range of 5e-3.
    CheckSame(trial, reference, stage.Render(), SameFrames(trial) + 1e-5, "1e8 + 1e-3");
  }
}

/// A bad voxel is the smallest or largest value, and nothing else changes.
void NonFiniteVoxels(Trial& trial)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (double bad : { std::nan(""), -infinity, infinity })
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const vtkIdType voxel =
        (corner & 1 ? 5 : 0) + 6 * (corner & 2 ? 2 : 0) + 18 * (corner & 4 ? 2 : 0);
      auto picture = [&](double value) {
        vtkSmartPointer<vtkImageData> image = MakeLevels(VTK_FLOAT);
        image->GetPointData()->GetScalars()->SetTuple1(voxel, value);
        LevelsStage stage(trial, image);
        stage.Mapper->SetMaximumError(1e-2); // the same bits, however short the steps
        return stage.Render();
      };
      const Picture poisoned = picture(bad), documented = picture(bad > 0 ? 100 : 0);
      trial.Holds(
        poisoned.Values == documented.Values, "NaN and -Inf are 0, +Inf is 100, to the bit");
    }
  }
}

void Degenerate(Trial& trial)
{
  for (const glm::ivec3& points : { glm::ivec3(1), glm::ivec3(8, 8, 1), glm::ivec3(1, 8, 8) })
  {
    CheckRefusal(
      trial, "two points",
      [&](Stage& stage) {
        vtkNew<vtkImageData> image;
        image->SetDimensions(points.x, points.y, points.z);
        image->AllocateScalars(VTK_FLOAT, 1);
        image->GetPointData()->GetScalars()->Fill(1);
        stage.Mapper->SetInputData(image);
      },
      UseBox);
  }
  Stage stage(trial, MakeBox(), 4);
  stage.AddBeam({ 0, -1, 0 });
  vtkNew<vtkImageData> empty;
  stage.Mapper->SetInputData(empty);
  for (unsigned char byte : stage.RenderWindow())
  {
    trial.Holds(byte == 0, "an empty image shows nothing");
  }
  trial.Holds(stage.Errors.size() <= 1, "an empty image is reported once, if VTK asks at all");
}

/// Component `read` of several holds the levels, the others something else.
vtkSmartPointer<vtkImageData> MakeComponents(int components, int read)
{
  vtkSmartPointer<vtkImageData> image = MakeLevels(VTK_FLOAT);
  vtkDataArray* levels = image->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> several;
  several->SetNumberOfComponents(components);
  several->SetNumberOfTuples(levels->GetNumberOfTuples());
  for (vtkIdType i = 0; i < levels->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      several->SetComponent(
        i, c, c == read || read < 0 ? levels->GetTuple1(i) : 7.0 * ((i + c) % 5));
    }
  }
  image->GetPointData()->SetScalars(several);
  return image;
}

void Components(Trial& trial)
{
  const Picture reference = LevelsStage(trial, MakeLevels(VTK_FLOAT)).Render();
  const bool paper = trial.Is(Mapper::Paper); // compares the first component with its threshold
  CheckSame(trial, reference, LevelsStage(trial, MakeComponents(2, paper ? 0 : 1)).Render(),
    SameFrames(trial), "two components: the second is the extinction");
  CheckSame(trial, reference, LevelsStage(trial, MakeComponents(3, paper ? 0 : -1)).Render(),
    SameFrames(trial), "three equal components: grey");
  CheckSame(trial, reference, LevelsStage(trial, MakeComponents(4, paper ? 0 : 3)).Render(),
    SameFrames(trial), "four components: the fourth is the extinction");
  CheckRefusal(
    trial, "5",
    [](Stage& stage) {
      stage.Mapper->SetInputData(MakeComponents(5, 0));
      stage.Medium->SetExtinctionArrayName("");
    },
    [](Stage& stage) {
      UseBox(stage);
      stage.Medium->SetExtinctionArrayName(nullptr);
    });
}

/// The same trilinear field on a lattice twice as fine.
void Resampled(Trial& trial)
{
  const bool paper = trial.Is(Mapper::Paper);
  auto coarse = vtkMediumFixtures::MakeImage(vtkMediumFixtures::Smooth, glm::ivec3(6));
  vtkMediumScene scene = vtkMediumFixtures::MakeScene(coarse, 1);
  auto fine = MakeImage(glm::ivec3(11), glm::dvec3(1),
    [&](const glm::dvec3& p) { return scene.Content.Fields[0].Interpolate(p + 0.5).x; });
  auto picture = [&](vtkImageData* image) {
    Stage stage(trial, image);
    stage.Mapper->SetPaperThreshold(0.3);
    paper ? stage.SetSigma(3) : stage.SetField(5);
    stage.AddBeam({ 1, -0.7, -0.2 });
    stage.Look({ 0.2, 0.1, -1 }, 2);
    stage.SetSteps(0.02, 0.02);
    return stage.Render();
  };
  CheckSame(
    trial, picture(coarse), picture(fine), paper ? 1e-3 : SameFrames(trial), "twice as fine");
}

void SwappedInputs(Trial& trial)
{
  LevelsStage stage(trial, MakeLevels(VTK_FLOAT));
  const Picture reference = stage.Render();
  stage.Mapper->SetInputData(MakeLevels(VTK_UNSIGNED_SHORT));
  CheckSame(trial, reference, stage.Render(), RoundedScale, "another type");
  stage.Mapper->SetInputData(MakeLevels(VTK_FLOAT, 1.5));
  trial.Holds(stage.Render().Values != reference.Values, "another image is seen");
  vtkSmartPointer<vtkImageData> image = MakeLevels(VTK_FLOAT);
  stage.Mapper->SetInputData(image);
  CheckSame(trial, reference, stage.Render(), 1e-6, "back again");
  image->GetPointData()->SetScalars(MakeComponents(1, -1)->GetPointData()->GetScalars());
  CheckSame(trial, reference, stage.Render(), 1e-6, "another array of the same values");
  if (!trial.Is(Mapper::Paper))
  {
    vtkDataArray* levels = image->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < levels->GetNumberOfTuples(); ++i)
    {
      levels->SetTuple1(i, 100 - levels->GetTuple1(i)); // of the same range
    }
    levels->Modified();
    trial.Holds(stage.Render().Values != reference.Values, "new values are seen");
  }
  CheckRefusal(
    trial, "scalars",
    [](Stage& s) {
      vtkNew<vtkImageData> bare;
      bare->SetDimensions(4, 4, 4);
      s.Mapper->SetInputData(bare);
      s.Mapper->SetMedium(nullptr);
    },
    [](Stage& s) {
      UseBox(s);
      s.Mapper->SetMedium(s.Medium);
    });
}
}

std::vector<Row> DataRows()
{
  return {
    { 41, "ConstantPointAndCellDataAreTruthA", "as row 2", PointsAndCells, {} },
    { 42, "EveryScalarTypeIsTheSamePhysics", "2e-6: rounding of the scale, and of caches",
      ScalarTypes, {} },
    { 43, "ValuesBeyondFloatAreRebased", "S", ExtremeValues, {} },
    { 44, "BadVoxelsAreExtremesAndStayLocal", "bitwise", NonFiniteVoxels, {} },
    { 45, "FlatAndEmptyImagesAreRefused", "E", Degenerate, {} },
    { 46, "ComponentsMeanWhatIsDocumented", "S; E for five", Components, {} },
    { 48, "ResampledFieldIsTheSame", "S; Paper 1e-3: its surface is found to 2⁻¹⁰ of a step",
      Resampled, {} },
    { 55, "SwappedInputsAreSeen", "2e-6, 1e-6 of the same type; E for an image without scalars",
      SwappedInputs, {} },
  };
}
}
