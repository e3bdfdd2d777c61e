// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpaquePlane.h
 * @brief Opaque geometry with a closed form: a plane.
 */
#ifndef OpaquePlane_h
#define OpaquePlane_h

#include "ClosedForms.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"

namespace vtkMediumTest
{
/// An opaque plane, the points with dot(point, normal) = offset, wide enough for every view.
struct Plane
{
  glm::dvec3 Normal;
  double Offset;

  double Hit(const Ray& ray) const
  {
    return (this->Offset - glm::dot(ray.Origin, this->Normal)) /
      glm::dot(ray.Direction, this->Normal);
  }

  vtkSmartPointer<vtkActor> AddTo(vtkRenderer* renderer) const
  {
    const glm::dvec3 a = glm::normalize(glm::cross(this->Normal, glm::dvec3(0, 1, 0)));
    const glm::dvec3 b = glm::cross(this->Normal, a);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const glm::dvec2& corner : { glm::dvec2(-1, -1), { 1, -1 }, { 1, 1 }, { -1, 1 } })
    {
      const glm::dvec3 p = this->Offset * this->Normal + 2.0 * (corner.x * a + corner.y * b);
      points->InsertNextPoint(p.x, p.y, p.z);
    }
    vtkNew<vtkCellArray> quads;
    quads->InsertNextCell({ 0, 1, 2, 3 });
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(points);
    surface->SetPolys(quads);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
    return actor;
  }
};
}

#endif
