// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumCut.h"

#include "vtkAbstractTransform.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <glm/vec4.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
// Of gradient . world + constant >= 0. The gradient is not 0.
vtkMediumCut::Plane ToLocal(
  const glm::dvec3& gradient, double constant, const vtkMediumCut::Box& box)
{
  const double size = glm::length(gradient);
  return { gradient / size, (glm::dot(gradient, box.Center) + constant) / (size * box.Length) };
}

//------------------------------------------------------------------------------
// Which of the regions 0, 1, 2 along an axis are kept anywhere, as bits.
int FindDigits(int regions, int axis)
{
  const int stride = axis == 0 ? 1 : axis == 1 ? 3 : 9;
  int digits = 0;
  for (int region = 0; region < 27; ++region)
  {
    digits |= regions >> region & 1 ? 1 << region / stride % 3 : 0;
  }
  return digits;
}

//------------------------------------------------------------------------------
// Whether the regions are all those whose digits are kept, and these are neighbours.
bool IsBox(int regions, const int digits[3])
{
  int box = 0;
  for (int region = 0; region < 27; ++region)
  {
    const bool inside = (digits[0] >> region % 3 & 1) && (digits[1] >> region / 3 % 3 & 1) &&
      (digits[2] >> region / 9 & 1);
    box |= inside ? 1 << region : 0;
  }
  const int outerOnly = 5; // the regions 0 and 2 without the one between them
  return regions == box && std::find(digits, digits + 3, outerOnly) == digits + 3;
}
}

//------------------------------------------------------------------------------
std::string vtkMediumCut::Gather(vtkAbstractVolumeMapper* mapper, vtkVolume* volume, const Box& box)
{
  *this = vtkMediumCut();
  if (!mapper)
  {
    return {};
  }
  const std::string problem = this->GatherClipping(mapper, box);
  return problem.empty() ? this->GatherCropping(mapper, volume, box) : problem;
}

