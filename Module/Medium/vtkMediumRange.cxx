// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumRange.h"

#include "vtkMediumGaussLegendre.h"
#include "vtkMediumReferenceLight.h"

#include <algorithm>
#include <sstream>

namespace
{
using Coefficient = vtkMediumScene::Coefficient;

// Below the largest double by what phase functions (1.6e5 at g = 0.999, the size of a table) and the sums of
// a quadrature multiply.
constexpr double Largest = 1e290;

//------------------------------------------------------------------------------
// The largest value of what a field's coefficient reads: of one component, or of any.
double LargestOf(const vtkMediumField& field, int component)
{
  component = field.Components < 3 ? std::max(component, 0) : component;
  if (component < 0)
  {
    return field.Maximum;
  }
  double range[2];
  field.Array->GetFiniteRange(range, field.FirstComponent + component);
  return range[1];
}

//------------------------------------------------------------------------------
// An upper bound of a coefficient, before the density.
double LargestOf(const vtkMediumScene::Medium& content, const Coefficient& coefficient)
{
  double largest = 1;
  if (coefficient.Source == Coefficient::Field)
  {
    largest = LargestOf(content.Fields[coefficient.FieldIndex], coefficient.Component);
  }
  else if (!coefficient.IsConstant())
  {
    largest = 0;
    for (const glm::dvec4& sample : content.Functions[coefficient.FunctionIndex].GetSamples())
    {
      largest = coefficient.Source == Coefficient::FunctionAlpha
        ? std::max(largest, sample.w)
        : std::max({ largest, sample.x, sample.y, sample.z });
    }
  }
  return largest * vtkMediumMagnitude(coefficient.Scale);
}

//------------------------------------------------------------------------------
// Where it is infinite, doubles have 0 times infinity where nothing is.
double LargestExtinction(const vtkMediumScene::Medium& content)
{
  const double extinction = content.DensityScale * LargestOf(content, content.Extinction);
  return content.ExtinctionIsAbsorption
    ? extinction + content.DensityScale * LargestOf(content, content.Scattering)
    : extinction;
}

//------------------------------------------------------------------------------
std::string Check(const vtkMediumScene& scene, const char* what, double value)
{
  const double length = scene.Geometry.Length;
  std::ostringstream problem;
  if (!(value <= Largest && value * length <= Largest))
  {
    problem << "The medium's " << what << " reaches " << value
            << " per world unit (with a density of " << scene.Content.DensityScale
            << "), which over the volume's diagonal of " << length
            << " world units is more than doubles can say (" << Largest
            << "); make it smaller by its scale, the medium's DensityScale or the property's "
               "ScalarOpacityUnitDistance, or the volume by its spacing.";
  }
  return problem.str();
}
}

//------------------------------------------------------------------------------
std::string vtkMediumCheckRange(const vtkMediumScene& scene)
{
  const vtkMediumScene::Medium& content = scene.Content;
  const std::string problem = Check(scene, "extinction", LargestExtinction(content));
  return !problem.empty()
    ? problem
    : Check(scene, "emission", content.DensityScale * LargestOf(content, content.Emission));
}

//------------------------------------------------------------------------------
std::string vtkMediumCheckRangeOfLights(const vtkMediumScene& scene)
{
  double light = 0;
  for (const vtkMediumScene::Light& one : scene.Lights)
  {
    light += vtkMediumMagnitude(vtkMediumBrightest(one));
  }
  const double extinction = LargestExtinction(scene.Content);
  std::ostringstream problem;
  if (extinction > 0 &&
    !(light <= Largest && extinction * light * scene.Geometry.Length <= Largest))
  {
    problem << "An extinction of up to " << extinction
            << " per world unit scatters an irradiance of up to " << light
            << " (at a light itself, by its attenuation values); over the volume's diagonal of "
            << scene.Geometry.Length << " world units that is more than doubles can say ("
            << Largest << "); give the lights a lesser intensity or larger attenuation values.";
  }
  return problem.str();
}
