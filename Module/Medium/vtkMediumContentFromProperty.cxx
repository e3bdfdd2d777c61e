// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumContent.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
double Extinction(double opacity, double unitDistance)
{
  const double alpha = std::min(std::max(opacity, 0.0), vtkMediumMaximumOpacity);
  return -std::log1p(-alpha) / unitDistance;
}

//------------------------------------------------------------------------------
// Both functions in one table (albedo, extinction), sampled by VTK itself, so that every colour
// space, scale, midpoint and sharpness means here what it means elsewhere in VTK.
vtkMediumFunction SampleProperty(vtkVolumeProperty* property, double minimum, double maximum)
{
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  const double unit = property->GetScalarOpacityUnitDistance();
  const bool grey = property->GetColorChannels() == 1;
  vtkPiecewiseFunction* greyAlbedo = grey ? property->GetGrayTransferFunction() : nullptr;
  vtkColorTransferFunction* albedo = grey ? nullptr : property->GetRGBTransferFunction();

  std::vector<double> knots;
  double node[6];
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    opacity->GetNodeValue(i, node);
    knots.push_back(node[0]);
  }
  const int albedoSize = grey ? greyAlbedo->GetSize() : albedo->GetSize();
  for (int i = 0; i < albedoSize; ++i)
  {
    grey ? greyAlbedo->GetNodeValue(i, node) : albedo->GetNodeValue(i, node);
    knots.push_back(node[0]);
  }

  vtkMediumFunction function;
  function.Sample(minimum, maximum, knots, [&](double value) {
    glm::dvec3 rgb;
    if (grey)
    {
      rgb = glm::dvec3(greyAlbedo->GetValue(value));
    }
    else
    {
      albedo->GetColor(value, &rgb[0]);
    }
    return glm::dvec4(rgb, Extinction(opacity->GetValue(value), unit));
  });
  return function;
}
}

//------------------------------------------------------------------------------
std::string vtkMediumFieldFromArray(vtkMediumField& field, vtkImageData* input, vtkDataArray* array,
  bool onCells, vtkVolumeProperty* property)
{
  int extent[6];
  input->GetExtent(extent);
  const int cells = onCells ? 0 : 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    field.Dimensions[axis] = extent[2 * axis + 1] - extent[2 * axis] + cells;
  }
  field.Array = array;
  field.OnCells = onCells;
  field.Linear = property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  const vtkIdType expected =
    static_cast<vtkIdType>(field.Dimensions.x) * field.Dimensions.y * field.Dimensions.z;
  std::ostringstream problem;
  const char* name = array->GetName() ? array->GetName() : "(unnamed)";
  if (array->GetNumberOfTuples() != expected)
  {
    problem << "The array " << name << " has " << array->GetNumberOfTuples() << " tuples, but the image has "
            << expected << (onCells ? " cells" : " points") << "; give one tuple for each.";
  }
  else if (!field.FindRange())
  {
    problem << "The array " << name
            << " has no finite value; every one is NaN or infinite. Give data with finite values.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
std::string vtkMediumContentFromProperty(vtkMediumScene::Medium& content, vtkImageData* input,
  vtkDataArray* scalars, bool onCells, vtkVolumeProperty* property, double anisotropy)
{
  std::ostringstream problem;
  if (!(property->GetScalarOpacityUnitDistance() > 0))
  {
    problem << "The volume property's ScalarOpacityUnitDistance is "
            << property->GetScalarOpacityUnitDistance() << "; set a length > 0 in world units.";
    return problem.str();
  }
  if (!(anisotropy >= -1 && anisotropy <= 1))
  {
    problem << "The anisotropy is " << anisotropy
            << "; set a mean cosine in [-1, 1] (values beyond +-0.999 are taken as +-0.999).";
    return problem.str();
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    problem << "The scalars have " << scalars->GetNumberOfComponents()
            << " components, but a volume property maps one; pick an array of one component, or set "
               "a vtkParticipatingMedium.";
    return problem.str();
  }

  vtkMediumField field;
  std::string invalid = vtkMediumFieldFromArray(field, input, scalars, onCells, property);
  if (!invalid.empty())
  {
    return invalid;
  }
  content.Functions.push_back(SampleProperty(property, field.Minimum, field.Maximum));
  content.Fields.push_back(field);
  using Coefficient = vtkMediumScene::Coefficient;
  content.Extinction = Coefficient{ Coefficient::FunctionAlpha, 0, 0, -1, glm::dvec3(1) };
  content.Scattering = Coefficient{ Coefficient::FunctionRGB, 0, 0, -1, glm::dvec3(1) };
  content.Anisotropy.Scale = glm::dvec3(anisotropy);
  return {};
}
