// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumShadowEdges.h
 * @brief Where along an eye ray the light ray sweeps over an edge, so that its optical depth bends.
 *
 * Private to the module. Two kinds of edges bend it so sharply that a quadrature between them is blind
 * to some: those of the box, and those between voxels of different value under nearest interpolation.
 * (Across the edges of a trilinear field only the third derivative jumps.) The edge, the light and the
 * eye ray's point at the bend are in one plane, which is a linear equation for the point.
 */
#ifndef vtkMediumShadowEdges_h
#define vtkMediumShadowEdges_h

#include "vtkMediumReferenceContent.h"

#include <vector>

class vtkMediumShadowEdges
{
public:
  /// `ray` is the eye ray. The content must outlive this.
  vtkMediumShadowEdges(const vtkMediumReferenceContent& content, const vtkMediumScene::Box& box,
    const vtkMediumScene::Light& light, const vtkMediumBoxRay& ray);

  /// Appends the positions in (begin, end) where the light ray sweeps over an edge of the box.
  void AppendBoxEdges(double begin, double end, std::vector<double>& cuts) const;

  /// Appends those where it sweeps over an edge between unequal voxels of a nearest field that
  /// extinction depends on. The eye ray must stay in one voxel between begin and end.
  void AppendVoxelEdges(double begin, double end, std::vector<double>& cuts) const;

private:
  // The geometry with faces at the integers: an eye ray and a light, in some lattice's coordinates.
  struct Sweep
  {
    glm::dvec3 Begin, End; ///< of the eye ray's piece
    bool Positional;
    glm::dvec3 Light; ///< its position, or the way towards it

    glm::dvec3 ToLight(const glm::dvec3& at) const
    {
      return this->Positional ? this->Light - at : this->Light;
    }
    bool Cross(int u, double i, double j, double& fraction, double& height) const;
  };
  Sweep MakeSweep(const glm::dvec3& scale, double offset, double begin, double end) const;
  void AppendVoxelEdges(const vtkMediumLatticeValues& values, const Sweep& sweep, int u,
    double begin, double end, std::vector<double>& cuts) const;

  const vtkMediumReferenceContent& Content;
  vtkMediumBoxRay Ray;
  bool Positional;
  glm::dvec3 Light; ///< box coordinates: its position, or the way towards it
};

#endif
