// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The shadow that the medium casts on points of geometry.
#include "vtkMediumOpticalDepth.h"
#include "vtkMediumReferenceLight.h"
#include "vtkSingleScatteringReferenceGathered.h"

#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"

#include <glm/exponential.hpp>

#include <algorithm>

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
  const std::string problem = scene.ReadLight(this->Renderer, light, source);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  const vtkMediumOpticalDepth depth(scene, this->Scene->Content, this->Tolerance);
  const vtkIdType count = points->GetNumberOfPoints();
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
      const vtkMediumIncidentLight incident = vtkMediumReferenceLight(source, local);
      const glm::dvec3 passed =
        glm::exp(-depth.Evaluate(local, -incident.Direction, 0, incident.Distance));
      std::copy(&passed[0], &passed[0] + 3, values + 3 * id);
    }
  });
  transmittance->Modified();
  return true;
}