//------------------------------------------------------------------------------
std::string vtkMediumCut::GatherClipping(vtkAbstractVolumeMapper* mapper, const Box& box)
{
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  const int count = planes ? planes->GetNumberOfItems() : 0;
  for (int i = 0; i < count; ++i)
  {
    vtkPlane* plane = vtkPlane::SafeDownCast(planes->GetItemAsObject(i));
    glm::dvec3 normal, origin;
    plane->GetNormal(&normal[0]);
    plane->GetOrigin(&origin[0]);
    const double size = glm::length(normal);
    std::ostringstream problem;
    if (!(size > 0) || !std::isfinite(size) || !std::isfinite(glm::dot(origin, origin)))
    {
      problem << "Clipping plane " << i << " has the normal (" << normal.x << ", " << normal.y
              << ", " << normal.z << ") and the origin (" << origin.x << ", " << origin.y << ", "
              << origin.z << "); give it finite numbers and a normal that is not zero.";
      return problem.str();
    }
    if (plane->GetTransform())
    {
      problem << "Clipping plane " << i << " has a transform ("
              << plane->GetTransform()->GetClassName()
              << "), which clipping does not take into account; transform its origin and normal "
                 "instead, and remove it (SetTransform(nullptr)).";
      return problem.str();
    }
    normal /= size;
    this->AddUnlessBeside(ToLocal(normal, -glm::dot(normal, origin), box), box);
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkMediumCut::GatherCropping(
  vtkAbstractVolumeMapper* mapper, vtkVolume* volume, const Box& box)
{
  vtkVolumeMapper* cropping = vtkVolumeMapper::SafeDownCast(mapper);
  if (!cropping || !cropping->GetCropping())
  {
    return {};
  }
  double planes[6];
  cropping->GetCroppingRegionPlanes(planes);
  vtkNew<vtkMatrix4x4> worldToData;
  vtkMatrix4x4::Invert(volume->GetMatrix(), worldToData);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double lower = planes[2 * axis], upper = planes[2 * axis + 1];
    if (!(lower <= upper) || !std::isfinite(lower) || !std::isfinite(upper))
    {
      std::ostringstream problem;
      problem << "Cropping along "
              << "xyz"[axis] << " lies between " << lower << " and " << upper
              << "; give the lower plane first, and finite numbers (SetCroppingRegionPlanes).";
      return problem.str();
    }
    const glm::dvec3 gradient(worldToData->GetElement(axis, 0), worldToData->GetElement(axis, 1),
      worldToData->GetElement(axis, 2));
    const double constant = worldToData->GetElement(axis, 3);
    this->Lower[axis] = ToLocal(gradient, constant - lower, box);
    this->Upper[axis] = ToLocal(gradient, constant - upper, box);
  }

  this->Regions = cropping->GetCroppingRegionFlags() & AllRegions;
  const int digits[3] = { FindDigits(this->Regions, 0), FindDigits(this->Regions, 1),
    FindDigits(this->Regions, 2) };
  if (this->Regions == 0 || !IsBox(this->Regions, digits))
  {
    return {};
  }
  this->Regions = AllRegions;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = digits[axis] & 1 ? 0 : digits[axis] & 2 ? 1 : 2;
    const int last = digits[axis] & 4 ? 2 : digits[axis] & 2 ? 1 : 0;
    if (first > 0)
    {
      this->AddUnlessBeside(first == 1 ? this->Lower[axis] : this->Upper[axis], box);
    }
    if (last < 2)
    {
      const Plane& above = last == 1 ? this->Upper[axis] : this->Lower[axis];
      this->AddUnlessBeside({ -above.Normal, -above.Offset }, box);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkMediumCut::AddUnlessBeside(const Plane& plane, const Box& box)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 at(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    if (plane.Distance(box.Origin + box.Axes * at) < 0)
    {
      this->Planes.push_back(plane);
      return;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkMediumCut::MayKeep(const glm::dvec3 corners[8]) const
{
  const auto isBeside = [corners](const Plane& plane) {
    return std::all_of(corners, corners + 8,
      [&plane](const glm::dvec3& corner) { return plane.Distance(corner) < 0; });
  };
  if (std::any_of(this->Planes.begin(), this->Planes.end(), isBeside))
  {
    return false;
  }
  if (!this->CutsRegions())
  {
    return true;
  }
  int least[3] = { 2, 2, 2 }, most[3] = { 0, 0, 0 }; // the regions that the corners span
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int digit = this->FindDigit(axis, corners[corner]);
      least[axis] = std::min(least[axis], digit);
      most[axis] = std::max(most[axis], digit);
    }
  }
  for (int region = 0; region < 27; ++region)
  {
    const int digits[3] = { region % 3, region / 3 % 3, region / 9 };
    bool spanned = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      spanned = spanned && digits[axis] >= least[axis] && digits[axis] <= most[axis];
    }
    if (spanned && (this->Regions >> region & 1))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkMediumCut::HoldsWaysTo(const glm::dvec3& light, bool directional) const
{
  return !this->CutsRegions() &&
    std::all_of(this->Planes.begin(), this->Planes.end(), [&](const Plane& plane) {
      return (directional ? glm::dot(plane.Normal, light) : plane.Distance(light)) >= 0;
    });
}

//------------------------------------------------------------------------------
int vtkMediumCut::FindDigit(int axis, const glm::dvec3& local) const
{
  return (this->Lower[axis].Distance(local) >= 0 ? 1 : 0) +
    (this->Upper[axis].Distance(local) >= 0 ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkMediumCut::Keeps(const glm::dvec3& local) const
{
  for (const Plane& plane : this->Planes)
  {
    if (plane.Distance(local) < 0)
    {
      return false;
    }
  }
  int region = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    region = 3 * region + this->FindDigit(axis, local);
  }
  return !this->CutsRegions() || (this->Regions >> region & 1);
}
