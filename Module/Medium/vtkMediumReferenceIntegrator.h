// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumReferenceIntegrator.h
 * @brief Single scattering along a ray, to a tolerance.
 *
 * Private to the module. The ray is cut at the cell faces of every lattice, where a transfer function
 * bends, at a light's nearest point and at the edge of its cone. A piece is integrated with 6 against
 * 8 Gauss-Legendre points (3 against 4 at a first look) and bisected until they agree; also where an
 * exponential of the piece is too steep for any of these to see. The source has further kinks, where
 * its light ray passes an edge of the lattice: the bisection finds those.
 */
#ifndef vtkMediumReferenceIntegrator_h
#define vtkMediumReferenceIntegrator_h

#include "vtkMediumOpticalDepth.h"

class vtkMediumReferenceIntegrator
{
public:
  /// `tolerance` is relative to the peak. The scene and the content must outlive the integrator.
  vtkMediumReferenceIntegrator(
    const vtkMediumScene& scene, const vtkMediumReferenceContent& content, double tolerance);

  struct Result
  {
    glm::dvec3 Radiance{ 0 };
    glm::dvec3 OpticalDepth{ 0 };
  };

  /// Radiance to within tolerance x peak along origin + t direction (unit), begin <= t <= end, local
  /// units. Where the peak is 0, that of the ray itself is taken.
  Result Evaluate(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
    double peak) const;

  /// The same at a fixed order, without bisection: for an idea of the peak.
  Result Estimate(
    const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end) const;

  const vtkMediumOpticalDepth& GetOpticalDepth() const { return this->Depth; }

private:
  struct Ray;
  struct Piece;
  struct LightRange;
  struct Kinks;
  Result Integrate(Ray& ray, double begin, double end) const;
  void IntegrateCell(Ray& ray, const vtkMediumRayCells& cells, const Kinks& kinks,
    double wholeLength, Result& result) const;
  glm::dvec3 IntegratePiece(
    const Piece& piece, double u0, double u1, const glm::dvec3& depth0, int level) const;
  glm::dvec3 Source(const Piece& piece, double u) const;
  template <int N>
  glm::dvec3 Sum(const Piece& piece, double u0, double u1) const;

  const vtkMediumScene& Scene;
  const vtkMediumReferenceContent& Content;
  double Tolerance;
  vtkMediumOpticalDepth Depth;
};

#endif
