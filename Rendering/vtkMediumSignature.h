// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumSignature
 * @brief The values that a resource depends on: same signature, same content.
 *
 * Every resource keeps the signature that it was built from and is built anew only when the signature
 * that it is asked for differs.
 */
#ifndef vtkMediumSignature_h
#define vtkMediumSignature_h

#include "vtkMediumPlan.h"
#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumSignature
{
public:
  /// What optical depths depend on, for a density scale of 1: the lattice, the extinction, and the
  /// arrays and functions that it reads.
  static vtkMediumSignature OfExtinction(const vtkMediumScene& scene);
  /// What is cut away.
  static vtkMediumSignature OfCut(const vtkMediumScene& scene);
  /// What casts shadows into the volume.
  static vtkMediumSignature OfCasters(const vtkMediumScene& scene);
  /// What bricks depend on: the extinction and the emission.
  static vtkMediumSignature OfOccupancy(const vtkMediumScene& scene);
  /// All that changes the image of a scene materially, but for the camera.
  static vtkMediumSignature OfContentAndLights(const vtkMediumScene& scene);

  /// All that an integrated frame depends on, but for the viewport and what hides the volume.
  static vtkMediumSignature OfFrame(
    const vtkMediumScene& scene, const vtkMediumPlan::Settings& settings);

  void Add(double value) { this->Values.push_back(value); }
  void Add(const vtkMediumSignature& other);

  bool operator==(const vtkMediumSignature& other) const { return this->Values == other.Values; }
  bool operator!=(const vtkMediumSignature& other) const { return !(*this == other); }
  bool IsEmpty() const { return this->Values.empty(); }

private:
  void Add(const glm::dvec3& value);
  /// The coefficient with all that it reads.
  void Add(const vtkMediumScene::Coefficient& coefficient, const vtkMediumScene::Medium& content);
  void Add(const vtkMediumField& field);
  void Add(const vtkMediumScene::Light& light);
  void Add(const vtkMediumCut& cut);

  std::vector<double> Values;
};

#endif
