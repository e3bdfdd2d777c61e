// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumOccupiedRows
 * @brief The rows of an extinction grid that hold anything, padded, and the points that need a cache.
 *
 * A padded row may be read from -Padding to Dimensions.x + Padding - 1; beyond the lattice it is zero.
 * Empty rows take no memory.
 */
#ifndef vtkMediumOccupiedRows_h
#define vtkMediumOccupiedRows_h

#include "vtkMediumExtinctionGrid.h"

#include <cstddef>
#include <vector>

class vtkMediumOccupiedRows
{
public:
  static constexpr int Padding = 64;

  struct Interval
  {
    int Begin = 0, End = 0;
  };

  /// `reach`: how far from a value > 0, in lattice steps along each axis, points are needed;
  /// negative: all are. Rows are copied only if `withValues` is set; GetRow needs that.
  vtkMediumOccupiedRows(const vtkMediumExtinctionGrid& grid, int reach, bool withValues);

  /// Where the row's values are not zero; Begin = End for an empty row.
  Interval GetOccupied(int j, int k) const { return this->Occupied[this->RowIndex(j, k)]; }
  /// Where optical depths are needed.
  Interval GetNeeded(int j, int k) const { return this->Needed[this->RowIndex(j, k)]; }
  /// The first value of a row that is not empty.
  const float* GetRow(int j, int k) const
  {
    return this->Values.data() + this->Starts[this->RowIndex(j, k)];
  }

private:
  std::size_t RowIndex(int j, int k) const
  {
    return j + static_cast<std::size_t>(this->RowsOfSlice) * k;
  }
  void CopyRows(const vtkMediumExtinctionGrid& grid);
  void FindNeeded(const glm::ivec3& n, int reach);

  int RowsOfSlice = 0;
  std::vector<Interval> Occupied;
  std::vector<Interval> Needed;
  std::vector<std::size_t> Starts;
  std::vector<float> Values;
};

#endif
