// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkParticipatingMedium.h"

#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>

vtkStandardNewMacro(vtkParticipatingMedium);

//------------------------------------------------------------------------------
vtkParticipatingMedium::vtkParticipatingMedium()
{
  for (Coefficients one : { ExtinctionCoefficient, AlbedoCoefficient, ScatteringCoefficient })
  {
    this->Sources[one].Value = { { 1, 1, 1 } };
  }
}

//------------------------------------------------------------------------------
vtkParticipatingMedium::~vtkParticipatingMedium() = default;

//------------------------------------------------------------------------------
vtkMTimeType vtkParticipatingMedium::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (const Source& source : this->Sources)
  {
    if (source.Function)
    {
      time = std::max(time, source.Function->GetMTime());
    }
    if (source.ColorFunction)
    {
      time = std::max(time, source.ColorFunction->GetMTime());
    }
  }
  return this->PhaseTable ? std::max(time, this->PhaseTable->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::Assign(std::array<double, 3>& target, double r, double g, double b)
{
  const std::array<double, 3> value{ { r, g, b } };
  if (target != value)
  {
    target = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::AssignArrayName(Source& source, const char* name)
{
  const bool hasArray = name != nullptr;
  const std::string arrayName = name ? name : "";
  if (source.HasArray != hasArray || source.ArrayName != arrayName)
  {
    source.HasArray = hasArray;
    source.ArrayName = arrayName;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::AssignFunction(Source& source, vtkPiecewiseFunction* function)
{
  if (source.Function != function)
  {
    source.Function = function;
    source.ColorFunction = function ? nullptr : source.ColorFunction;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::AssignColorFunction(Source& source, vtkColorTransferFunction* function)
{
  if (source.ColorFunction != function)
  {
    source.ColorFunction = function;
    source.Function = function ? nullptr : source.Function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
// What every coefficient has.
#define DEFINE_SOURCE(Name)                                                                        \
  void vtkParticipatingMedium::Set##Name##ArrayName(const char* name)                              \
  {                                                                                                \
    this->AssignArrayName(this->Sources[Name##Coefficient], name);                                 \
  }                                                                                                \
  const char* vtkParticipatingMedium::Get##Name##ArrayName()                                       \
  {                                                                                                \
    const Source& source = this->Sources[Name##Coefficient];                                       \
    return source.HasArray ? source.ArrayName.c_str() : nullptr;                                   \
  }                                                                                                \
  void vtkParticipatingMedium::Set##Name##Component(int component)                                 \
  {                                                                                                \
    if (this->Sources[Name##Coefficient].Component != component)                                   \
    {                                                                                              \
      this->Sources[Name##Coefficient].Component = component;                                      \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  int vtkParticipatingMedium::Get##Name##Component()                                               \
  {                                                                                                \
    return this->Sources[Name##Coefficient].Component;                                             \
  }                                                                                                \
  void vtkParticipatingMedium::Set##Name##Function(vtkPiecewiseFunction* function)                 \
  {                                                                                                \
    this->AssignFunction(this->Sources[Name##Coefficient], function);                              \
  }                                                                                                \
  vtkPiecewiseFunction* vtkParticipatingMedium::Get##Name##Function()                              \
  {                                                                                                \
    return this->Sources[Name##Coefficient].Function;                                              \
  }

// What those that may be RGB have besides.
#define DEFINE_COLOR_SOURCE(Name)                                                                  \
  DEFINE_SOURCE(Name)                                                                              \
  void vtkParticipatingMedium::Set##Name(double r, double g, double b)                             \
  {                                                                                                \
    this->Assign(this->Sources[Name##Coefficient].Value, r, g, b);                                 \
  }                                                                                                \
  double* vtkParticipatingMedium::Get##Name()                                                      \
  {                                                                                                \
    return this->Sources[Name##Coefficient].Value.data();                                          \
  }                                                                                                \
  void vtkParticipatingMedium::Set##Name##Scale(double r, double g, double b)                      \
  {                                                                                                \
    this->Assign(this->Sources[Name##Coefficient].Scale, r, g, b);                                 \
  }                                                                                                \
  double* vtkParticipatingMedium::Get##Name##Scale()                                               \
  {                                                                                                \
    return this->Sources[Name##Coefficient].Scale.data();                                          \
  }                                                                                                \
  void vtkParticipatingMedium::Set##Name##ColorFunction(vtkColorTransferFunction* function)        \
  {                                                                                                \
    this->AssignColorFunction(this->Sources[Name##Coefficient], function);                         \
  }                                                                                                \
  vtkColorTransferFunction* vtkParticipatingMedium::Get##Name##ColorFunction()                     \
  {                                                                                                \
    return this->Sources[Name##Coefficient].ColorFunction;                                         \
  }

DEFINE_COLOR_SOURCE(Extinction)
DEFINE_COLOR_SOURCE(Albedo)
DEFINE_COLOR_SOURCE(Absorption)
DEFINE_COLOR_SOURCE(Scattering)
DEFINE_COLOR_SOURCE(Emission)
DEFINE_SOURCE(Anisotropy)

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetAnisotropy(double g)
{
  this->Assign(this->Sources[AnisotropyCoefficient].Value, g, g, g);
}

//------------------------------------------------------------------------------
double vtkParticipatingMedium::GetAnisotropy()
{
  return this->Sources[AnisotropyCoefficient].Value[0];
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetPhaseTable(vtkDoubleArray* table)
{
  if (this->PhaseTable != table)
  {
    this->PhaseTable = table;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkParticipatingMedium::GetPhaseTable()
{
  return this->PhaseTable;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::ShallowCopy(vtkParticipatingMedium* other)
{
  if (!other || other == this)
  {
    return;
  }
  this->Sources = other->Sources;
  this->Parametrization = other->Parametrization;
  this->DensityScale = other->DensityScale;
  this->LengthUnit = other->LengthUnit;
  this->PhaseFunction = other->PhaseFunction;
  this->BackAnisotropy = other->BackAnisotropy;
  this->ForwardWeight = other->ForwardWeight;
  this->DraineAlpha = other->DraineAlpha;
  this->DropletDiameter = other->DropletDiameter;
  this->PhaseTable = other->PhaseTable;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const names[NumberOfCoefficients] = { "Extinction", "Albedo", "Absorption",
    "Scattering", "Emission", "Anisotropy" };
  os << indent << "Parametrization: "
     << (this->Parametrization == ExtinctionAndAlbedo ? "ExtinctionAndAlbedo"
                                                      : "AbsorptionAndScattering")
     << "\n";
  for (int i = 0; i < NumberOfCoefficients; ++i)
  {
    const Source& source = this->Sources[i];
    os << indent << names[i] << ": (" << source.Value[0] << ", " << source.Value[1] << ", "
       << source.Value[2] << ")\n";
    os << indent << names[i] << "ArrayName: "
       << (!source.HasArray              ? "(none)"
              : source.ArrayName.empty() ? "(the scalars)"
                                         : source.ArrayName.c_str())
       << "\n";
    os << indent << names[i] << "Component: " << source.Component << "\n";
    os << indent << names[i] << "Scale: (" << source.Scale[0] << ", " << source.Scale[1] << ", "
       << source.Scale[2] << ")\n";
    os << indent << names[i] << "Function: " << source.Function.Get() << "\n";
    os << indent << names[i] << "ColorFunction: " << source.ColorFunction.Get() << "\n";
  }
  os << indent << "DensityScale: " << this->DensityScale << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "PhaseFunction: " << this->PhaseFunction << "\n";
  os << indent << "BackAnisotropy: " << this->BackAnisotropy << "\n";
  os << indent << "ForwardWeight: " << this->ForwardWeight << "\n";
  os << indent << "DraineAlpha: " << this->DraineAlpha << "\n";
  os << indent << "DropletDiameter: " << this->DropletDiameter << "\n";
  os << indent << "PhaseTable: " << this->PhaseTable.Get() << "\n";
}
