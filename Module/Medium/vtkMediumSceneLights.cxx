// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumScene.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// The lights that are on; where there is none, the headlight that the renderer makes when it
// renders.
std::vector<vtkSmartPointer<vtkLight>> FindLights(vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkLight>> result;
  vtkCollectionSimpleIterator iterator;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      result.push_back(light);
    }
  }
  if (result.empty() && renderer->GetAutomaticLightCreation() && renderer->IsActiveCameraCreated())
  {
    vtkNew<vtkLight> headlight;
    headlight->SetLightTypeToHeadlight();
    result.push_back(headlight.Get());
  }
  return result;
}

//------------------------------------------------------------------------------
glm::dvec3 Transform(vtkMatrix4x4* matrix, const glm::dvec3& point)
{
  const double in[4] = { point.x, point.y, point.z, 1 };
  double out[4];
  matrix->MultiplyPoint(in, out);
  return { out[0], out[1], out[2] };
}

//------------------------------------------------------------------------------
// World position and focal point. A renderer moves head- and camera lights with its camera only
// when it renders, so their place is computed from the camera of now.
void FindPose(vtkRenderer* renderer, vtkLight* light, glm::dvec3& position, glm::dvec3& focus)
{
  vtkCamera* camera =
    renderer && renderer->GetLightFollowCamera() && renderer->IsActiveCameraCreated()
    ? renderer->GetActiveCamera()
    : nullptr;
  vtkMatrix4x4* matrix = light->GetTransformMatrix();
  light->GetPosition(&position[0]);
  light->GetFocalPoint(&focus[0]);
  if (camera && light->LightTypeIsHeadlight())
  {
    camera->GetPosition(&position[0]);
    camera->GetFocalPoint(&focus[0]);
  }
  else if (camera && light->LightTypeIsCameraLight())
  {
    matrix = camera->GetCameraLightTransformMatrix();
  }
  if (matrix)
  {
    position = Transform(matrix, position);
    focus = Transform(matrix, focus);
  }
}

/// Colour x intensity: a float holds it, and leaves room for what a phase function and a near light multiply.
constexpr double BrightestLight = 1e30;

//------------------------------------------------------------------------------
bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

//------------------------------------------------------------------------------
// The unit vector from one place to another, whose square may be beyond a double; 0 if they are the same.
glm::dvec3 FindDirection(const glm::dvec3& from, const glm::dvec3& to)
{
  const glm::dvec3 way = 0.5 * to - 0.5 * from;
  const double largest = std::max({ std::abs(way.x), std::abs(way.y), std::abs(way.z) });
  return largest > 0 ? glm::normalize(way / largest) : glm::dvec3(0);
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& out, const glm::dvec3& v)
{
  return out << "(" << v.x << ", " << v.y << ", " << v.z << ")";
}

//------------------------------------------------------------------------------
std::string CheckLight(
  const vtkMediumScene::Light& light, const glm::dvec3& position, const glm::dvec3& focus)
{
  using Light = vtkMediumScene::Light;
  const glm::dvec3& E = light.Irradiance;
  const glm::dvec3& abc = light.Attenuation;
  std::ostringstream problem;
  if (!IsFinite(position) || !IsFinite(focus))
  {
    problem << "A light is at " << position << " with its focal point at " << focus
            << "; give it a finite place.";
  }
  else if (!IsFinite(E) || !(E.x >= 0 && E.y >= 0 && E.z >= 0))
  {
    problem << "A light's diffuse colour times its intensity is " << E
            << "; set finite values >= 0.";
  }
  else if (std::max({ E.x, E.y, E.z }) > BrightestLight)
  {
    problem << "A light's diffuse colour times its intensity is " << E
            << ", of which the radiance is beyond a float; set values up to " << BrightestLight
            << ".";
  }
  else if (light.Type != Light::Point && FindDirection(position, focus) == glm::dvec3(0))
  {
    problem << "A light has its position and its focal point both at " << position
            << "; a directional or spot light needs them apart, for its direction.";
  }
  else if (light.Type != Light::Directional &&
    (!IsFinite(abc) || !(abc.x >= 0 && abc.y >= 0 && abc.z >= 0) || abc == glm::dvec3(0)))
  {
    problem << "A positional light's attenuation values are " << abc
            << "; set finite values >= 0 that are not all 0, (0, 0, 1) for the inverse square.";
  }
  return problem.str();
}

//------------------------------------------------------------------------------
// Whether a light sends anything into the sphere around the volume. A spot does so where its cone, as seen
// from it, meets the disc of the sphere.
bool Reaches(const vtkMediumScene::Light& light)
{
  const double radius = 0.5; // the volume's longest diagonal is one local unit
  const double distance = glm::length(light.Position);
  if (light.Irradiance == glm::dvec3(0))
  {
    return false;
  }
  if (light.Type != vtkMediumScene::Light::Spot || distance <= radius)
  {
    return true;
  }
  const double rounding = 1e-6;
  const double cosine = -glm::dot(light.Direction, light.Position) / distance;
  const double off = std::acos(glm::clamp(cosine, -1.0, 1.0));
  return off <= std::acos(light.CosCone) + std::asin(radius / distance) + rounding;
}
}

//------------------------------------------------------------------------------
std::string vtkMediumScene::ReadLight(vtkRenderer* renderer, vtkLight* source, Light& light) const
{
  glm::dvec3 position, focus;
  FindPose(renderer, source, position, focus);
  source->GetDiffuseColor(&light.Irradiance[0]);
  light.Irradiance *= source->GetIntensity();
  if (source->GetPositional())
  {
    source->GetAttenuationValues(&light.Attenuation[0]);
    light.Type = source->GetConeAngle() < 90 ? Light::Spot : Light::Point;
  }
  std::string problem = CheckLight(light, position, focus);
  if (!problem.empty())
  {
    return problem;
  }

  const glm::dvec3 direction = FindDirection(position, focus);
  if (direction != glm::dvec3(0))
  {
    light.Direction = direction;
  }
  if (light.Type != Light::Directional)
  {
    const double length = this->Geometry.Length;
    light.Attenuation *= glm::dvec3(1, length, length * length);
    light.Position = this->Geometry.WorldToLocal(position);
    if (!Box::IsPlace(light.Position))
    {
      std::ostringstream distant;
      distant << "A positional light is at " << position << ", more than " << Box::Farthest
              << " times the volume's diagonal of " << length
              << " away from it; place it nearer, or make it directional (PositionalOff).";
      return distant.str();
    }
  }
  if (light.Type == Light::Spot)
  {
    light.CosCone = std::cos(vtkMath::RadiansFromDegrees(source->GetConeAngle()));
    light.Exponent = source->GetExponent();
  }
  return {};
}

//------------------------------------------------------------------------------
std::string vtkMediumScene::GatherLights(vtkRenderer* renderer)
{
  this->Lights.clear();
  for (vtkLight* source : FindLights(renderer))
  {
    Light light;
    const std::string problem = this->ReadLight(renderer, source, light);
    if (!problem.empty())
    {
      this->Lights.clear();
      return problem;
    }
    if (Reaches(light))
    {
      this->Lights.push_back(light);
    }
  }
  return {};
}
