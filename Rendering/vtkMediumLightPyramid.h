// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumLightPyramid
 * @brief The rays of a light around one axis of the lattice: vtkMediumLightRays has the method.
 *
 * Coordinates: W is the lattice axis along which rays go from plane to plane, U and V the lateral
 * ones; depth D is the distance along W from the apex (point lights) or from the first plane
 * (directional lights). A ray (a, b) is at U = OriginsU[a] + SlopesU[a] D, and likewise in V.
 */
#ifndef vtkMediumLightPyramid_h
#define vtkMediumLightPyramid_h

#include "vtkMediumCellSums.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumOccupiedRows.h"

#include <glm/vec2.hpp>

#include <atomic>
#include <cstddef>
#include <vector>

class vtkMediumLightPyramid
{
public:
  /// The rays along one axis, towards larger (sign 1) or smaller (-1) lattice coordinates. Grid and
  /// sums must outlive the pyramid.
  vtkMediumLightPyramid(
    const vtkMediumExtinctionGrid& grid, const vtkMediumCellSums& sums, int axis, int sign);

  /// The largest error of exp(-tau) that interpolation may have by its own estimate; points beyond it
  /// get a ray of their own.
  void SetTolerance(double tolerance) { this->Tolerance = static_cast<float>(tolerance); }

  /// For a point light at a lattice coordinate. False if no lattice point is in this pyramid.
  bool SetApex(const glm::dvec3& apex, double density);

  /// For a directional light that travels along a lattice vector.
  void SetDirection(const glm::dvec3& direction, double density);

  /// Restricts the rays to those near a cone around a local direction.
  void SetCone(const glm::dvec3& direction, double cosine);

  /// Carries the rays through the box and writes the optical depths of this pyramid's points.
  void March(const vtkMediumOccupiedRows& rows, std::vector<float>& tau);

  /// Lattice points that got a ray of their own.
  long long GetMarches() const { return this->Marches; }

private:
  /// One lateral axis.
  struct Lateral
  {
    int Axis = 0;
    int Points = 0;
    std::ptrdiff_t Stride = 1;   ///< of the grid's values
    double Lower = 0, Upper = 0; ///< faces of the box
    std::vector<double> Origins, Slopes;
    std::vector<double> Entries; ///< depth at which the ray enters; -1: not through this axis
    std::vector<int> FirstPlanes, LastPlanes; ///< between which the ray is near the box
    double FirstRay = 0; ///< the first ray's slope (point), or its place at depth 0 (directional)
    double Spacing = 1;  ///< between rays, at depth 1 for a point light
    double Apex = 0;     ///< of a point light
    double Drift = 0;    ///< slope of the rays of a directional light
  };

  double DepthOf(int plane) const { return this->FirstDepth + plane; }
  int IndexOf(int plane) const { return this->FirstIndex + this->Sign * plane; }
  void PlaceRays(Lateral& lateral, double first, double last);
  void FindLives(Lateral& lateral) const;
  bool IsLit(const glm::dvec3& step) const;
  glm::dvec3 StepOf(int a, int b) const;
  glm::dvec3 RayAt(int a, int b, int plane) const;
  double EnterRay(int a, int b, int plane) const;
  float MarchPoint(const glm::ivec3& point) const;
  void AdvanceRow(int b, int plane);
  glm::ivec2 PointsOfRow(int v, int plane, const vtkMediumOccupiedRows& rows) const;
  void InterpolateRow(
    int v, int plane, const vtkMediumOccupiedRows& rows, std::vector<float>& tau) const;
  double RayIndex(const Lateral& lateral, int point, double depth) const;

  const vtkMediumExtinctionGrid& Grid;
  const vtkMediumCellSums& Sums;
  int AxisW, Sign;
  float Tolerance = 0;
  bool Directional = false;
  Lateral U, V;
  std::ptrdiff_t StrideW = 1;
  int PointsW = 0;
  double ApexW = 0;
  double EntryW = -1; ///< depth of the face of W through which rays enter; -1: the light is inside
  int FirstIndex = 0; ///< lattice index of the first plane
  int Planes = 0;
  double FirstDepth = 0; ///< of the first plane
  glm::dvec3 ConeDirection{ 0 };
  double ConeCosine = -2; ///< below -1: no cone
  mutable std::atomic<long long> Marches{ 0 };
  std::vector<float> Depths;  ///< optical depth of each ray at the current plane
  std::vector<float> Lengths; ///< local length of each ray between two planes
};

#endif
