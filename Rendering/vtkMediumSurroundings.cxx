// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumSurroundings.h"

#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <cstdint>

//------------------------------------------------------------------------------
vtkMediumSurroundings::vtkMediumSurroundings(vtkRenderer* renderer, const vtkVolume* volume)
{
  // A renderer that keeps the depth buffer draws upon somebody else's picture; a pass may do so too.
  this->Known = !renderer->GetPreserveDepthBuffer() && !renderer->GetPass();
  this->Hides = !this->Known;
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (prop != volume && prop->GetVisibility())
    {
      this->Hides = true;
      // An address has at most 48 bits in use, which a double holds exactly.
      this->Signature.Add(static_cast<double>(reinterpret_cast<std::uintptr_t>(prop)));
      this->Signature.Add(static_cast<double>(prop->GetRedrawMTime()));
    }
  }
}
