// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What vtkSingleScatteringReference reads of its inputs, and when.
#include "vtkMediumRange.h"
#include "vtkSingleScatteringReferenceGathered.h"

#include "vtkParticipatingMedium.h"

#include "vtkAbstractMapper.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>

//------------------------------------------------------------------------------
vtkMTimeType vtkSingleScatteringReference::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  const auto include = [&time](vtkObject* object) {
    time = object ? std::max(time, object->GetMTime()) : time;
  };
  include(this->FindInput());
  include(this->MaskInput);
  include(this->Medium);
  if (this->Volume)
  {
    this->Volume->ComputeMatrix();
    include(this->Volume);
    include(this->Volume->GetMatrix());
    include(this->Volume->GetProperty());
    vtkAbstractVolumeMapper* mapper = this->Volume->GetMapper();
    include(mapper);
    vtkPlaneCollection* planes = mapper ? mapper->GetClippingPlanes() : nullptr;
    for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
    {
      include(vtkObject::SafeDownCast(planes->GetItemAsObject(i)));
    }
  }
  if (this->Renderer)
  {
    include(this->Renderer);
    include(this->Renderer->IsActiveCameraCreated() ? this->Renderer->GetActiveCamera() : nullptr);
    vtkLightCollection* lights = this->Renderer->GetLights();
    include(lights);
    vtkCollectionSimpleIterator iterator;
    lights->InitTraversal(iterator);
    while (vtkLight* light = lights->GetNextLight(iterator))
    {
      include(light);
      include(light->GetTransformMatrix());
    }
  }
  return time;
}

//------------------------------------------------------------------------------
vtkImageData* vtkSingleScatteringReference::FindInput()
{
  if (this->InputData || !this->Volume || !this->Volume->GetMapper())
  {
    return this->InputData;
  }
  return vtkImageData::SafeDownCast(this->Volume->GetMapper()->GetDataObjectInput());
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringReference::CheckTolerance() const
{
  std::ostringstream problem;
  if (std::isnan(this->Tolerance)) // all that clamping lets through
  {
    problem << "The tolerance is " << this->Tolerance
            << "; set a fraction of the peak from 1e-13 to 1 (SetTolerance).";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringReference::GatherMedium()
{
  vtkImageData* input = this->FindInput();
  if (!input)
  {
    return "There is no vtkImageData; call SetInputData, or SetVolume with a volume whose mapper "
           "has "
           "one as its input.";
  }
  vtkAbstractVolumeMapper* mapper = this->Volume ? this->Volume->GetMapper() : nullptr;
  int cellFlag = 0;
  vtkDataArray* scalars = mapper
    ? vtkAbstractMapper::GetScalars(input, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
        mapper->GetArrayId(), mapper->GetArrayName(), cellFlag)
    : vtkAbstractMapper::GetScalars(
        input, VTK_SCALAR_MODE_DEFAULT, VTK_GET_ARRAY_BY_ID, 0, nullptr, cellFlag);
  if (!scalars && !this->Medium)
  {
    return "The input image has no scalars; give it point or cell scalars, or set a "
           "vtkParticipatingMedium.";
  }
  vtkSmartPointer<vtkVolume> volume = this->Volume;
  if (!volume)
  {
    volume = vtkSmartPointer<vtkVolume>::New();
  }
  volume->ComputeMatrix();
  const bool onCells = cellFlag != 0;
  std::string problem = this->Scene->Facts.GatherVolume(
    input, scalars, onCells, volume, this->Medium, this->Anisotropy);
  problem = problem.empty() ? this->Scene->Facts.GatherMask(input, this->MaskInput) : problem;
  problem = problem.empty() ? this->Scene->Facts.GatherCut(mapper, volume) : problem;
  if (problem.empty())
  {
    this->Scene->Content.Update(this->Scene->Facts);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringReference::GatherLights()
{
  if (!this->Renderer)
  {
    return "There is no renderer to take lights and camera from; call SetRenderer.";
  }
  const std::string problem = this->Scene->Facts.GatherLights(this->Renderer);
  return problem.empty() ? vtkMediumCheckRangeOfLights(this->Scene->Facts) : problem;
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringReference::GatherView(int size[2])
{
  const bool given = this->ImageSize[0] > 0 && this->ImageSize[1] > 0;
  const int* source =
    given || !this->Renderer->GetVTKWindow() ? this->ImageSize : this->Renderer->GetSize();
  std::copy(source, source + 2, size);
  if (size[0] < 1 || size[1] < 1)
  {
    return "The image would have " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " pixels; call SetImageSize with a width and a height > 0, or give the renderer a window.";
  }
  const double aspect =
    given ? static_cast<double>(size[0]) / size[1] : this->Renderer->GetTiledAspectRatio();
  return this->Scene->Facts.GatherView(
    this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1, 1));
}

//------------------------------------------------------------------------------
std::string vtkSingleScatteringReference::FindPlace(const double world[3], double local[3]) const
{
  const vtkMediumScene::Box& box = this->Scene->Facts.Geometry;
  const glm::dvec3 place = box.WorldToLocal({ world[0], world[1], world[2] });
  std::copy(&place[0], &place[0] + 3, local);
  std::ostringstream problem;
  if (!vtkMediumScene::Box::IsPlace(place))
  {
    problem << "The point (" << world[0] << ", " << world[1] << ", " << world[2]
            << ") is not finite, or more than " << vtkMediumScene::Box::Farthest
            << " times the volume's diagonal of " << box.Length
            << " away from it; give a point near the volume.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
bool vtkSingleScatteringReference::Gather(bool lights)
{
  if (this->Scene->Time != 0 && this->Scene->Time == this->GetMTime() &&
    (this->Scene->Lit || !lights))
  {
    return true;
  }
  this->Scene->Time = 0;
  std::string problem = this->CheckTolerance();
  problem = problem.empty() ? this->GatherMedium() : problem;
  if (problem.empty() && lights)
  {
    problem = this->GatherLights();
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return false;
  }
  this->Scene->Lit = lights;
  this->Scene->Time = this->GetMTime();
  return true;
}
