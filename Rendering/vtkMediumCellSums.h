// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumCellSums
 * @brief Exact sums of a grid's extinction along rays, cell by cell, in float and past empty bricks.
 *
 * The same two-point Gauss-Legendre rule as vtkMediumExtendedOpticalDepth, for millions of calls.
 * Values on the faces of the lattice hold outside of it. The grid must outlive this object.
 */
#ifndef vtkMediumCellSums_h
#define vtkMediumCellSums_h

#include "vtkMediumExtinctionGrid.h"

#include <cstddef>
#include <vector>

class vtkMediumCellSums
{
public:
  explicit vtkMediumCellSums(const vtkMediumExtinctionGrid& grid);

  /// The integral over t in [first, last] of the extinction at origin + t step (lattice coordinates);
  /// times the local length of `step` it is an optical depth.
  double Integrate(
    const glm::dvec3& origin, const glm::dvec3& step, double first, double last) const;

  /// Whether two lattice coordinates are in one brick and it is empty: then so is the way between them.
  bool IsEmptyBetween(const glm::dvec3& a, const glm::dvec3& b) const;

private:
  std::ptrdiff_t BrickOf(const glm::dvec3& at) const;
  void MarkSlab(int brickZ);
  double IntegrateCell(const int cell[3], const double from[3], const double way[3]) const;

  const float* Values;
  glm::ivec3 Dimensions;
  std::ptrdiff_t StrideY, StrideZ;
  bool Linear;
  glm::ivec3 Bricks;
  std::vector<unsigned char> Occupied; ///< bricks of 8^3 cells with a value other than 0
};

#endif
