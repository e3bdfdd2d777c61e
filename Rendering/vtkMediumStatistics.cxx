// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumStatistics.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMediumStatistics);

//------------------------------------------------------------------------------
vtkMediumStatistics::vtkMediumStatistics() = default;

//------------------------------------------------------------------------------
vtkMediumStatistics::~vtkMediumStatistics() = default;

//------------------------------------------------------------------------------
void vtkMediumStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frames: " << this->Frames << "\n";
  os << indent << "FramesReused: " << this->FramesReused << "\n";
  os << indent << "Passes: " << this->Passes << "\n";
  os << indent << "PixelEdge: " << this->PixelEdge << "\n";
  os << indent << "EyeStep: " << this->EyeStep << "\n";
  os << indent << "LightMethod: " << this->LightMethod << "\n";
  os << indent << "CountTaps: " << (this->CountTaps ? "On" : "Off") << "\n";
  os << indent << "Taps: " << this->Taps << "\n";
  os << indent << "Rays: " << this->Rays << "\n";
  os << indent << "RaysRefined: " << this->RaysRefined << "\n";
  os << indent << "GatherMilliseconds: " << this->GatherMilliseconds << "\n";
  os << indent << "UploadMilliseconds: " << this->UploadMilliseconds << "\n";
  os << indent << "BuildMilliseconds: " << this->BuildMilliseconds << "\n";
  os << indent << "CalibrateMilliseconds: " << this->CalibrateMilliseconds << "\n";
  os << indent << "CompileMilliseconds: " << this->CompileMilliseconds << "\n";
  os << indent << "IntegrateMilliseconds: " << this->IntegrateMilliseconds << "\n";
  os << indent << "FrameMilliseconds: " << this->FrameMilliseconds << "\n";
  os << indent << "TextureUploads: " << this->TextureUploads << "\n";
  os << indent << "ProgramCompiles: " << this->ProgramCompiles << "\n";
  os << indent << "BricksVisited: " << this->BricksVisited << "\n";
  os << indent << "BricksLeapt: " << this->BricksLeapt << "\n";
  os << indent << "BrickBuilds: " << this->BrickBuilds << "\n";
  os << indent << "LightCacheBuilds: " << this->LightCacheBuilds << "\n";
  os << indent << "LightCacheUploads: " << this->LightCacheUploads << "\n";
  os << indent << "ShadowMapBuilds: " << this->ShadowMapBuilds << "\n";
  os << indent << "OpaqueDepthCopies: " << this->OpaqueDepthCopies << "\n";
  os << indent << "Calibrations: " << this->Calibrations << "\n";
  os << indent << "GPUBytes: " << this->GPUBytes << "\n";
}
