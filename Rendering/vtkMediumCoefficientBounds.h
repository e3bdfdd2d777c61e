// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumCoefficientBounds
 * @brief The least and the largest value of a coefficient over an interval of its scalar.
 *
 * The minima and maxima over 2^k neighbouring samples of the transfer function are tabulated for every
 * k (a sparse table), so an interval of any width costs two look-ups and its two ends. The function is
 * piecewise linear between its samples, so the bounds are tight, and no voxel is read.
 */
#ifndef vtkMediumCoefficientBounds_h
#define vtkMediumCoefficientBounds_h

#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <glm/vec2.hpp>

#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumCoefficientBounds
{
public:
  /// Tabulates a coefficient of the medium. R, G and B are bounded together.
  void Build(const vtkMediumScene::Medium& medium, const vtkMediumScene::Coefficient& coefficient);

  /// The field whose values the intervals are of; -1: the coefficient is the same everywhere.
  int GetFieldIndex() const { return this->FieldIndex; }
  /// The first and the last component of that field that take part.
  int GetFirstComponent() const { return this->FirstComponent; }
  int GetLastComponent() const { return this->LastComponent; }

  /// (least, largest) over scalars in [range.x, range.y].
  glm::dvec2 Evaluate(const glm::dvec2& range) const;

private:
  glm::dvec2 EvaluateSamples(double position) const;

  int FieldIndex = -1;
  int FirstComponent = 0, LastComponent = 0;
  glm::dvec2 Scales{ 0 };          ///< least and largest of the coefficient's scale
  double Minimum = 0, Maximum = 0; ///< the function's range
  /// [k][i]: (least, largest) of the scaled channels over samples i … i + 2^k - 1; none: no function.
  std::vector<std::vector<glm::dvec2>> Levels;
};

#endif
