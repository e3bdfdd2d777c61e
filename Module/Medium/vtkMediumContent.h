// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumContent.h
 * @brief How a volume property, or a vtkParticipatingMedium, becomes the content of a scene.
 *
 * Private to the module. Each function returns an empty string, or what was wrong and how to fix
 * it.
 */
#ifndef vtkMediumContent_h
#define vtkMediumContent_h

#include "vtkMediumScene.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

/// The largest opacity that an extinction is taken from: alpha = 1 would be infinitely thick.
/// 1 - 2^-24, the largest float below 1, gives an optical depth of 16.6 over the unit distance.
constexpr double vtkMediumMaximumOpacity = 1.0 - 1.0 / 16777216.0;

/// How far an albedo may pass 1 by rounding: a float's 1e-7 after a few operations.
constexpr double vtkMediumAlbedoTolerance = 1e-6;

/// sigma_t(s) = -ln(1 - alpha(s)) / ScalarOpacityUnitDistance; the colour function is the albedo.
std::string vtkMediumContentFromProperty(vtkMediumScene::Medium& content,
  std::vector<vtkMediumScene::ColorTable>& tables, vtkImageData* input, vtkDataArray* scalars,
  bool onCells, vtkVolumeProperty* property, double anisotropy);

/// The coefficients as the medium states them. `scalars` may be null as long as none is asked for.
std::string vtkMediumContentFromMedium(vtkMediumScene::Medium& content,
  std::vector<vtkMediumScene::ColorTable>& tables, vtkImageData* input, vtkDataArray* scalars,
  bool onCells, vtkVolumeProperty* property, vtkParticipatingMedium* medium);

/// The phase function of the medium, but for an anisotropy that varies.
std::string vtkMediumPhaseFromMedium(
  vtkMediumScene::Medium& content, vtkParticipatingMedium* medium);

/// A field over a named or given array, of the components that the field states; fails on an array
/// of the wrong length or without any finite value.
std::string vtkMediumFieldFromArray(vtkMediumField& field, vtkImageData* input, vtkDataArray* array,
  bool onCells, vtkVolumeProperty* property);

/// The colours of a transfer function at the values that vtkMediumFunction samples in [minimum,
/// maximum]: from `tables` if they are there, else sampled and added.
std::vector<glm::dvec3> vtkMediumSampleColors(std::vector<vtkMediumScene::ColorTable>& tables,
  vtkColorTransferFunction* function, double minimum, double maximum);

///@{
/// Appends the values where a transfer function is not smooth: its nodes, and the midpoints between
/// them where those are used.
void vtkMediumAppendKnots(std::vector<double>& knots, vtkPiecewiseFunction* function);
void vtkMediumAppendKnots(std::vector<double>& knots, vtkColorTransferFunction* function);
///@}

#endif
