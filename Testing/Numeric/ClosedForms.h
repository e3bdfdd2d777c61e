// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClosedForms.h
 * @brief Homogeneous media whose single scattering has a closed form, in double precision.
 *
 * None of the product's formulas are used. Directions are unit vectors in world space; `toLight` points
 * towards a directional light of irradiance 1.
 */
#ifndef ClosedForms_h
#define ClosedForms_h

#include "vtkMediumTestScene.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace vtkMediumTest
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Isotropic = 1 / (4 * Pi); ///< phase function, per steradian

/// A ray of the camera: origin + t direction, t in world units from the eye (from the near plane in
/// parallel projection).
struct Ray
{
  glm::dvec3 Origin, Direction;
  double Near; ///< t of the near plane
};

/// The ray through a pixel's centre.
inline Ray EyeRay(vtkCamera* camera, int pixels, int x, int y)
{
  glm::dvec3 eye, forward, up;
  camera->GetPosition(&eye[0]);
  camera->GetDirectionOfProjection(&forward[0]);
  camera->GetViewUp(&up[0]);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
  up = glm::cross(right, forward);
  const double u = (2 * x + 1.0) / pixels - 1, v = (2 * y + 1.0) / pixels - 1;
  const double nearest = camera->GetClippingRange()[0];
  if (camera->GetParallelProjection())
  {
    const double half = camera->GetParallelScale();
    return { eye + half * (u * right + v * up) + nearest * forward, forward, 0 };
  }
  const double half = std::tan(camera->GetViewAngle() * Pi / 360);
  const glm::dvec3 direction = forward + half * (u * right + v * up);
  return { eye, glm::normalize(direction), nearest * glm::length(direction) };
}

/// A parallelepiped: world = Axes * box + Origin, box in [0, 1]^3.
struct Box
{
  glm::dmat3 Axes{ 1 };
  glm::dvec3 Origin{ 0 };

  explicit Box(const glm::dvec3& size)
    : Origin(-0.5 * size)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Axes[axis] *= size[axis];
    }
  }

  /// Where a ray is inside: (first, last) t, first >= last if nowhere.
  std::array<double, 2> Intersect(const Ray& ray) const
  {
    const glm::dmat3 inverse = glm::inverse(this->Axes);
    const glm::dvec3 o = inverse * (ray.Origin - this->Origin), d = inverse * ray.Direction;
    double first = ray.Near, last = 1e300;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double a = -o[axis] / d[axis], b = (1 - o[axis]) / d[axis];
      first = d[axis] != 0 ? std::max(first, std::min(a, b)) : first;
      last = d[axis] != 0 ? std::min(last, std::max(a, b)) : last;
      last = d[axis] == 0 && (o[axis] < 0 || o[axis] > 1) ? -1e300 : last;
    }
    return { first, last };
  }

  /// The way from a point inside to where a ray towards the light leaves through one axis' face.
  double ToFace(const glm::dvec3& point, const glm::dvec3& toLight, int axis) const
  {
    const glm::dmat3 inverse = glm::inverse(this->Axes);
    const double p = (inverse * (point - this->Origin))[axis], w = (inverse * toLight)[axis];
    return std::abs(w) < 1e-14 ? 1e300 : ((w > 0 ? 1 : 0) - p) / w;
  }

  double LightPath(const glm::dvec3& point, const glm::dvec3& toLight) const
  {
    return std::min({ this->ToFace(point, toLight, 0), this->ToFace(point, toLight, 1),
      this->ToFace(point, toLight, 2) });
  }
};

/// (1 - exp(-x)) / x.
inline double MeanTransmittance(double x)
{
  return std::abs(x) < 1e-12 ? 1 : -std::expm1(-x) / x;
}

/// Where along the ray the light path changes from one face of the box to another.
inline std::vector<double> FacesChange(
  const Box& box, const Ray& ray, const glm::dvec3& toLight, double first, double last)
{
  std::vector<double> cuts = { first, last };
  auto difference = [&](double t, int a, int b) {
    const glm::dvec3 point = ray.Origin + t * ray.Direction;
    return box.ToFace(point, toLight, a) - box.ToFace(point, toLight, b);
  };
  for (int a = 0; a < 3; ++a)
  {
    const int b = (a + 1) % 3;
    const double f = difference(first, a, b), g = difference(last, a, b);
    const double cut = first + (last - first) * f / (f - g); // a linear function's zero
    if (std::isfinite(cut) && cut > first && cut < last)
    {
      cuts.push_back(cut);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/// Radiance of a box of extinction sigma and scattering sigma per steradian of phase 1, seen between
/// `first` and `last`: over a piece of length d whose light path is l0 + kappa s,
/// sigma exp(-sigma l0) d phi(sigma (1 + kappa) d).
inline double BoxRadiance(const Box& box, const Ray& ray, const glm::dvec3& toLight, double sigma,
  double first, double last)
{
  double radiance = 0;
  const std::vector<double> cuts = FacesChange(box, ray, toLight, first, last);
  for (std::size_t i = 1; i < cuts.size(); ++i)
  {
    const double d = cuts[i] - cuts[i - 1];
    const double l0 = box.LightPath(ray.Origin + cuts[i - 1] * ray.Direction, toLight);
    const double l1 = box.LightPath(ray.Origin + cuts[i] * ray.Direction, toLight);
    radiance += sigma * std::exp(-sigma * (cuts[i - 1] - first + l0)) * d *
      MeanTransmittance(sigma * (d + l1 - l0));
  }
  return radiance;
}

/// The same for the whole of the box that the ray meets; 0 where it misses.
inline double BoxRadiance(const Box& box, const Ray& ray, const glm::dvec3& toLight, double sigma)
{
  const std::array<double, 2> t = box.Intersect(ray);
  return t[0] < t[1] ? BoxRadiance(box, ray, toLight, sigma, t[0], t[1]) : 0;
}

/// Henyey and Greenstein's function as they wrote it.
inline double HenyeyGreenstein(double cosTheta, double g)
{
  return (1 - g * g) / (4 * Pi * std::pow(1 + g * g - 2 * g * cosTheta, 1.5));
}

/// Schlick's function, of k.
inline double Schlick(double cosTheta, double k)
{
  return (1 - k * k) / (4 * Pi * std::pow(1 - k * cosTheta, 2));
}

/// Calls visit(x, y, ray) for every pixel.
inline void ForEachPixel(Scene& scene, const std::function<void(int, int, const Ray&)>& visit)
{
  for (int y = 0; y < scene.Pixels; ++y)
  {
    for (int x = 0; x < scene.Pixels; ++x)
    {
      visit(x, y, EyeRay(scene.Camera, scene.Pixels, x, y));
    }
  }
}
}

#endif
