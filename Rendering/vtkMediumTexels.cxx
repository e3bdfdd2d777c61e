// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumTexels.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <cmath>
#include <limits>

namespace
{
struct ScaleWorker
{
  template <typename ArrayType>
  void operator()(ArrayType* array, const vtkMediumField& field, std::vector<float>& texels,
    std::atomic<vtkTypeInt64>& nonFinite)
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    const double range = field.Maximum - field.Minimum; // one too small for its inverse is none
    const double scale = range > std::numeric_limits<double>::min() ? 1 / range : 0;
    vtkSMPTools::For(0, array->GetNumberOfTuples(), [&](vtkIdType begin, vtkIdType end) {
      vtkTypeInt64 bad = 0;
      for (vtkIdType t = begin; t < end; ++t)
      {
        for (int c = 0; c < field.Components; ++c)
        {
          double value = static_cast<double>(tuples[t][field.FirstComponent + c]);
          if (!std::isfinite(value))
          {
            value = value > 0 ? field.Maximum : field.Minimum;
            ++bad;
          }
          texels[t * field.Components + c] = static_cast<float>((value - field.Minimum) * scale);
        }
      }
      nonFinite += bad;
    });
  }
};
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumTexels(const vtkMediumField& field, vtkTypeInt64& nonFinite)
{
  std::vector<float> texels(field.Array->GetNumberOfTuples() * field.Components);
  std::atomic<vtkTypeInt64> bad(0);
  ScaleWorker worker;
  if (!vtkArrayDispatch::Dispatch::Execute(field.Array.Get(), worker, field, texels, bad))
  {
    worker(field.Array.Get(), field, texels, bad);
  }
  nonFinite += bad;
  return texels;
}
