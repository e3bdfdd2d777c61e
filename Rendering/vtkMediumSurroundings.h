// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumSurroundings
 * @brief What else a renderer shows besides a volume: whether it may hide a part of the volume, and when
 * it last changed.
 */
#ifndef vtkMediumSurroundings_h
#define vtkMediumSurroundings_h

#include "vtkMediumCompatibility.h"
#include "vtkMediumSignature.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolume;
VTK_ABI_NAMESPACE_END

class vtkMediumSurroundings
{
public:
  vtkMediumSurroundings(vtkRenderer* renderer, const vtkVolume* volume);

  /// Whether the depth buffer can hold anything in front of the volume.
  bool MayHide() const { return this->Hides; }
  /// Whether all of it is known. Not so where the depth buffer comes from outside of the renderer.
  bool IsKnown() const { return this->Known; }
  /// The visible props and when they last changed.
  const vtkMediumSignature& GetSignature() const { return this->Signature; }

private:
  vtkMediumSignature Signature;
  bool Hides = false;
  bool Known = true;
};

#endif
