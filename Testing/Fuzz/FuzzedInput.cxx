// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzedInput.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObject.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace vtkMediumFuzz
{
namespace
{
constexpr int Types[] = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE };

/// A value of a type that is not a float's, from what fits into it.
double Fitting(Bytes& bytes, int type)
{
  const bool real = type == VTK_FLOAT || type == VTK_DOUBLE;
  const double value = real ? bytes.Number(0, 1) : bytes.Byte() - 3;
  const bool fits = type != VTK_FLOAT || !(std::abs(value) > 3e38) || std::isinf(value);
  const bool isUnsigned = type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT ||
    type == VTK_UNSIGNED_INT || type == VTK_UNSIGNED_LONG || type == VTK_UNSIGNED_LONG_LONG;
  const double most = type == VTK_CHAR || type == VTK_SIGNED_CHAR ? 127 : value;
  return !fits ? 0 : isUnsigned ? std::abs(value) : std::min(value, most);
}

const char* const Names[] = { nullptr, "", "first", "second", "missing" };

/// One coefficient of a medium, by its seven setters.
#define FILL_COEFFICIENT(X)                                                                        \
  medium->Set##X(bytes.Number(0, 2), bytes.Number(0, 2), bytes.Number(0, 2));                      \
  medium->Set##X##ArrayName(Names[bytes.Whole(5)]);                                                \
  medium->Set##X##Component(bytes.Whole(7) - 2);                                                   \
  medium->Set##X##Scale(bytes.Number(0, 1), bytes.Number(0, 1), bytes.Number(0, 1));               \
  switch (bytes.Whole(4))                                                                          \
  {                                                                                                \
    case 1:                                                                                        \
    {                                                                                              \
      vtkNew<vtkPiecewiseFunction> function;                                                       \
      FillFunction(bytes, function);                                                               \
      medium->Set##X##Function(function);                                                          \
      break;                                                                                       \
    }                                                                                              \
    case 2:                                                                                        \
    {                                                                                              \
      vtkNew<vtkColorTransferFunction> function;                                                   \
      FillFunction(bytes, function);                                                               \
      medium->Set##X##ColorFunction(function);                                                     \
      break;                                                                                       \
    }                                                                                              \
    default:                                                                                       \
      break;                                                                                       \
  }

void FillPhase(Bytes& bytes, vtkParticipatingMedium* medium)
{
  medium->SetPhaseFunction(bytes.Whole(9));
  medium->SetAnisotropy(bytes.Number(-1, 1));
  medium->SetAnisotropyArrayName(Names[bytes.Whole(5)]);
  medium->SetAnisotropyComponent(bytes.Whole(7) - 2);
  medium->SetBackAnisotropy(bytes.Number(-1, 0));
  medium->SetForwardWeight(bytes.Number(0, 1));
  medium->SetDraineAlpha(bytes.Number(0, 2));
  medium->SetDropletDiameter(bytes.Number(5, 50));
  if (bytes.Bit())
  {
    vtkNew<vtkDoubleArray> table;
    table->SetNumberOfComponents(bytes.Whole(8) == 0 ? 2 : 1);
    table->SetNumberOfTuples(bytes.Whole(6));
    const double isotropic = 0.07957747154594767; // 1 / 4 pi
    const bool sensible = bytes.Bit();
    for (vtkIdType i = 0; i < table->GetNumberOfValues(); ++i)
    {
      table->SetValue(i, sensible ? isotropic : bytes.Number(0, 2 * isotropic));
    }
    medium->SetPhaseTable(table);
  }
}
}

//------------------------------------------------------------------------------
void Demand(bool holds, const std::string& law)
{
  if (!holds)
  {
    std::cerr << "\nbroken: " << law << "\n";
    std::abort();
  }
}

//------------------------------------------------------------------------------
void Silence()
{
  vtkObject::GlobalWarningDisplayOff();
}

//------------------------------------------------------------------------------
void FillGeometry(Bytes& bytes, vtkImageData* image)
{
  int extent[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = bytes.Whole(8) == 0 ? bytes.Whole(200) - 100 : 0;
    extent[2 * axis + 1] = extent[2 * axis] + (bytes.Whole(16) == 0 ? -1 : 0) + bytes.Whole(5);
  }
  image->SetExtent(extent);
  image->SetOrigin(bytes.Number(-1, 1), bytes.Number(-1, 1), bytes.Number(-1, 1));
  image->SetSpacing(bytes.Number(0.1, 2), bytes.Number(0.1, 2), bytes.Number(0.1, 2));
  if (bytes.Bit())
  {
    vtkNew<vtkMatrix3x3> direction;
    for (int i = 0; i < 9; ++i)
    {
      direction->SetElement(i / 3, i % 3, bytes.Number(-1, 1));
    }
    image->SetDirectionMatrix(direction);
  }
}

//------------------------------------------------------------------------------
vtkDataArray* AddArray(Bytes& bytes, vtkImageData* image, const char* name, bool& onCells)
{
  onCells = bytes.Whole(4) == 0;
  const int type = Types[bytes.Whole(sizeof(Types) / sizeof(Types[0]))];
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(bytes.Bit() ? 1 : 1 + bytes.Whole(5));
  const vtkIdType length = onCells ? image->GetNumberOfCells() : image->GetNumberOfPoints();
  const bool short_ = bytes.Whole(16) == 0;
  array->SetNumberOfTuples(short_ ? bytes.Whole(5) : length);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      array->SetComponent(i, c, Fitting(bytes, type));
    }
  }
  onCells ? image->GetCellData()->AddArray(array) : image->GetPointData()->AddArray(array);
  return array;
}

