// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The shadow that the medium casts on points of geometry.
#include "vtkMediumOpticalDepth.h"
#include "vtkSingleScatteringReferenceGathered.h"

#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"

#include <glm/exponential.hpp>

#include <algorithm>
#include <limits>

//------------------------------------------------------------------------------
bool vtkSingleScatteringReference::LightTransmittance(
  vtkLight* light, vtkPoints* points, vtkDoubleArray* transmittance)
{
  if (!light || !points || !transmittance)
  {
    vtkErrorMacro(<< "The "
                  << (!light       ? "light"
                         : !points ? "points"
                                   : "array to fill")
                  << " of LightTransmittance is missing; give it a vtkLight, vtkPoints and a "
                     "vtkDoubleArray.");
    return false;
  }
  if (!this->Gather(false))
  {
    return false;
  }
  const vtkMediumScene& scene = this->Scene->Facts;
  vtkMediumScene::Light source;
  std::string problem = scene.ReadLight(this->Renderer, light, source);
  const vtkIdType count = points->GetNumberOfPoints();
  for (vtkIdType id = 0; id < count && problem.empty(); ++id)
  {
    double local[3];
    problem = this->FindPlace(points->GetPoint(id), local);
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  const vtkMediumOpticalDepth depth(scene, this->Scene->Content, this->Tolerance);
  transmittance->SetNumberOfComponents(3);
  transmittance->SetNumberOfTuples(count);
  if (!transmittance->GetName())
  {
    transmittance->SetName("LightTransmittance");
  }
  double* values = transmittance->GetPointer(0);
  vtkSMPTools::For(0, count, [&](vtkIdType first, vtkIdType last) {
    for (vtkIdType id = first; id < last; ++id)
    {
      glm::dvec3 world;
      points->GetPoint(id, &world[0]);
      const glm::dvec3 local = scene.Geometry.WorldToLocal(world);
      const glm::dvec3 passed = glm::exp(-(source.Type == vtkMediumScene::Light::Directional
          ? depth.Evaluate(local, -source.Direction, 0, std::numeric_limits<double>::infinity())
          : depth.EvaluateBetween(local, source.Position)));
      std::copy(&passed[0], &passed[0] + 3, values + 3 * id);
    }
  });
  transmittance->Modified();
  return true;
}
