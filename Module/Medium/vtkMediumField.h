// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumField
 * @brief One array of the input image as the renderers see it: a lattice of finite values.
 *
 * A point array has its values on the lattice of the image's points, so its first and last value lie
 * on the faces of the box. A cell array has them at cell centres, half a cell inside the faces, and
 * is constant from there to the face. NaN and -Inf count as the smallest, +Inf as the largest finite
 * value of the array, so that one bad voxel stays a bad voxel and does not poison its neighbours.
 */
#ifndef vtkMediumField_h
#define vtkMediumField_h

#include "vtkParticipatingMediumModule.h" // for the export macro

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

class VTKPARTICIPATINGMEDIUM_EXPORT vtkMediumField
{
public:
  vtkSmartPointer<vtkDataArray> Array;
  vtkMTimeType Time = 0; ///< when the array or the image that holds it was last modified
  bool OnCells = false;
  bool Linear = true;         ///< trilinear between lattice values, else the nearest one
  int FirstComponent = 0;     ///< of the array
  int Components = 1;         ///< 1 to 4, from FirstComponent on
  glm::ivec3 Dimensions{ 0 }; ///< lattice values along each axis (points, or cells)
  double Minimum = 0;         ///< smallest finite value over the components
  double Maximum = 0;         ///< largest finite value over the components

  /// Fills Minimum and Maximum from the array's finite values; false if it has none.
  bool FindRange();

  /// The largest magnitude, in which the values are at most 1 and float holds them; 1 if all are 0.
  double GetUnit() const;

  /// A lattice value, with the policy for non-finite values applied.
  double GetValue(int i, int j, int k, int component = 0) const;

  /// Lattice coordinate (0 at the first value, Dimensions-1 at the last) of a box coordinate in
  /// [0,1]^3; for cell arrays it runs from -1/2 to Dimensions-1/2.
  glm::dvec3 BoxToLattice(const glm::dvec3& box) const;

  /// The interpolated value at a box coordinate, clamped to the lattice at its border.
  glm::dvec4 Interpolate(const glm::dvec3& box) const;
};

#endif
