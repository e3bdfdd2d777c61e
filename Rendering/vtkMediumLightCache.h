// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumLightCache
 * @brief Optical depth from one light at every lattice point of the medium, and what a shader looks up.
 *
 * Directional lights are exact (vtkMediumLightStencil). Point and spot lights, outside the box or
 * inside of it, go along light-aligned rays (vtkMediumLightRays) with the estimated error of exp(-tau)
 * held below Tolerance at every lattice point.
 *
 * Optical depths are for a DensityScale of 1 and know no colour, albedo or phase function: only the
 * grid and the light's pose count. They are promised within two lattice steps of extinction > 0, where
 * interpolation can meet them with their neighbours; elsewhere they may be
 * vtkMediumLightStencil::Unknown, which counts as a transmittance of 1.
 *
 * @par Memory
 * 4 bytes a lattice point are kept. While building, a directional light needs up to 5 more at 256^3
 * (a padded copy of the rows that are not empty); point and spot lights need 8 bytes a ray of one
 * pyramid, which is little. A caller that cannot afford this renders without a cache, with light rays.
 *
 * @par Prefiltering
 * A trilinear lookup of S = exp(-tau) errs by 1/8 of the sum of its second differences at most, and by
 * 1/12 of them on average over a cell, always to the same side. That mean error is taken off in advance,
 * so that what is left averages out along a ray. The result may be a little outside of [0, 1].
 *
 * @par Roughness
 * How far a lookup may err is a lattice function too: 1/8 of the sum of the magnitudes of the second
 * differences, and 1 where nothing is known. (On the faces of the lattice those across them are the next
 * ones inside.) A shader that reads it beside the transmittance sums what the look-ups of a pixel may err by
 * (Shaders/vtkMediumLightCache.glsl); where that is too much, another marches each light ray until its cache
 * can be trusted (Shaders/vtkMediumLightMarchToCache.glsl).
 */
#ifndef vtkMediumLightCache_h
#define vtkMediumLightCache_h

#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumLatticePart.h"
#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <cstdint>
#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumLightCache
{
public:
  /// The largest estimated error of exp(-tau) at a lattice point that Build leaves, for point and spot
  /// lights. Default: half an 8-bit step. Values below rounding, about 1e-6, make every point
  /// exact, at O(N^4).
  void SetTolerance(double tolerance) { this->Tolerance = tolerance; }
  double GetTolerance() const { return this->Tolerance; }

  /// Computes the optical depths anew.
  void Build(const vtkMediumExtinctionGrid& grid, const vtkMediumScene::Light& light);

  /// Whether two lights cast the same shadows: type, position, direction and cone are equal.
  static bool HaveSamePose(const vtkMediumScene::Light& a, const vtkMediumScene::Light& b);

  /// Optical depths in the order of the grid's values.
  const std::vector<float>& GetOpticalDepths() const { return this->Depths; }

  /// Writes the prefiltered transmittance exp(-densityScale tau) of a part of the lattice as half floats,
  /// target[i * stride] for its point i, x fastest, and right after each its roughness if asked for.
  void Pack(double densityScale, const vtkMediumLatticePart& part, bool withRoughness,
    std::uint16_t* target, std::size_t stride) const;

  ///@{
  /// The same as floats, one for each lattice point.
  std::vector<float> GetTransmittance(double densityScale) const;
  std::vector<float> GetRoughness(double densityScale) const;
  ///@}

  /// How often Build ran, since creation.
  int GetNumberOfBuilds() const { return this->Builds; }
  /// Lattice points that the last Build gave a ray of their own.
  long long GetNumberOfMarches() const { return this->Marches; }

private:
  template <typename Write>
  void FilterSlices(double densityScale, const vtkMediumLatticePart& part, int begin, int end,
    const Write& write) const;

  double Tolerance = 0.5 / 255;
  glm::ivec3 Dimensions{ 0 };
  std::vector<float> Depths;
  int Builds = 0;
  long long Marches = 0;
};

#endif
