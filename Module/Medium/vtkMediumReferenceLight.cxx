// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumReferenceLight.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// At a light itself the attenuation may be infinite: it is taken at this distance, local units.
constexpr double NearestDistance = 1e-12;

//------------------------------------------------------------------------------
// The irradiance on the axis of a positional light, as its attenuation leaves it.
glm::dvec3 Attenuated(const vtkMediumScene::Light& light, double distance)
{
  const double r = std::max(distance, NearestDistance);
  return light.Irradiance /
    (light.Attenuation[0] + r * (light.Attenuation[1] + r * light.Attenuation[2]));
}
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumBrightest(const vtkMediumScene::Light& light)
{
  return light.Type == vtkMediumScene::Light::Directional ? light.Irradiance : Attenuated(light, 0);
}

//------------------------------------------------------------------------------
vtkMediumIncidentLight vtkMediumReferenceLight(
  const vtkMediumScene::Light& light, const glm::dvec3& position)
{
  vtkMediumIncidentLight incident;
  incident.Irradiance = light.Irradiance;
  if (light.Type == vtkMediumScene::Light::Directional)
  {
    incident.Direction = light.Direction;
    incident.Distance = std::numeric_limits<double>::infinity();
    return incident;
  }
  const glm::dvec3 way = position - light.Position;
  incident.Distance = glm::length(way);
  incident.Direction = incident.Distance > 0 ? way / incident.Distance : light.Direction;
  incident.Irradiance = Attenuated(light, incident.Distance);
  if (light.Type == vtkMediumScene::Light::Spot)
  {
    const double cosine = glm::dot(incident.Direction, light.Direction);
    incident.Irradiance *=
      cosine >= light.CosCone && cosine > 0 ? std::pow(cosine, light.Exponent) : 0.0;
  }
  return incident;
}

//------------------------------------------------------------------------------
void vtkMediumAppendLightCuts(const vtkMediumScene::Light& light, const glm::dvec3& origin,
  const glm::dvec3& direction, std::vector<double>& cuts)
{
  if (light.Type == vtkMediumScene::Light::Directional)
  {
    return;
  }
  const glm::dvec3 way = origin - light.Position;
  const double foot = -glm::dot(way, direction);
  cuts.push_back(foot);
  if (light.Type != vtkMediumScene::Light::Spot)
  {
    return;
  }
  // ((way + t direction) . axis)^2 = cos^2 |way + t direction|^2, with t counted from the foot, where
  // the linear term of the right side vanishes.
  const glm::dvec3 nearest = way + foot * direction;
  const double along = glm::dot(direction, light.Direction);
  const double height = glm::dot(nearest, light.Direction);
  const double cosine2 = light.CosCone * light.CosCone;
  const double a = along * along - cosine2;
  const double b = along * height; // half of the linear term
  const double c = height * height - cosine2 * glm::dot(nearest, nearest);
  const double discriminant = b * b - a * c;
  if (discriminant < 0)
  {
    return;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  if (a != 0)
  {
    cuts.push_back(foot + q / a);
  }
  if (q != 0)
  {
    cuts.push_back(foot + c / q);
  }
}
