// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumMask
 * @brief The voxels that hold no medium: those that a mask leaves out, and ghosts.
 *
 * A voxel is taken out as a whole: a cell, or what is nearest to a point. Its border is sharp, like that of
 * nearest interpolation, whatever the interpolation of the data is, and the values beside it count
 * unchanged up to the border. So a mask means the same for every medium and transfer function, and along a
 * ray it is a few intervals.
 */
#ifndef vtkMediumMask_h
#define vtkMediumMask_h

#include "vtkParticipatingMediumModule.h" // for the export macro

#include "vtkMediumCompatibility.h"
#include "vtkMediumField.h"

#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
VTK_ABI_NAMESPACE_END

class VTKPARTICIPATINGMEDIUM_EXPORT vtkMediumMask
{
public:
  /// Fields of 1 where there is medium and 0 where there is none: on points, on cells, or both. None where
  /// nothing is left out.
  std::vector<vtkMediumField> Fields;

  /// Reads the ghost arrays of the input and a mask, which may be null. Returns an empty string, or what was
  /// wrong with the mask and how to mend it. What is the same as at the last call is kept.
  std::string Gather(vtkImageData* input, vtkImageData* mask);

private:
  // An array of bytes, in the state that it was read.
  struct Source
  {
    vtkSmartPointer<vtkUnsignedCharArray> Array;
    vtkMTimeType Time = 0;

    Source() = default;
    Source(vtkUnsignedCharArray* array, vtkImageData* holder);
    bool operator==(const Source& other) const
    {
      return this->Array == other.Array && this->Time == other.Time;
    }
  };

  // What is known of the points, or of the cells.
  struct Lattice
  {
    Source Ghosts, Mask;
    vtkSmartPointer<vtkUnsignedCharArray> Values; ///< null if all are 1
    void Update(const Source& ghosts, const Source& mask);
  };
  void Append(const Lattice& lattice, vtkImageData* input, bool onCells);

  Lattice Points, Cells;
};

#endif
