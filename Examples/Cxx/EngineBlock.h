// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EngineBlock.h
 * @brief A procedural, non-convex engine-like block: a stand-in for the well-known Engine.
 */
#ifndef EngineBlock_h
#define EngineBlock_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace EngineBlock
{
/// The stand-in: 256 x 256 x 128 voxels of uint8 with spacing 1, as the real one; 0 outside, 120 in
/// the cast, 230 in the bolts and cylinder liners.
vtkSmartPointer<vtkImageData> Make();

/// The real Engine from its raw file; throws a std::runtime_error unless it has 8388608 bytes.
vtkSmartPointer<vtkImageData> Read(const std::string& path);
}

#endif
