// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumMask.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
vtkUnsignedCharArray* GhostsOf(vtkDataSetAttributes* data)
{
  return vtkUnsignedCharArray::SafeDownCast(
    data->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
}

//------------------------------------------------------------------------------
std::string FindGhostProblem(vtkUnsignedCharArray* ghosts, vtkIdType expected, const char* what)
{
  std::ostringstream text;
  if (ghosts && ghosts->GetNumberOfTuples() != expected)
  {
    text << "The array " << ghosts->GetName() << " has " << ghosts->GetNumberOfTuples()
         << " tuples, but the image has " << expected << ' ' << what
         << "; give one tuple for each.";
  }
  return text.str();
}

//------------------------------------------------------------------------------
// Empty, or why the image is no mask of the input.
std::string FindProblem(vtkImageData* input, vtkImageData* mask)
{
  int expected[3], found[3];
  input->GetDimensions(expected);
  mask->GetDimensions(found);
  std::ostringstream text;
  if (!std::equal(expected, expected + 3, found))
  {
    text << "The mask has " << found[0] << " x " << found[1] << " x " << found[2]
         << " points, but the input has " << expected[0] << " x " << expected[1] << " x "
         << expected[2] << "; give them the same dimensions (SetMaskInput).";
    return text.str();
  }
  vtkDataArray* scalars = mask->GetPointData()->GetScalars();
  scalars = scalars ? scalars : mask->GetCellData()->GetScalars();
  if (!scalars || !vtkUnsignedCharArray::SafeDownCast(scalars) ||
    scalars->GetNumberOfComponents() != 1)
  {
    text << "The mask has ";
    scalars ? text << scalars->GetNumberOfComponents() << " components of "
                   << scalars->GetDataTypeAsString()
            : text << "no scalars";
    text
      << ", but a mask is one component of unsigned char, 0 where nothing is to be drawn; convert "
         "it (vtkImageCast, vtkImageExtractComponents).";
    return text.str();
  }
  const bool onCells = scalars != mask->GetPointData()->GetScalars();
  const vtkIdType values = onCells ? mask->GetNumberOfCells() : mask->GetNumberOfPoints();
  if (scalars->GetNumberOfTuples() != values)
  {
    text << "The mask's scalars have " << scalars->GetNumberOfTuples() << " tuples, but it has "
         << values << (onCells ? " cells" : " points") << "; give one tuple for each.";
  }
  return text.str();
}
}

//------------------------------------------------------------------------------
vtkMediumMask::Source::Source(vtkUnsignedCharArray* array, vtkImageData* holder)
  : Array(array)
  , Time(array ? std::max(array->GetMTime(), holder->GetMTime()) : 0)
{
}

//------------------------------------------------------------------------------
void vtkMediumMask::Lattice::Update(const Source& ghosts, const Source& mask)
{
  if (ghosts == this->Ghosts && mask == this->Mask)
  {
    return;
  }
  this->Ghosts = ghosts;
  this->Mask = mask;
  this->Values = nullptr;
  vtkUnsignedCharArray* given = mask.Array ? mask.Array : ghosts.Array;
  if (!given)
  {
    return;
  }
  auto values = vtkSmartPointer<vtkUnsignedCharArray>::New();
  const vtkIdType count = given->GetNumberOfTuples();
  values->SetNumberOfTuples(count);
  bool whole = true;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const bool masked = mask.Array && mask.Array->GetValue(i) == 0;
    const bool ghost = ghosts.Array && ghosts.Array->GetValue(i) != 0;
    values->SetValue(i, masked || ghost ? 0 : 1);
    whole = whole && !masked && !ghost;
  }
  this->Values = whole ? nullptr : values;
}

//------------------------------------------------------------------------------
void vtkMediumMask::Append(const Lattice& lattice, vtkImageData* input, bool onCells)
{
  if (!lattice.Values)
  {
    return;
  }
  vtkMediumField field;
  input->GetDimensions(&field.Dimensions[0]);
  field.Dimensions -= onCells ? 1 : 0;
  field.Array = lattice.Values;
  field.Time = lattice.Values->GetMTime();
  field.OnCells = onCells;
  field.Linear = false;
  field.Maximum = 1;
  this->Fields.push_back(field);
}

//------------------------------------------------------------------------------
std::string vtkMediumMask::Gather(vtkImageData* input, vtkImageData* mask)
{
  this->Fields.clear();
  Source pointGhosts(GhostsOf(input->GetPointData()), input);
  Source cellGhosts(GhostsOf(input->GetCellData()), input);
  std::string problem = FindGhostProblem(pointGhosts.Array, input->GetNumberOfPoints(), "points");
  problem = problem.empty() ? FindGhostProblem(cellGhosts.Array, input->GetNumberOfCells(), "cells")
                            : problem;
  problem = problem.empty() && mask ? FindProblem(input, mask) : problem;
  if (!problem.empty())
  {
    return problem;
  }
  vtkUnsignedCharArray *onPoints = nullptr, *onCells = nullptr;
  if (mask)
  {
    onPoints = vtkUnsignedCharArray::SafeDownCast(mask->GetPointData()->GetScalars());
    onCells =
      onPoints ? nullptr : vtkUnsignedCharArray::SafeDownCast(mask->GetCellData()->GetScalars());
  }
  this->Points.Update(pointGhosts, Source(onPoints, mask));
  this->Cells.Update(cellGhosts, Source(onCells, mask));
  this->Append(this->Points, input, false);
  this->Append(this->Cells, input, true);
  return {};
}
