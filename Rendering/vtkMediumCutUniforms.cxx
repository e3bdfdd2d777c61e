// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumCutUniforms.h"

#include "vtkMediumPlan.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// The volume is within 1/2 of the local origin: planes farther away than this are never met, and their
// distance fits a float.
constexpr double FarthestPlane = 16;

//------------------------------------------------------------------------------
void Write(const vtkMediumCut::Plane& plane, float* numbers)
{
  for (int c = 0; c < 3; ++c)
  {
    numbers[c] = static_cast<float>(plane.Normal[c]);
  }
  numbers[3] = static_cast<float>(std::clamp(plane.Offset, -FarthestPlane, FarthestPlane));
}
}

//------------------------------------------------------------------------------
void vtkMediumSetCutUniforms(vtkShaderProgram* program, const vtkMediumCut& cut)
{
  float planes[vtkMediumPlan::MostClippingPlanes][4];
  const int count = static_cast<int>(cut.Planes.size());
  for (int i = 0; i < count; ++i)
  {
    Write(cut.Planes[i], planes[i]);
  }
  if (count > 0)
  {
    program->SetUniform4fv("clippingPlanes", count, planes);
  }
  if (cut.CutsRegions())
  {
    float lower[3][4], upper[3][4];
    for (int axis = 0; axis < 3; ++axis)
    {
      Write(cut.Lower[axis], lower[axis]);
      Write(cut.Upper[axis], upper[axis]);
    }
    program->SetUniform4fv("croppingLower", 3, lower);
    program->SetUniform4fv("croppingUpper", 3, upper);
    program->SetUniformi("croppingRegions", cut.Regions);
  }
}
