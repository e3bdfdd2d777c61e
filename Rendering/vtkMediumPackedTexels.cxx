// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumPackedTexels.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkSMPTools.h"

#include <limits>

namespace
{
constexpr int LargestTexel = std::numeric_limits<std::uint16_t>::max();

//------------------------------------------------------------------------------
struct PackWorker
{
  template <typename ArrayType>
  void operator()(
    ArrayType* array, const vtkMediumField& field, int factor, std::vector<std::uint16_t>& texels)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    vtkSMPTools::For(0, array->GetNumberOfTuples(), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType t = begin; t < end; ++t)
      {
        for (int c = 0; c < field.Components; ++c)
        {
          const double value = static_cast<double>(tuples[t][field.FirstComponent + c]);
          texels[t * field.Components + c] =
            static_cast<std::uint16_t>((value - field.Minimum) * factor);
        }
      }
    });
  }
};
}

//------------------------------------------------------------------------------
int vtkMediumPackingFactor(const vtkMediumField& field)
{
  const int type = field.Array->GetDataType();
  const double range = field.Maximum - field.Minimum;
  const bool integers = type != VTK_FLOAT && type != VTK_DOUBLE;
  return integers && range >= 1 && range <= LargestTexel ? static_cast<int>(LargestTexel / range)
                                                         : 0;
}

//------------------------------------------------------------------------------
std::vector<std::uint16_t> vtkMediumPackedTexels(const vtkMediumField& field)
{
  std::vector<std::uint16_t> texels(field.Array->GetNumberOfTuples() * field.Components);
  const int factor = vtkMediumPackingFactor(field);
  using Integers = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Integrals>;
  PackWorker worker;
  if (!Integers::Execute(field.Array.Get(), worker, field, factor, texels))
  {
    worker(field.Array.Get(), field, factor, texels);
  }
  return texels;
}

//------------------------------------------------------------------------------
double vtkMediumTexelScale(const vtkMediumField& field)
{
  const int factor = vtkMediumPackingFactor(field);
  return factor > 0 ? LargestTexel / (factor * (field.Maximum - field.Minimum)) : 1;
}
