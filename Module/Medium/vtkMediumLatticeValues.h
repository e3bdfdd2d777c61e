// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumLatticeValues.h
 * @brief The values of a field, copied once for fast and exact reading.
 *
 * Private to the module. Kept as float where float holds the array's type exactly, else as double.
 */
#ifndef vtkMediumLatticeValues_h
#define vtkMediumLatticeValues_h

#include "vtkMediumCellWalk.h"

#include <cstddef>
#include <vector>

class vtkMediumLatticeValues
{
public:
  /// Copies the field unless the copy at hand is of the same array in the same state.
  void Update(const vtkMediumField& field);

  /// The values of component `component` at the eight corners of a cell; corner bits are x, y, z.
  /// At the border the corners outside repeat those inside. A nearest field fills corner 0 only.
  void GetCorners(const glm::ivec3& cell, int component, double corners[8]) const;

  const vtkMediumLattice& GetLattice() const { return this->Lattice; }
  int GetComponents() const { return this->Components; }

private:
  double Get(std::size_t index) const
  {
    return this->Floats.empty() ? this->Doubles[index] : this->Floats[index];
  }

  vtkMediumLattice Lattice;
  int FirstComponent = 0;
  int Components = 0;
  double Minimum = 0, Maximum = 0;
  vtkSmartPointer<vtkDataArray> Array;
  vtkMTimeType ArrayTime = 0;
  std::vector<float> Floats;
  std::vector<double> Doubles;
};

#endif
