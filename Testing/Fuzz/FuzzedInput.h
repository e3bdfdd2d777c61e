// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzedInput.h
 * @brief What a user hands to the library, made of a fuzzer's bytes, and the laws that hold for all of it.
 */
#ifndef FuzzedInput_h
#define FuzzedInput_h

#include "Bytes.h"

#include "vtkMediumScene.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <string>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

namespace vtkMediumFuzz
{
/// Ends the process with what broke, so that a fuzzer keeps the bytes.
void Demand(bool holds, const std::string& law);

/// VTK's own warnings about what it is given are not looked at.
void Silence();

/// An image of at most 5 points along each axis, with any origin, spacing and direction.
void FillGeometry(Bytes& bytes, vtkImageData* image);

/// A point or cell array of any type and up to five components. Not always of the right length.
vtkDataArray* AddArray(Bytes& bytes, vtkImageData* image, const char* name, bool& onCells);

void FillMatrix(Bytes& bytes, vtkVolume* volume);
void FillFunction(Bytes& bytes, vtkPiecewiseFunction* function);
void FillFunction(Bytes& bytes, vtkColorTransferFunction* function);

/// Every setter of a medium; its arrays are named "first", "second", or not at all.
void FillMedium(Bytes& bytes, vtkParticipatingMedium* medium);
void FillProperty(Bytes& bytes, vtkVolumeProperty* property);

/// An image with arrays in a volume, and a medium for it.
struct Input
{
  vtkNew<vtkImageData> Image;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkParticipatingMedium> Medium;
  vtkDataArray* Scalars = nullptr; ///< the first array, or none
  bool OnCells = false;

  explicit Input(Bytes& bytes);
};

/// Of a scene that was not refused: coefficients are >= 0 and finite wherever they are looked up, and
/// its geometry is finite.
void DemandSoundScene(const vtkMediumScene& scene);
}

#endif
