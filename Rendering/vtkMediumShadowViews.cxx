// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumShadowViews.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Depths are stored a little beyond the volume, so that no point of it is cut off by rounding.
constexpr double DepthMargin = 1e-3;
// A single view of a positional light is no wider than that tangent of its half angle: pixels far from the
// middle are stretched.
constexpr double WidestTangent = 2;
// Cones are looked at a little wider than they are.
constexpr double ConeMargin = 1.01;

//------------------------------------------------------------------------------
// Any unit vector normal to the direction.
glm::dvec3 NormalTo(const glm::dvec3& direction)
{
  const glm::dvec3 size = glm::abs(direction);
  const glm::dvec3 axis = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
    : size.y <= size.z                                         ? glm::dvec3(0, 1, 0)
                                                               : glm::dvec3(0, 0, 1);
  return glm::normalize(glm::cross(direction, axis));
}

//------------------------------------------------------------------------------
struct Range
{
  glm::dvec3 Lower{ 1e300 }, Upper{ -1e300 };

  void Add(const glm::dvec3& point)
  {
    this->Lower = glm::min(this->Lower, point);
    this->Upper = glm::max(this->Upper, point);
  }
};
}

//------------------------------------------------------------------------------
glm::dmat4 vtkMediumShadowViews::View::LocalToClip() const
{
  const glm::dvec3 axes[3] = { glm::cross(this->Forward, this->Up), this->Up, -this->Forward };
  glm::dmat4 toView(1);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      toView[column][row] = axes[row][column];
    }
    toView[3][row] = -glm::dot(axes[row], this->Eye);
  }
  return this->Projection * toView;
}

//------------------------------------------------------------------------------
vtkMediumShadowViews::vtkMediumShadowViews(
  const vtkMediumScene::Light& light, const vtkMediumScene::Box& box, int pixels)
  : Inner((pixels - 2.0) / pixels)
{
  for (int i = 0; i < 8; ++i)
  {
    this->LocalCorners[i] = box.BoxToLocal(glm::dvec3(i & 1, i >> 1 & 1, i >> 2 & 1));
  }
  this->OfFace.fill(0);
  if (light.Type == vtkMediumScene::Light::Directional)
  {
    this->AddParallel(light.Direction);
  }
  else if (!this->AddFitted(light))
  {
    this->AddCube(light.Position);
  }
  if (this->Views.empty())
  {
    this->OfFace.fill(-1);
  }
}

//------------------------------------------------------------------------------
std::array<glm::dvec3, 8> vtkMediumShadowViews::Corners(const View& view) const
{
  const glm::dvec3 right = glm::cross(view.Forward, view.Up);
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 way = this->LocalCorners[i] - view.Eye;
    corners[i] = { glm::dot(way, right), glm::dot(way, view.Up), glm::dot(way, view.Forward) };
  }
  return corners;
}

//------------------------------------------------------------------------------
// From `lower` to `upper`: lengths in parallel views, tangents in others.
void vtkMediumShadowViews::Project(View& view, const glm::dvec2& lower, const glm::dvec2& upper,
  double nearest, double farthest) const
{
  glm::dmat4& projection = view.Projection;
  projection = glm::dmat4(0);
  const double n = nearest, f = farthest;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double scale = this->Inner / (upper[axis] - lower[axis]);
    projection[axis][axis] = 2 * scale;
    const double shift = scale * (lower[axis] + upper[axis]);
    projection[view.Parallel ? 3 : 2][axis] = view.Parallel ? -shift : shift;
  }
  projection[2][2] = -(view.Parallel ? 2 : f + n) / (f - n);
  projection[3][2] = -(view.Parallel ? f + n : 2 * f * n) / (f - n);
  projection[2][3] = view.Parallel ? 0 : -1;
  projection[3][3] = view.Parallel ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkMediumShadowViews::AddParallel(const glm::dvec3& direction)
{
  View view;
  view.Parallel = true;
  view.Forward = direction;
  view.Up = NormalTo(direction);
  view.Eye = -direction; // the volume is within half a unit of the origin
  Range seen;
  for (const glm::dvec3& corner : this->Corners(view))
  {
    seen.Add(corner);
  }
  this->Project(
    view, seen.Lower, seen.Upper, seen.Lower.z - DepthMargin, seen.Upper.z + DepthMargin);
  this->Views.push_back(view);
}

