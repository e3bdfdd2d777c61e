// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumOpticalDepth.h
 * @brief The optical depth between two points of the medium, cell by cell.
 *
 * Private to the module. Most of the reference's time is spent here, so an extinction that one field
 * gives, alone or through a function, has its own loop; everything else takes the general walk.
 */
#ifndef vtkMediumOpticalDepth_h
#define vtkMediumOpticalDepth_h

#include "vtkMediumReferenceContent.h"

class vtkMediumOpticalDepth
{
public:
  /// `tolerance`: absolute, of the whole depth; only quadratures through a function need it.
  vtkMediumOpticalDepth(
    const vtkMediumScene& scene, const vtkMediumReferenceContent& content, double tolerance);

  /// The optical depth of each channel along a ray from `begin` to `end`, lengths in local units.
  /// What lies outside the box or is cut away is empty.
  glm::dvec3 Evaluate(
    const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end) const;

  /// The same between two points. It is the same both ways, so it starts at the nearer point, whose place
  /// on the ray is the more exact.
  glm::dvec3 EvaluateBetween(const glm::dvec3& a, const glm::dvec3& b) const;

  /// The same from begin + u0 to begin + u1 in a cell that is at hand, without a kink in between.
  glm::dvec3 EvaluateInCell(
    const vtkMediumRayCells& cells, double begin, double u0, double u1) const
  {
    return cells.OpticalDepth(begin, u0, u1, this->Tolerance, this->Box.Length);
  }

private:
  glm::dvec3 SumOfPart(const vtkMediumBoxRay& ray, double begin, double end) const;
  double SumOfField(const vtkMediumBoxRay& ray, double begin, double end) const;
  double SumOfFunction(const vtkMediumBoxRay& ray, double begin, double end) const;
  double IntegrateFunction(const double corners[8], const glm::dvec3& fraction,
    const glm::dvec3& slope, double a, double b, std::vector<double>& cuts) const;
  glm::dvec3 SumOfAny(const vtkMediumBoxRay& ray, double begin, double end) const;

  const vtkMediumReferenceContent& Content;
  const vtkMediumScene::Box& Box;
  const vtkMediumCut& Cut;
  double Tolerance;
  int Component = -1; ///< of the one grey field that extinction reads; -1: it reads something else
  const vtkMediumReferenceFunction* Function = nullptr;
};

#endif
