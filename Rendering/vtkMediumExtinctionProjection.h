// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumExtinctionProjection
 * @brief Makes lattice values of an extinction cast the shadow of a function of the interpolated scalar.
 *
 * Renderers interpolate the scalar and then apply the function; a lattice of extinctions is the other way
 * round, and where the function bends within a cell the two differ, always to the same side: a dense
 * material behind a threshold grows by a part of a voxel. Here the difference d of the two is projected
 * to the trilinear functions on the lattice, in the sense of least squares: the averages of d under the
 * hat functions, times the inverse of the hats' mass matrix to first order, 1 - (1/6) sum of the second
 * differences. Optical depths along rays then agree on average. Cells over which the function is straight are left
 * alone.
 */
#ifndef vtkMediumExtinctionProjection_h
#define vtkMediumExtinctionProjection_h

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

class vtkMediumExtinctionProjection
{
public:
  /// Tabulates the extinction by the scalar, over the scalar's range.
  vtkMediumExtinctionProjection(
    double minimum, double maximum, const std::function<double(double)>& extinction);

  /// Adds the projected difference to extinctions at the points of a lattice (x runs fastest), which
  /// interpolates `scalars`. Results stay >= 0.
  void Apply(const glm::ivec3& dimensions, const std::vector<float>& scalars,
    std::vector<float>& extinctions) const;

private:
  bool Bends(float least, float largest) const;
  float Evaluate(float scalar) const;
  bool AverageCell(const float scalars[8], float averages[8]) const;
  void AverageLayer(const glm::ivec3& dimensions, const std::vector<float>& scalars, int layer,
    std::vector<float>& averages) const;

  float Minimum = 0;
  float Scale = 0; ///< table intervals a unit of the scalar
  std::vector<float> Table;
  std::vector<float> Turns; ///< changes of slope up to each entry, of the largest value an interval
};

#endif
