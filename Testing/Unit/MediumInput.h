// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MediumInput.h
 * @brief A small image, a volume and a medium, and the scene that is gathered from them.
 */
#ifndef MediumInput_h
#define MediumInput_h

#include "vtkMediumScene.h"
#include "vtkParticipatingMedium.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <functional>
#include <string>

struct MediumInput
{
  vtkNew<vtkImageData> Image;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkVolumeProperty> Property;
  vtkDataArray* Scalars = nullptr;
  bool OnCells = false;
  double Anisotropy = 0;
  vtkMediumScene Scene;

  /// An image of x by y by z points and no arrays; linear interpolation, white, no opacity.
  explicit MediumInput(int x = 3, int y = 3, int z = 3)
  {
    this->Image->SetDimensions(x, y, z);
    this->Property->SetInterpolationTypeToLinear();
    vtkNew<vtkPiecewiseFunction> opacity; // empty, where VTK's default is a ramp from 0 to 1024
    this->Property->SetScalarOpacity(opacity);
    vtkNew<vtkColorTransferFunction> white;
    white->AddRGBPoint(0, 1, 1, 1);
    this->Property->SetColor(white);
    this->Volume->SetProperty(this->Property);
  }

  /// Adds an array whose component c of tuple i is value(i, c).
  vtkDataArray* Add(const char* name, int components,
    const std::function<double(vtkIdType, int)>& value, bool onCells = false, int type = VTK_DOUBLE)
  {
    auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(
      onCells ? this->Image->GetNumberOfCells() : this->Image->GetNumberOfPoints());
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        array->SetComponent(i, c, value(i, c));
      }
    }
    onCells ? this->Image->GetCellData()->AddArray(array)
            : this->Image->GetPointData()->AddArray(array);
    return array;
  }

  std::string GatherMedium()
  {
    this->Scene = vtkMediumScene();
    return this->Scene.GatherVolume(
      this->Image, this->Scalars, this->OnCells, this->Volume, this->Medium, 0);
  }

  std::string GatherProperty()
  {
    this->Scene = vtkMediumScene();
    return this->Scene.GatherVolume(
      this->Image, this->Scalars, this->OnCells, this->Volume, nullptr, this->Anisotropy);
  }

  /// The coefficients at a lattice point of point data, whose coordinates count from 0.
  vtkMediumScene::Coefficients AtPoint(double i, double j, double k) const
  {
    int size[3];
    const_cast<vtkImageData*>(this->Image.Get())->GetDimensions(size);
    return this->Scene.Evaluate({ i / (size[0] - 1), j / (size[1] - 1), k / (size[2] - 1) });
  }
};

#endif
