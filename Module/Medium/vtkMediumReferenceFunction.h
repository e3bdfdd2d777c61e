// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumReferenceFunction.h
 * @brief The table of a transfer function, with what a quadrature must know about its smoothness.
 *
 * Private to the module.
 */
#ifndef vtkMediumReferenceFunction_h
#define vtkMediumReferenceFunction_h

#include "vtkMediumFunction.h"

#include <vector>

class vtkMediumReferenceFunction
{
public:
  explicit vtkMediumReferenceFunction(const vtkMediumFunction& function);

  glm::dvec4 Evaluate(double value) const;
  double EvaluateAlpha(double value) const;

  /// True if rgb and alpha are affine in the value everywhere in [low, high].
  bool IsAffine(double low, double high) const;

  /// Sorted values at which the table bends: next to a knot of the function that is not itself a
  /// sample, the table bends at the samples on both sides.
  const std::vector<double>& GetKinks() const { return this->Kinks; }

  /// By how much the table lies off the smooth function between two samples, relative to its
  /// maximum. A quadrature that asks for less only chases the table's own facets.
  double GetFacetError() const { return this->FacetError; }

private:
  // The position in samples, clamped to the table.
  double GetPosition(double value) const;
  void FindKinks(const vtkMediumFunction& function);
  void FindBends();

  double Minimum;
  double PerUnit; ///< samples per unit of the value; 0 if the range is empty
  std::vector<glm::dvec4> Samples;
  std::vector<double> Alpha;
  std::vector<double> Kinks;
  std::vector<int> AffineUntil; ///< for each sample, the last one up to which the table is affine
  double FacetError = 0;
};

#endif