//------------------------------------------------------------------------------
// One view of the volume, or of the cone if that is narrower; false where a cube is needed.
bool vtkMediumShadowViews::AddFitted(const vtkMediumScene::Light& light)
{
  const bool spot = light.Type == vtkMediumScene::Light::Spot;
  const double cone = spot && light.CosCone > 0
    ? ConeMargin * std::sqrt(1 - light.CosCone * light.CosCone) / light.CosCone
    : 2 * WidestTangent;
  View view;
  view.Eye = light.Position;
  const double distance = glm::length(light.Position);
  view.Forward = distance > 0 ? -light.Position / distance : glm::dvec3(0, 0, 1);
  view.Up = NormalTo(view.Forward);
  Range seen, tangents;
  for (const glm::dvec3& corner : this->Corners(view))
  {
    seen.Add(corner);
    tangents.Add(corner / std::max(corner.z, 1e-300));
  }
  const glm::dvec3 widest = glm::max(glm::abs(tangents.Lower), glm::abs(tangents.Upper));
  const double width = seen.Lower.z < NearestDepth ? 1e300 : std::max(widest.x, widest.y);
  if (std::min(cone, width) > WidestTangent)
  {
    return false;
  }
  if (cone < width)
  {
    this->AddCone(light, cone);
    return true;
  }
  this->Project(view, tangents.Lower, tangents.Upper, seen.Lower.z * (1 - DepthMargin / distance),
    seen.Upper.z * (1 + DepthMargin / distance));
  this->Views.push_back(view);
  return true;
}

//------------------------------------------------------------------------------
void vtkMediumShadowViews::AddCone(const vtkMediumScene::Light& light, double tangent)
{
  View view;
  view.Eye = light.Position;
  view.Forward = light.Direction;
  view.Up = NormalTo(view.Forward);
  Range seen;
  for (const glm::dvec3& corner : this->Corners(view))
  {
    seen.Add(corner);
  }
  if (seen.Upper.z > 0)
  {
    const double nearest = std::max(seen.Lower.z - DepthMargin, NearestDepth);
    this->Project(view, glm::dvec2(-tangent), glm::dvec2(tangent), nearest,
      std::max(seen.Upper.z + DepthMargin, 2 * nearest));
    this->Views.push_back(view);
  }
}

//------------------------------------------------------------------------------
void vtkMediumShadowViews::AddCube(const glm::dvec3& position)
{
  for (int face = 0; face < Faces; ++face)
  {
    View view;
    view.Eye = position;
    view.Forward = glm::dvec3(0);
    view.Forward[face / 2] = face % 2 == 0 ? 1 : -1;
    view.Up = glm::dvec3(0);
    view.Up[(face / 2 + 1) % 3] = 1;
    Range seen;
    int beside[4] = { 0, 0, 0, 0 }; // corners beyond each side of the face
    for (const glm::dvec3& corner : this->Corners(view))
    {
      seen.Add(corner);
      const double edge = ConeMargin * corner.z;
      beside[0] += corner.x > edge;
      beside[1] += corner.x < -edge;
      beside[2] += corner.y > edge;
      beside[3] += corner.y < -edge;
    }
    const bool isSeen = seen.Upper.z > 0 && *std::max_element(beside, beside + 4) < 8;
    this->OfFace[face] = isSeen ? static_cast<int>(this->Views.size()) : -1;
    if (isSeen)
    {
      const double nearest = std::max(seen.Lower.z - DepthMargin, NearestDepth);
      this->Project(view, glm::dvec2(-1), glm::dvec2(1), nearest,
        std::max(seen.Upper.z + DepthMargin, 2 * nearest));
      this->Views.push_back(view);
    }
  }
}
