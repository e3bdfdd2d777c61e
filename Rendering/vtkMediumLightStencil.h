// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumLightStencil
 * @brief Optical depth from a directional light at every lattice point, exact for the grid's data.
 *
 * Parallel rays from lattice points cross the cells around them in one and the same pattern. The
 * two-point Gauss-Legendre sums of vtkMediumOpticalDepth, which are exact cell by cell, are therefore
 * one fixed list of weights on lattice offsets, about 8 N of them, that is summed along rows.
 *
 * A ray may leave the box before its pattern ends. It does so on a lattice plane (half a cell beyond
 * the last one for cell arrays), so only offsets that land on an exit face are affected; each entry
 * carries the weight that remains of it there, for every combination of axes.
 *
 * @par Order
 * Rows are summed along rays, not in the order of the lattice, so that their sources stay in the
 * processor's cache. The results are the same to the last bit.
 */
#ifndef vtkMediumLightStencil_h
#define vtkMediumLightStencil_h

#include "vtkMediumExtinctionGrid.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <glm/vec2.hpp>

#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumLightStencil
{
public:
  /// Stands for an optical depth that was not computed; less than any that was.
  static constexpr float Unknown = -1;

  /// The weight of the lattice value at an offset from the point where optical depth is wanted.
  /// Bit q of the index into Weights says that the offset lands on the face of axis q through which
  /// rays leave the box.
  struct Entry
  {
    int X = 0, Y = 0, Z = 0;
    float Weights[8] = {};
  };

  /// Computes the entries for a light that travels along `direction` (local space, unit).
  void Build(const vtkMediumExtinctionGrid& grid, const glm::dvec3& direction);

  const std::vector<Entry>& GetEntries() const { return this->Entries; }

  /// Writes the optical depths at the lattice points of `grid`, the one of Build or one with the same
  /// lattice. Only points within `reach` lattice steps of extinction > 0 along each axis are promised,
  /// others are Unknown; a negative reach computes all.
  void Apply(const vtkMediumExtinctionGrid& grid, int reach, std::vector<float>& tau) const;

private:
  void SumWeights(const vtkMediumExtinctionGrid& grid, const glm::dvec3& step, double last);

  std::vector<Entry> Entries;        ///< sorted by z, y, x
  int ExitPlane[3] = { -1, -1, -1 }; ///< lattice index of the exit face along each axis; -1: none
  glm::dvec2 StepYZ{ 0 };            ///< towards the light, in lattice steps a local unit of length
};

#endif
