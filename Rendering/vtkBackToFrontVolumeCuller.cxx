// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBackToFrontVolumeCuller.h"

#include "vtkCamera.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
/// Where lines of sight come from.
struct Eye
{
  explicit Eye(vtkCamera* camera)
    : Parallel(camera->GetParallelProjection() != 0)
  {
    camera->GetPosition(&this->Position[0]);
    camera->GetDirectionOfProjection(&this->Direction[0]);
  }

  bool Parallel;
  glm::dvec3 Position{ 0 }, Direction{ 0 };
};

//------------------------------------------------------------------------------
struct Volume
{
  Volume(vtkProp* prop, const Eye& eye)
    : Prop(prop)
  {
    const double* bounds = prop->GetBounds();
    for (int axis = 0; bounds && axis < 3; ++axis)
    {
      this->Lower[axis] = bounds[2 * axis];
      this->Upper[axis] = bounds[2 * axis + 1];
    }
    const glm::dvec3 way = 0.5 * (this->Lower + this->Upper) - eye.Position;
    this->Distance = eye.Parallel ? glm::dot(way, eye.Direction) : glm::length(way);
  }

  /// Whether a line of sight may pass through this volume before the other. Not if a plane along the axes
  /// parts them and the line begins on the other's side, or goes away from it.
  bool MayHide(const Volume& other, const Eye& eye) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double towards = eye.Direction[axis], from = eye.Position[axis];
      if (this->Upper[axis] <= other.Lower[axis] &&
        (eye.Parallel ? towards <= 0 : from >= this->Upper[axis]))
      {
        return false;
      }
      if (this->Lower[axis] >= other.Upper[axis] &&
        (eye.Parallel ? towards >= 0 : from <= this->Lower[axis]))
      {
        return false;
      }
    }
    return true;
  }

  vtkProp* Prop;
  glm::dvec3 Lower{ 0 }, Upper{ 0 };
  double Distance = 0;
};

//------------------------------------------------------------------------------
// Takes the farthest of those that hide none of the others, or of all where each hides another.
Volume TakeNext(std::vector<Volume>& volumes, const Eye& eye)
{
  std::size_t next = 0;
  bool nextIsFree = false;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    bool free = true;
    for (std::size_t j = 0; j < volumes.size() && free; ++j)
    {
      free = i == j || !volumes[i].MayHide(volumes[j], eye);
    }
    const bool farther = volumes[i].Distance > volumes[next].Distance;
    if ((free && !nextIsFree) || (free == nextIsFree && farther))
    {
      next = i;
      nextIsFree = free;
    }
  }
  const Volume taken = volumes[next];
  volumes.erase(volumes.begin() + static_cast<std::ptrdiff_t>(next));
  return taken;
}
}

vtkStandardNewMacro(vtkBackToFrontVolumeCuller);

//------------------------------------------------------------------------------
vtkBackToFrontVolumeCuller::vtkBackToFrontVolumeCuller() = default;

//------------------------------------------------------------------------------
vtkBackToFrontVolumeCuller::~vtkBackToFrontVolumeCuller() = default;

//------------------------------------------------------------------------------
double vtkBackToFrontVolumeCuller::Cull(
  vtkRenderer* renderer, vtkProp** props, int& numberOfProps, int& initialized)
{
  const Eye eye(renderer->GetActiveCamera());
  std::vector<Volume> volumes;
  std::vector<int> places;
  double time = 0;
  for (int i = 0; i < numberOfProps; ++i)
  {
    if (!initialized)
    {
      props[i]->SetRenderTimeMultiplier(1);
    }
    time += props[i]->GetRenderTimeMultiplier();
    if (vtkVolume::SafeDownCast(props[i]))
    {
      volumes.emplace_back(props[i], eye);
      places.push_back(i);
    }
  }
  initialized = 1;
  for (int place : places)
  {
    props[place] = TakeNext(volumes, eye).Prop;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkBackToFrontVolumeCuller::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
