// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What stands between the lights and the medium.
#include "vtkMediumScene.h"

#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

//------------------------------------------------------------------------------
void vtkMediumScene::GatherCasters(vtkRenderer* renderer)
{
  this->Casters.clear();
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    const bool surface = prop->IsA("vtkProp3D") && !vtkVolume::SafeDownCast(prop);
    if (surface && prop->GetVisibility() && prop->HasOpaqueGeometry())
    {
      this->Casters.push_back({ prop, prop->GetRedrawMTime() });
    }
  }
}
