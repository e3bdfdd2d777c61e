// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumEmptyDistance
 * @brief How far a ray may leap from each lattice point without missing any of the medium.
 *
 * A value is a lower bound on the Euclidean distance, in lattice steps, from any point around a lattice
 * point to the nearest cell that is not empty, such that the trilinear interpolation of the values is
 * such a bound too, and after rounding to half floats still is one. 0 means that there may be medium.
 * A ray whose lattice coordinates advance by `speed` a local unit may leap value / speed local units.
 *
 * The exact distance d is found by the separable transform of Felzenszwalb and Huttenlocher, Distance
 * Transforms of Sampled Functions (2012). Distance is 1-Lipschitz and a cell's corners lie on average
 * at most sqrt(3)/2 from a point in it, so the value is d - sqrt(3)/2, less 2^-10 of it for rounding.
 */
#ifndef vtkMediumEmptyDistance_h
#define vtkMediumEmptyDistance_h

#include "vtkMediumBricks.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumEmptyDistance
{
public:
  /// The largest value, also where nothing is in the whole lattice.
  static constexpr float Maximum = 1024;

  /// Bricks are of the same scene and grid. Inside bricks that are not empty, cells are told apart one
  /// by one where extinction depends on one field and there is no emission; where extinction is not
  /// affine in the scalar, by its range over each cell.
  void Build(const vtkMediumScene& scene, const vtkMediumExtinctionGrid& grid,
    const vtkMediumBricks& bricks);

  /// By lattice point, in the order of the grid's values.
  const std::vector<float>& GetValues() const { return this->Values; }

  /// Whether any lattice point has a value > 0. Where not, leaping gains nothing.
  bool CanLeap() const { return this->Leaps; }

private:
  std::vector<float> Values;
  bool Leaps = false;
};

#endif
