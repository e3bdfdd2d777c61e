// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumContent.h"

#include "vtkParticipatingMedium.h"

//------------------------------------------------------------------------------
std::string vtkMediumContentFromMedium(vtkMediumScene::Medium&, vtkImageData*, vtkDataArray*, bool,
  vtkVolumeProperty*, vtkParticipatingMedium*)
{
  return {};
}
