// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumContent.h"

#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkParticipatingMedium.h"

#include <cmath>
#include <sstream>

namespace
{
/// Beyond any material's by far, and three times it is a float.
constexpr double LargestDraineAlpha = 1e30;

/// How far the integral of a phase table may be from 1.
constexpr double TableTolerance = 1e-3;

//------------------------------------------------------------------------------
std::string CheckNumber(const char* name, double value, double minimum, double maximum)
{
  std::ostringstream problem;
  if (!(value >= minimum && value <= maximum))
  {
    problem << "The medium's " << name << " is " << value << "; set a number from " << minimum
            << " to " << maximum << ".";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
// Table 1 of Jendersie and d'Eon (2023), An Approximate Mie Scattering Function for Fog and Cloud
// Rendering, doi:10.1145/3587421.3595409: diameters of 5 to 50 micrometres.
void FitDroplets(vtkMediumScene::Medium& content, double diameter)
{
  content.BackAnisotropy = std::exp(-0.0990567 / (diameter - 1.67154));
  content.Anisotropy.Scale = glm::dvec3(std::exp(-2.20679 / (diameter + 3.91029) - 0.428934));
  content.DraineAlpha = std::exp(3.62489 - 8.29288 / (diameter + 5.52825));
  content.ForwardWeight = std::exp(-0.599085 / (diameter - 0.641583) - 0.665888);
}

//------------------------------------------------------------------------------
std::string CopyTable(std::vector<double>& target, vtkDoubleArray* table)
{
  std::ostringstream problem;
  const vtkIdType size = table ? table->GetNumberOfTuples() : 0;
  if (size < 2 || table->GetNumberOfComponents() != 1)
  {
    problem << "The medium's PhaseTable has " << size << " values of "
            << (table ? table->GetNumberOfComponents() : 0)
            << " components; set a vtkDoubleArray of at least two values of one component.";
    return problem.str();
  }
  double sum = 0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double value = table->GetValue(i);
    if (!(value >= 0) || !std::isfinite(value))
    {
      problem << "The medium's PhaseTable has the value " << value << " at index " << i
              << "; set finite values >= 0, per steradian.";
      return problem.str();
    }
    sum += i == 0 || i == size - 1 ? 0.5 * value : value;
  }
  const double integral = 2 * vtkMath::Pi() * sum * 2 / (size - 1);
  if (!(std::abs(integral - 1) <= TableTolerance))
  {
    problem << "The medium's PhaseTable integrates to " << integral
            << " over the sphere; it must be 1 within " << TableTolerance
            << ": divide its values by that number.";
    return problem.str();
  }
  target.assign(table->GetPointer(0), table->GetPointer(0) + size);
  return {};
}
}

//------------------------------------------------------------------------------
std::string vtkMediumPhaseFromMedium(
  vtkMediumScene::Medium& content, vtkParticipatingMedium* medium)
{
  content.Phase = static_cast<vtkMediumScene::Phases>(medium->GetPhaseFunction());
  std::string problem;
  switch (content.Phase)
  {
    case vtkParticipatingMedium::DoubleHenyeyGreenstein:
      problem = CheckNumber("BackAnisotropy", medium->GetBackAnisotropy(), -1, 1);
      problem =
        !problem.empty() ? problem : CheckNumber("ForwardWeight", medium->GetForwardWeight(), 0, 1);
      content.BackAnisotropy = medium->GetBackAnisotropy();
      content.ForwardWeight = medium->GetForwardWeight();
      break;
    case vtkParticipatingMedium::Draine:
      problem = CheckNumber("DraineAlpha", medium->GetDraineAlpha(), 0, LargestDraineAlpha);
      content.DraineAlpha = medium->GetDraineAlpha();
      break;
    case vtkParticipatingMedium::Droplets:
      problem = CheckNumber("DropletDiameter", medium->GetDropletDiameter(), 5, 50);
      FitDroplets(content, medium->GetDropletDiameter());
      break;
    case vtkParticipatingMedium::Tabulated:
      problem = CopyTable(content.PhaseTable, medium->GetPhaseTable());
      break;
    default:
      break;
  }
  return problem;
}
