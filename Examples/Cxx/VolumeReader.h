// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file VolumeReader.h
 * @brief Reads a volume by its path with the reader that VTK has for it.
 */
#ifndef VolumeReader_h
#define VolumeReader_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace VolumeReader
{
/// Returns the volume in a .vti, .nii, .nii.gz, .mhd, .mha, .nrrd or .nhdr file, or in a folder of
/// DICOM slices (CT numbers in HU); lengths are those of the file, commonly mm. Throws a
/// std::runtime_error whose message is one line: the path, what was found, what to do.
vtkSmartPointer<vtkImageData> Read(const std::string& path);
}

#endif
