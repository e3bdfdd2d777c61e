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
vtkMediumFunction SampleProperty(std::vector<vtkMediumScene::ColorTable>& tables,
  vtkVolumeProperty* property, double minimum, double maximum)
{
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  const double unit = property->GetScalarOpacityUnitDistance();
  const bool grey = property->GetColorChannels() == 1;
  vtkPiecewiseFunction* greyAlbedo = grey ? property->GetGrayTransferFunction() : nullptr;
  vtkColorTransferFunction* albedo = grey ? nullptr : property->GetRGBTransferFunction();

  std::vector<double> knots;
  vtkMediumAppendKnots(knots, opacity);
  grey ? vtkMediumAppendKnots(knots, greyAlbedo) : vtkMediumAppendKnots(knots, albedo);

  const std::vector<glm::dvec3> colors =
    grey ? std::vector<glm::dvec3>() : vtkMediumSampleColors(tables, albedo, minimum, maximum);
  std::size_t index = 0; // the values come in ascending order
  vtkMediumFunction function;
  function.Sample(minimum, maximum, knots, [&](double value) {
    const glm::dvec3 rgb = grey ? glm::dvec3(greyAlbedo->GetValue(value)) : colors[index++];
    return glm::dvec4(rgb, Extinction(opacity->GetValue(value), unit));
  });
  return function;
}

//------------------------------------------------------------------------------
// "" or which value of the sampled functions cannot be a medium.
std::string CheckSamples(const vtkMediumFunction& function)
{
  const std::vector<glm::dvec4>& samples = function.GetSamples();
  std::ostringstream problem;
  for (std::size_t i = 0; i < samples.size() && problem.str().empty(); ++i)
  {
    const double value = vtkMediumFunction::GetPlace(
      function.GetMinimum(), function.GetMaximum(), i, samples.size() - 1);
    for (int c = 0; c < 3 && problem.str().empty(); ++c)
    {
      if (!(samples[i][c] >= 0 && samples[i][c] <= 1 + vtkMediumAlbedoTolerance))
      {
        problem << "The volume property's colour function, which is the albedo, has the value "
                << samples[i][c] << " at the scalar " << value << "; give it values from 0 to 1.";
      }
    }
    if (problem.str().empty() && !std::isfinite(samples[i].w))
    {
      problem << "The volume property's scalar opacity at the scalar " << value
              << " is not a number; give it values from 0 to 1.";
    }
  }
  return problem.str();
}

//------------------------------------------------------------------------------
// Whether a gradient opacity other than 1 is in use; no medium is weaker where its density is even.
bool HasGradientOpacity(vtkVolumeProperty* property)
{
  const bool used = property->HasGradientOpacity() && !property->GetDisableGradientOpacity();
  vtkPiecewiseFunction* opacity = used ? property->GetStoredGradientOpacity() : nullptr;
  double node[4];
  for (int i = 0; opacity && i < opacity->GetSize(); ++i)
  {
    opacity->GetNodeValue(i, node);
    if (node[1] != 1)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// "" or which setting of the property has no meaning for a medium and would be left out in silence.
std::string CheckModes(vtkVolumeProperty* property)
{
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return "The volume property has a two-dimensional transfer function, of the scalar and its "
           "gradient, but a medium depends on the scalar alone; set functions of one dimension "
           "(SetTransferFunctionMode(vtkVolumeProperty::TF_1D), SetScalarOpacity, SetColor).";
  }
  if (HasGradientOpacity(property))
  {
    return "The volume property has a gradient opacity other than 1, but a medium does not depend "
           "on "
           "gradients; switch it off (DisableGradientOpacityOn), or give its effect as an array to "
           "a "
           "vtkParticipatingMedium.";
  }
  return {};
}

//------------------------------------------------------------------------------
// Nodes are (value, ..., midpoint, sharpness); the curve bends or jumps at the midpoint unless both
// have their defaults, 0.5 and 0.
template <typename Function>
void AppendKnots(std::vector<double>& knots, Function* function, int midpoint)
{
  double node[6], next[6];
  const int size = function->GetSize();
  for (int i = 0; i < size; ++i)
  {
    function->GetNodeValue(i, node);
    knots.push_back(node[0]);
    if (i + 1 < size && (node[midpoint] != 0.5 || node[midpoint + 1] != 0))
    {
      function->GetNodeValue(i + 1, next);
      knots.push_back(node[0] + node[midpoint] * (next[0] - node[0]));
    }
  }
}
}

//------------------------------------------------------------------------------
void vtkMediumAppendKnots(std::vector<double>& knots, vtkPiecewiseFunction* function)
{
  AppendKnots(knots, function, 2); // (value, y, midpoint, sharpness)
}

//------------------------------------------------------------------------------
void vtkMediumAppendKnots(std::vector<double>& knots, vtkColorTransferFunction* function)
{
  AppendKnots(knots, function, 4); // (value, r, g, b, midpoint, sharpness)
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
  field.Time = std::max(array->GetMTime(), input->GetMTime());
  field.OnCells = onCells;
  field.Linear = property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
  const vtkIdType expected =
    static_cast<vtkIdType>(field.Dimensions.x) * field.Dimensions.y * field.Dimensions.z;
  std::ostringstream problem;
  const char* name = array->GetName() ? array->GetName() : "(unnamed)";
  if (array->GetNumberOfTuples() != expected)
  {
    problem << "The array " << name << " has " << array->GetNumberOfTuples()
            << " tuples, but the image has " << expected << (onCells ? " cells" : " points")
            << "; give one tuple for each.";
  }
  else if (!field.FindRange())
  {
    problem << "The array " << name
            << " has no finite value; every one is NaN or infinite. Give data with finite values.";
  }
  else if (!std::isfinite(field.Maximum - field.Minimum))
  {
    problem << "The array " << name << " has values from " << field.Minimum << " to "
            << field.Maximum << ", which are further apart than a double can say; scale them down.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
std::string vtkMediumContentFromProperty(vtkMediumScene::Medium& content,
  std::vector<vtkMediumScene::ColorTable>& tables, vtkImageData* input, vtkDataArray* scalars,
  bool onCells, vtkVolumeProperty* property, double anisotropy)
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
  const std::string mode = CheckModes(property);
  if (!mode.empty())
  {
    return mode;
  }
  if (scalars->GetNumberOfComponents() != 1)
  {
    problem
      << "The scalars have " << scalars->GetNumberOfComponents()
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
  content.Functions.push_back(SampleProperty(tables, property, field.Minimum, field.Maximum));
  content.Fields.push_back(field);
  invalid = CheckSamples(content.Functions.back());
  if (!invalid.empty())
  {
    return invalid;
  }
  using Coefficient = vtkMediumScene::Coefficient;
  content.Extinction = Coefficient{ Coefficient::FunctionAlpha, 0, 0, -1, glm::dvec3(1) };
  content.Scattering = Coefficient{ Coefficient::FunctionRGB, 0, 0, -1, glm::dvec3(1) };
  content.Anisotropy.Scale = glm::dvec3(anisotropy);
  return {};
}
