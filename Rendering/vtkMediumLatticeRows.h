// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumLatticeRows
 * @brief Reads a field row by row in double, whatever the array's type is.
 *
 * vtkMediumField::GetValue is a virtual call a value; whole lattices are read through this instead.
 * The policy for non-finite values is the field's. Reading is thread-safe.
 */
#ifndef vtkMediumLatticeRows_h
#define vtkMediumLatticeRows_h

#include "vtkMediumField.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumLatticeRows
{
public:
  /// The field must outlive the reader. `component` counts from the field's first component.
  explicit vtkMediumLatticeRows(const vtkMediumField& field, int component = 0);

  /// Writes the Dimensions.x values of the row (j, k) to `row`.
  void Read(int j, int k, double* row) const;

private:
  const vtkMediumField& Field;
  int Component;
  const void* Values = nullptr; ///< the array's memory where it has the usual layout
};

#endif
