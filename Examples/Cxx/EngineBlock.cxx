// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineBlock.h"

#include "vtkBox.h"
#include "vtkCylinder.h"
#include "vtkImageData.h"
#include "vtkImageMathematics.h"
#include "vtkImageReader2.h"
#include "vtkImageThreshold.h"
#include "vtkImplicitBoolean.h"
#include "vtkNew.h"
#include "vtkSampleFunction.h"

#include <filesystem>
#include <stdexcept>
#include <vector>

namespace
{
using Shape = vtkSmartPointer<vtkImplicitFunction>;
constexpr int Columns = 256, Rows = 256, Slices = 128;

//------------------------------------------------------------------------------
// The union of shapes, their intersection, or the first minus all others.
Shape Combine(int operation, const std::vector<Shape>& shapes)
{
  vtkNew<vtkImplicitBoolean> boolean;
  boolean->SetOperationType(operation);
  for (const Shape& shape : shapes)
  {
    boolean->AddFunction(shape);
  }
  return Shape(boolean.Get());
}

//------------------------------------------------------------------------------
Shape Box(double x0, double x1, double y0, double y1, double z0, double z1)
{
  vtkNew<vtkBox> box;
  box->SetBounds(x0, x1, y0, y1, z0, z1);
  return Shape(box.Get());
}

//------------------------------------------------------------------------------
// A cylinder along an axis from low to high; u and v are the other two coordinates of its axis.
Shape Rod(int axis, double u, double v, double radius, double low, double high)
{
  double center[3] = { u, u, v };
  center[axis] = 0;
  center[axis == 0 ? 1 : 0] = u;
  center[axis == 2 ? 1 : 2] = v;
  double direction[3] = { 0, 0, 0 };
  direction[axis] = 1;
  double bounds[6] = { -1000, 1000, -1000, 1000, -1000, 1000 };
  bounds[2 * axis] = low;
  bounds[2 * axis + 1] = high;
  vtkNew<vtkCylinder> cylinder;
  cylinder->SetAxis(direction);
  cylinder->SetCenter(center);
  cylinder->SetRadius(radius);
  vtkNew<vtkBox> ends;
  ends->SetBounds(bounds);
  return Combine(
    vtkImplicitBoolean::VTK_INTERSECTION, { Shape(cylinder.Get()), Shape(ends.Get()) });
}

//------------------------------------------------------------------------------
// The block, its flange and pipes, less bores, water jackets, crank case, holes and oil channels.
Shape Cast()
{
  std::vector<Shape> solid = { Box(34, 222, 74, 182, 14, 100), Box(14, 242, 42, 214, 92, 106),
    Rod(0, 182, 36, 26, 22, 234) };
  std::vector<Shape> hollow = { Rod(0, 128, 26, 18, 0, 256), Rod(0, 182, 36, 17, 0, 256),
    Rod(1, 128, 50, 9, 0, 256), Rod(0, 86, 84, 6, 0, 256), Rod(0, 170, 84, 6, 0, 256) };
  for (const double x : { 84.0, 172.0 })
  {
    solid.push_back(Rod(2, x, 128, 46, 14, 112));
    solid.push_back(Rod(1, x, 72, 20, 18, 90));
    hollow.push_back(Rod(2, x, 128, 30, 0, 128));
    hollow.push_back(Rod(1, x, 72, 13, 0, 100));
    hollow.push_back(Combine(vtkImplicitBoolean::VTK_DIFFERENCE,
      { Rod(2, x, 128, 43, 34, 86), Rod(2, x, 128, 37, 30, 90) }));
  }
  for (const double x : { 28.0, 128.0, 228.0 })
  {
    hollow.push_back(Rod(2, x, 56, 5, 80, 128));
    hollow.push_back(Rod(2, x, 200, 5, 80, 128));
  }
  return Combine(vtkImplicitBoolean::VTK_DIFFERENCE,
    { Combine(vtkImplicitBoolean::VTK_UNION, solid),
      Combine(vtkImplicitBoolean::VTK_UNION, hollow) });
}

//------------------------------------------------------------------------------
// Liners in the bores, and bolts in every second hole.
Shape Steel()
{
  std::vector<Shape> steel;
  for (const double x : { 84.0, 172.0 })
  {
    steel.push_back(Combine(vtkImplicitBoolean::VTK_DIFFERENCE,
      { Rod(2, x, 128, 30, 20, 116), Rod(2, x, 128, 26, 0, 128) }));
  }
  for (const double x : { 28.0, 128.0, 228.0 })
  {
    const double y = x == 128 ? 200 : 56;
    steel.push_back(Rod(2, x, y, 5, 70, 120));
    steel.push_back(Rod(2, x, y, 10, 106, 118));
  }
  return Combine(vtkImplicitBoolean::VTK_UNION, steel);
}

//------------------------------------------------------------------------------
// The value where the shape is, else 0.
vtkSmartPointer<vtkImageThreshold> Fill(const Shape& shape, double value)
{
  vtkNew<vtkSampleFunction> samples;
  samples->SetImplicitFunction(shape);
  samples->SetSampleDimensions(Columns, Rows, Slices);
  samples->SetModelBounds(0, Columns - 1, 0, Rows - 1, 0, Slices - 1);
  samples->ComputeNormalsOff();
  samples->SetOutputScalarTypeToFloat();
  auto voxels = vtkSmartPointer<vtkImageThreshold>::New();
  voxels->SetInputConnection(samples->GetOutputPort());
  voxels->ThresholdByLower(0);
  voxels->SetInValue(value);
  voxels->SetOutValue(0);
  voxels->SetOutputScalarTypeToUnsignedChar();
  return voxels;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> EngineBlock::Make()
{
  const auto cast = Fill(Cast(), 120);
  const auto steel = Fill(Steel(), 230);
  vtkNew<vtkImageMathematics> both;
  both->SetOperationToMax();
  both->SetInputConnection(0, cast->GetOutputPort());
  both->SetInputConnection(1, steel->GetOutputPort());
  both->Update();
  return both->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> EngineBlock::Read(const std::string& path)
{
  std::error_code missing;
  const auto size = std::filesystem::file_size(path, missing);
  if (missing || size != Columns * Rows * Slices)
  {
    throw std::runtime_error(path + ": " +
      (missing ? missing.message() : std::to_string(size) + " bytes, expected 8388608") +
      "; give the raw uint8 Engine of 256 x 256 x 128 voxels");
  }
  vtkNew<vtkImageReader2> reader;
  reader->SetFileName(path.c_str());
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(0, Columns - 1, 0, Rows - 1, 0, Slices - 1);
  reader->SetDataScalarTypeToUnsignedChar();
  reader->FileLowerLeftOn();
  reader->Update();
  return reader->GetOutput();
}
