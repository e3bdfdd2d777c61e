// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumCellWalk.h
 * @brief Where a straight line crosses the cell faces of a lattice.
 *
 * Private to the module. A lattice is where the values of a field are: at the image's points or at
 * its cell centres, interpolated linearly or by the nearest value. Between two faces a linear field
 * is trilinear, so a cubic along a line; a nearest field is constant. Coordinates are chosen such
 * that the faces are at the integers for both.
 */
#ifndef vtkMediumCellWalk_h
#define vtkMediumCellWalk_h

#include "vtkMediumField.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

struct vtkMediumLattice
{
  glm::ivec3 Dimensions{ 1 };
  bool OnCells = false;
  bool Linear = true;

  vtkMediumLattice() = default;
  explicit vtkMediumLattice(const vtkMediumField& field)
    : Dimensions(field.Dimensions)
    , OnCells(field.OnCells)
    , Linear(field.Linear)
  {
  }

  bool operator==(const vtkMediumLattice& other) const
  {
    return this->Dimensions == other.Dimensions && this->OnCells == other.OnCells &&
      this->Linear == other.Linear;
  }

  /// Face coordinates are GetScale() * box + GetOffset().
  glm::dvec3 GetScale() const
  {
    return glm::dvec3(this->OnCells ? this->Dimensions : this->Dimensions - 1);
  }
  double GetOffset() const { return (this->OnCells ? -0.5 : 0.0) + (this->Linear ? 0.0 : 0.5); }
};

/// Walks along origin + t direction (box coordinates) from one cell to the next.
class vtkMediumCellWalk
{
public:
  vtkMediumCellWalk() = default;
  vtkMediumCellWalk(const vtkMediumLattice& lattice, const glm::dvec3& boxOrigin,
    const glm::dvec3& boxDirection, double start)
    : Origin(lattice.GetScale() * boxOrigin + lattice.GetOffset())
    , Direction(lattice.GetScale() * boxDirection)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // What moves less than this across the box does not move; its inverse would overflow.
      this->Direction[axis] = std::abs(this->Direction[axis]) < 1e-30 ? 0 : this->Direction[axis];
      // Twice the lattice is beyond any position that is asked for, and safe to convert.
      const double reach = 2.0 * lattice.Dimensions[axis] + 2;
      const double position =
        glm::clamp(this->Origin[axis] + start * this->Direction[axis], -reach, reach);
      this->Cell[axis] = static_cast<int>(glm::floor(position));
      this->Inverse[axis] = this->Direction[axis] != 0 ? 1 / this->Direction[axis] : 0;
      this->FindCrossing(axis);
    }
  }

  /// The cell's lower face on each axis; from -1 (the half cell before the first value) on.
  const glm::ivec3& GetCell() const { return this->Cell; }

  /// The parameter at which the line leaves the cell; infinite if it never does.
  double GetExit() const
  {
    return std::min({ this->Crossing.x, this->Crossing.y, this->Crossing.z });
  }

  /// Steps across every face that lies at or before `t`.
  void Advance(double t)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      while (this->Crossing[axis] <= t)
      {
        this->Cell[axis] += this->Direction[axis] > 0 ? 1 : -1;
        this->FindCrossing(axis);
      }
    }
  }

  /// The position within the cell, each coordinate 0 to 1, is GetFraction() + t GetSlope().
  glm::dvec3 GetFraction() const { return this->Origin - glm::dvec3(this->Cell); }
  const glm::dvec3& GetSlope() const { return this->Direction; }

private:
  // From the face's own coordinate, so that no error is carried from face to face.
  void FindCrossing(int axis)
  {
    const double face = this->Cell[axis] + (this->Direction[axis] > 0 ? 1.0 : 0.0);
    this->Crossing[axis] = this->Direction[axis] != 0
      ? (face - this->Origin[axis]) * this->Inverse[axis]
      : std::numeric_limits<double>::infinity();
  }

  glm::dvec3 Origin{ 0 };
  glm::dvec3 Direction{ 0 };
  glm::dvec3 Inverse{ 0 };
  glm::dvec3 Crossing{ std::numeric_limits<double>::infinity() };
  glm::ivec3 Cell{ 0 };
};

#endif
