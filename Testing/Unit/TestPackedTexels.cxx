// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumPackedTexels.h"

#include "vtkDataArray.h"

#include <gtest/gtest.h>

namespace
{
vtkMediumField MakeField(int type, const std::vector<double>& values, int components = 1)
{
  vtkMediumField field;
  field.Array.TakeReference(vtkDataArray::CreateDataArray(type));
  field.Array->SetNumberOfComponents(components);
  field.Array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const vtkIdType at = static_cast<vtkIdType>(i);
    field.Array->SetComponent(at / components, static_cast<int>(at % components), values[i]);
  }
  field.Components = components;
  field.Dimensions = glm::ivec3(static_cast<int>(values.size()) / components, 1, 1);
  field.FindRange();
  return field;
}
}

//------------------------------------------------------------------------------
TEST(PackedTexels, RoundNoValue)
{
  struct Case
  {
    int Type;
    std::vector<double> Values;
  };
  for (const Case& row :
    { Case{ VTK_SHORT, { -1024, 3071, 0, 77 } }, Case{ VTK_UNSIGNED_CHAR, { 0, 255, 1, 128 } },
      Case{ VTK_UNSIGNED_SHORT, { 0, 65535, 1, 40000 } },
      Case{ VTK_SHORT, { -32768, 32767, -1, 1 } },
      Case{ VTK_LONG_LONG, { 1e15, 1e15 + 9, 1e15 + 1, 1e15 + 4 } },
      Case{ VTK_INT, { 5, 6, 5, 6 } } })
  {
    const vtkMediumField field = MakeField(row.Type, row.Values);
    ASSERT_GT(vtkMediumPackingFactor(field), 0);
    const std::vector<std::uint16_t> texels = vtkMediumPackedTexels(field);
    for (std::size_t i = 0; i < row.Values.size(); ++i)
    {
      const double fraction = texels[i] / 65535.0 * vtkMediumTexelScale(field);
      EXPECT_NEAR(
        fraction, (row.Values[i] - field.Minimum) / (field.Maximum - field.Minimum), 1e-15);
    }
  }
}

//------------------------------------------------------------------------------
TEST(PackedTexels, KeepTheOrderOfComponents)
{
  const vtkMediumField field = MakeField(VTK_SHORT, { 0, 10, 20, 30, 40, 50 }, 3);
  const int factor = vtkMediumPackingFactor(field);
  const std::vector<std::uint16_t> texels = vtkMediumPackedTexels(field);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(texels[i], 10 * i * factor);
  }
}

//------------------------------------------------------------------------------
TEST(PackedTexels, LeaveOutWhatDoesNotFit)
{
  for (const vtkMediumField& field :
    { MakeField(VTK_FLOAT, { 0, 1 }), MakeField(VTK_DOUBLE, { 0, 255 }),
      MakeField(VTK_INT, { 0, 65536 }), MakeField(VTK_SHORT, { 3, 3 }) })
  {
    EXPECT_EQ(vtkMediumPackingFactor(field), 0);
    EXPECT_EQ(vtkMediumTexelScale(field), 1);
  }
}
