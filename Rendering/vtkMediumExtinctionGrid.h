// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumExtinctionGrid
 * @brief The extinction at the lattice points of a scene's medium, as bricks and light caches read it.
 *
 * Values are optical depth per local unit of length, sigma_t x vtkMediumScene::Box::Length, for a
 * DensityScale of 1: the density scale multiplies optical depths and changes no cache.
 *
 * Classifying first and interpolating afterwards equals what the renderers do, interpolating first,
 * only where extinction is an affine function of the scalar; IsAffine() says whether it is so over
 * the range of this data. Where it is not, the values are those whose interpolation is the best
 * approximation (vtkMediumExtinctionProjection) where extinction is a function of one field; else the
 * two agree at lattice points and differ in between.
 *
 * @par Lattice coordinates
 * (0,0,0) is the first value, Dimensions-1 the last. The box of a point array ends there; that of a
 * cell array ends half a cell further out, and the outermost values hold up to there.
 */
#ifndef vtkMediumExtinctionGrid_h
#define vtkMediumExtinctionGrid_h

#include "vtkMediumLatticePart.h"
#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumExtinctionGrid
{
public:
  /// Takes lattice and extinction from a scene. The lattice is that of the field that the extinction
  /// reads (the finer one, if it reads two), or 2x2x2 points for a homogeneous medium. `channel` is
  /// 0, 1 or 2: which of R, G and B, where they differ (vtkMediumScene::Medium::ChromaticExtinction).
  void Build(const vtkMediumScene& scene, int channel = 0);

  const glm::ivec3& GetDimensions() const { return this->Dimensions; }
  bool IsOnCells() const { return this->OnCells; }
  /// Whether values are interpolated trilinearly, else the nearest one holds.
  bool IsLinear() const { return this->Linear; }
  bool IsAffine() const { return this->Affine; }
  /// x runs fastest, then y.
  const std::vector<float>& GetValues() const { return this->Values; }
  float GetMinimum() const { return this->Minimum; }
  float GetMaximum() const { return this->Maximum; }
  /// The part of the values that are not 0.
  double GetOccupiedFraction() const { return this->OccupiedFraction; }
  /// The smallest part that contains them; empty if there are none.
  const vtkMediumLatticePart& GetOccupiedPart() const { return this->OccupiedPart; }

  std::size_t GetIndex(int i, int j, int k) const
  {
    return i +
      static_cast<std::size_t>(this->Dimensions.x) *
      (j + static_cast<std::size_t>(this->Dimensions.y) * k);
  }

  /// Takes away what is cut off, after Build: each value is weakened to the share of its voxel that is kept,
  /// so that optical depths along rays through a cut are right to second order in the voxel. (Leaving out
  /// lattice points is right to first order.)
  void CutAway(const vtkMediumCut& cut);

  /// Takes over a grid of trilinear data with half the points along each axis, spread over the same box; values
  /// are means of those around, weighted by their distance, so that optical depths along rays stay.
  void BuildCoarser(const vtkMediumExtinctionGrid& fine);

  /// Of a row of n values: the first that is not 0, and the one behind the last; equal if there is none.
  static glm::ivec2 FindOccupied(const float* row, int n);

  /// The interpolated value at a lattice coordinate, held constant outside the lattice.
  double Interpolate(const glm::dvec3& lattice) const;

  ///@{
  /// The faces of the box in lattice coordinates.
  glm::dvec3 GetLower() const { return glm::dvec3(this->OnCells ? -0.5 : 0.0); }
  glm::dvec3 GetUpper() const { return glm::dvec3(this->Dimensions) - (this->OnCells ? 0.5 : 1.0); }
  ///@}

  ///@{
  /// Vectors and points between lattice coordinates and local units.
  const glm::dmat3& GetLatticeToLocalAxes() const { return this->LatticeToLocalAxes; }
  const glm::dmat3& GetLocalToLatticeAxes() const { return this->LocalToLatticeAxes; }
  glm::dvec3 LatticeToLocal(const glm::dvec3& lattice) const
  {
    return this->LatticeToLocalAxes * lattice + this->LatticeToLocalOrigin;
  }
  glm::dvec3 LocalToLattice(const glm::dvec3& local) const
  {
    return this->LocalToLatticeAxes * (local - this->LatticeToLocalOrigin);
  }
  ///@}

private:
  void ChooseLattice(const vtkMediumScene& scene);
  void Project(const vtkMediumScene& scene, int channel);
  void FindStatistics();

  glm::ivec3 Dimensions{ 0 };
  bool OnCells = false;
  bool Linear = true;
  bool Affine = true;
  float Minimum = 0;
  float Maximum = 0;
  double OccupiedFraction = 0;
  vtkMediumLatticePart OccupiedPart;
  std::vector<float> Values;
  glm::dmat3 LatticeToLocalAxes{ 1 };
  glm::dmat3 LocalToLatticeAxes{ 1 };
  glm::dvec3 LatticeToLocalOrigin{ 0 };
};

#endif