//------------------------------------------------------------------------------
void FillMatrix(Bytes& bytes, vtkVolume* volume)
{
  if (bytes.Bit())
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 12; ++i)
    {
      matrix->SetElement(i / 4, i % 4, bytes.Number(-1, 1));
    }
    volume->SetUserMatrix(matrix);
  }
  volume->SetScale(bytes.Number(0.1, 2));
}

//------------------------------------------------------------------------------
void FillFunction(Bytes& bytes, vtkPiecewiseFunction* function)
{
  function->SetClamping(bytes.Bit());
  function->SetUseLogScale(bytes.Whole(8) == 0);
  for (int count = bytes.Whole(5); count > 0; --count)
  {
    const bool sharp = bytes.Bit();
    function->AddPoint(
      bytes.Number(0, 1), bytes.Number(0, 1), sharp ? bytes.Unit() : 0.5, sharp ? bytes.Unit() : 0);
  }
}

//------------------------------------------------------------------------------
void FillFunction(Bytes& bytes, vtkColorTransferFunction* function)
{
  // Not CIEDE2000: VTK searches minutes for a path between some colours.
  const int space = bytes.Whole(5);
  function->SetColorSpace(space < VTK_CTF_LAB_CIEDE2000 ? space : VTK_CTF_STEP);
  function->SetClamping(bytes.Bit());
  function->SetScale(bytes.Whole(8) == 0 ? VTK_CTF_LOG10 : VTK_CTF_LINEAR);
  for (int count = bytes.Whole(5); count > 0; --count)
  {
    const bool sharp = bytes.Bit();
    function->AddRGBPoint(bytes.Number(0, 1), bytes.Number(0, 1), bytes.Number(0, 1),
      bytes.Number(0, 1), sharp ? bytes.Unit() : 0.5, sharp ? bytes.Unit() : 0);
  }
}

//------------------------------------------------------------------------------
void FillMedium(Bytes& bytes, vtkParticipatingMedium* medium)
{
  medium->SetParametrization(bytes.Whole(2));
  FILL_COEFFICIENT(Extinction)
  FILL_COEFFICIENT(Albedo)
  FILL_COEFFICIENT(Absorption)
  FILL_COEFFICIENT(Scattering)
  FILL_COEFFICIENT(Emission)
  medium->SetDensityScale(bytes.Number(0, 2));
  medium->SetLengthUnit(bytes.Number(0.5, 2));
  FillPhase(bytes, medium);
}

//------------------------------------------------------------------------------
void FillProperty(Bytes& bytes, vtkVolumeProperty* property)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  FillFunction(bytes, opacity);
  property->SetScalarOpacity(opacity);
  property->SetInterpolationType(bytes.Whole(2));
  property->SetIndependentComponents(bytes.Bit());
  property->SetScalarOpacityUnitDistance(bytes.Number(0.1, 2));
  if (bytes.Bit())
  {
    vtkNew<vtkColorTransferFunction> color;
    FillFunction(bytes, color);
    property->SetColor(color);
  }
  else
  {
    vtkNew<vtkPiecewiseFunction> grey;
    FillFunction(bytes, grey);
    property->SetColor(grey);
  }
}

//------------------------------------------------------------------------------
Input::Input(Bytes& bytes)
{
  Silence();
  FillGeometry(bytes, this->Image);
  FillMatrix(bytes, this->Volume);
  this->Volume->SetProperty(this->Property);
  FillProperty(bytes, this->Property);
  for (const char* name : { "first", "second" })
  {
    bool onCells = false;
    vtkDataArray* array = bytes.Whole(6) ? AddArray(bytes, this->Image, name, onCells) : nullptr;
    if (!this->Scalars)
    {
      this->Scalars = array;
      this->OnCells = onCells;
    }
  }
}

//------------------------------------------------------------------------------
void DemandSoundScene(const vtkMediumScene& scene)
{
  Demand(std::isfinite(scene.Geometry.Length) && scene.Geometry.Length > 0, "the box has a length");
  Demand(scene.Geometry.VoxelLength > 0, "voxels have a length");
  const double ends[] = { 0, 0.25, 0.7, 1 };
  for (int i = 0; i < 64; ++i)
  {
    const glm::dvec3 box(ends[i % 4], ends[i / 4 % 4], ends[i / 16]);
    const vtkMediumScene::Coefficients at = scene.Evaluate(box);
    for (int c = 0; c < 3; ++c)
    {
      for (double value : { at.Extinction[c], at.Scattering[c], at.Emission[c] })
      {
        Demand(value >= 0, "a coefficient is >= 0, not " + std::to_string(value));
      }
      // Albedos that come of functions are held to 1 within rounding.
      Demand(at.Scattering[c] <= at.Extinction[c] * (1 + 1e-5), "scattering is part of extinction");
    }
    Demand(std::abs(at.Anisotropy) <= 1, "anisotropy is within [-1, 1]");
    Demand(std::isfinite(scene.Geometry.BoxToLocal(box).x), "a place is a number");
  }
}
}
