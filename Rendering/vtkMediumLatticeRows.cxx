// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumLatticeRows.h"

#include "vtkSetGet.h"

#include <cmath>

namespace
{
//------------------------------------------------------------------------------
template <typename T>
void ReadStrided(const T* first, int stride, int count, double minimum, double maximum, double* row)
{
  for (int i = 0; i < count; ++i)
  {
    const double value = static_cast<double>(first[static_cast<vtkIdType>(i) * stride]);
    row[i] = std::isfinite(value) ? value : value > 0 ? maximum : minimum;
  }
}
}

//------------------------------------------------------------------------------
vtkMediumLatticeRows::vtkMediumLatticeRows(const vtkMediumField& field, int component)
  : Field(field)
  , Component(component)
{
  if (field.Array->HasStandardMemoryLayout())
  {
    this->Values = field.Array->GetVoidPointer(0);
  }
}

//------------------------------------------------------------------------------
void vtkMediumLatticeRows::Read(int j, int k, double* row) const
{
  const vtkMediumField& field = this->Field;
  const int count = field.Dimensions.x;
  if (!this->Values)
  {
    for (int i = 0; i < count; ++i)
    {
      row[i] = field.GetValue(i, j, k, this->Component);
    }
    return;
  }
  const int stride = field.Array->GetNumberOfComponents();
  const vtkIdType tuple = count * (j + static_cast<vtkIdType>(field.Dimensions.y) * k);
  const vtkIdType first = tuple * stride + field.FirstComponent + this->Component;
  switch (field.Array->GetDataType())
  {
    vtkTemplateMacro(ReadStrided(static_cast<const VTK_TT*>(this->Values) + first, stride, count,
      field.Minimum, field.Maximum, row));
    default:
      for (int i = 0; i < count; ++i)
      {
        row[i] = field.GetValue(i, j, k, this->Component);
      }
  }
}
