// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumReferenceContent.h
 * @brief The medium of a scene as the reference reads it, and a walk along a ray through its cells.
 *
 * Private to the module. Positions along a ray are lengths in local units; coefficients are per world
 * unit.
 */
#ifndef vtkMediumReferenceContent_h
#define vtkMediumReferenceContent_h

#include "vtkMediumCubic.h"
#include "vtkMediumGaussLegendre.h"
#include "vtkMediumLatticeValues.h"
#include "vtkMediumReferenceFunction.h"
#include "vtkMediumScene.h"

#include <memory>
#include <vector>

/// A ray in box coordinates per local unit of length.
struct vtkMediumBoxRay
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;

  vtkMediumBoxRay(
    const vtkMediumScene::Box& box, const glm::dvec3& origin, const glm::dvec3& direction)
    : Origin(box.LocalToBox(origin))
    , Direction(box.LocalToBoxAxes * direction)
  {
  }

  /// Shrinks [begin, end] to what lies in the box; false if nothing does.
  bool Clip(double& begin, double& end) const;
};

class vtkMediumReferenceContent
{
public:
  /// Reads the scene's content. The copies of arrays are kept while they are the same.
  void Update(const vtkMediumScene& scene);

  const vtkMediumScene::Medium& GetMedium() const { return this->Medium; }
  /// The fields that coefficients read, those of the extinction first; the coefficients of
  /// GetMedium() count them in this order.
  const vtkMediumLatticeValues& GetValues(int field) const { return *this->Values[field]; }
  int GetNumberOfFields() const { return static_cast<int>(this->Values.size()); }
  int GetNumberOfExtinctionFields() const { return this->ExtinctionFields; }

  const vtkMediumReferenceFunction& GetFunction(int index) const { return this->Functions[index]; }

  /// True if the extinction is a polynomial of degree 3 along a line within a cell.
  bool IsExtinctionCubic() const { return this->ExtinctionCubic; }

  /// The largest FacetError of the functions; 0 without any.
  double GetFacetError() const { return this->FacetError; }

  /// The component of its field that a grey coefficient reads, or -1 if it reads three.
  int GetGreyComponent(const vtkMediumScene::Coefficient& coefficient) const;

  vtkMediumScene::Coefficients Evaluate(const glm::dvec4* fields) const;
  glm::dvec3 EvaluateExtinction(const glm::dvec4* fields) const;

private:
  glm::dvec3 EvaluateCoefficient(
    const vtkMediumScene::Coefficient& coefficient, const glm::dvec4* fields) const;
  glm::dvec3 EvaluateExtinction(const glm::dvec4* fields, glm::dvec3& scattering) const;
  double EvaluateDensity(const glm::dvec4* fields) const;

  vtkMediumScene::Medium Medium;
  std::vector<std::unique_ptr<vtkMediumLatticeValues>> Values;
  std::vector<vtkMediumReferenceFunction> Functions;
  int ExtinctionFields = 0;
  bool ExtinctionCubic = true;
  double FacetError = 0;
};

/// The cells that a ray passes, one after the other, over all lattices of some fields at once.
class vtkMediumRayCells
{
public:
  /// At most so many fields: one for each of extinction, scattering, emission and anisotropy, and masks on
  /// points and on cells.
  static constexpr int MaximumFields = 6;

  /// Over the first `fields` fields of the content.
  vtkMediumRayCells(const vtkMediumReferenceContent& content, int fields,
    const vtkMediumBoxRay& ray, double begin, double end);

  /// Goes to the next piece of the ray within one cell of every lattice; false after the last.
  bool Next();

  double GetBegin() const { return this->Begin; }
  double GetEnd() const { return this->End; }

  /// The coefficients at a position within the current cell.
  vtkMediumScene::Coefficients Evaluate(double t) const;
  glm::dvec3 EvaluateExtinction(double t) const;

  /// Appends the positions in the current cell where a function of a field bends.
  void AppendKinks(std::vector<double>& cuts) const;

  /// The optical depth of each channel from begin + u0 to begin + u1; both within the current cell,
  /// and no kink between them. Exact, or to the given absolute tolerance. `length`: world units per
  /// local unit. u0 and u1 may be far below the resolution of `begin`.
  glm::dvec3 OpticalDepth(
    double begin, double u0, double u1, double tolerance, double length) const;

private:
  struct Field
  {
    int Components;
    bool Linear;
    vtkMediumCellWalk Walk;
    glm::dvec3 Fraction;
    double Corners[4][8];
  };

  void Interpolate(double t, glm::dvec4* values) const;
  double InterpolateComponent(const Field& field, int component, double t) const;

  const vtkMediumReferenceContent& Content;
  Field Fields[MaximumFields];
  int Count = 0;
  double Begin, End, Last;
};

#endif
