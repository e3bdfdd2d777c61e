// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OpaquePlane.h
 * @brief Opaque geometry with a closed form: a parallelogram, a plane.
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
/// An opaque parallelogram: Corner + u U + v V, u and v in [0, 1].
struct Quad
{
  glm::dvec3 Corner, U, V;

  vtkSmartPointer<vtkActor> AddTo(vtkRenderer* renderer) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const glm::dvec3& p : { this->Corner, this->Corner + this->U,
           this->Corner + this->U + this->V, this->Corner + this->V })
    {
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
    return Quad{ this->Offset * this->Normal - 2.0 * (a + b), 4.0 * a, 4.0 * b }.AddTo(renderer);
  }
};
}

#endif
