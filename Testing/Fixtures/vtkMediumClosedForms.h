// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumClosedForms.h
 * @brief Single scattering and optical depths that have a closed form, in double precision.
 *
 * None of the product's formulas are used, and nothing of VTK. Lengths are world units, directions unit
 * vectors in world space; `toLight` points towards a directional light of irradiance 1, sigma is the
 * extinction of a medium of albedo 1, and radiance is that of a phase function of 1 per steradian: multiply
 * it by the phase function's value, and by `Isotropic` for isotropic scattering.
 *
 * A: a box under a beam. B: a ball whose light comes along the view or from behind the eye. C: a point source
 * in a homogeneous medium. D: the exponential atmosphere. E: a linear ramp. F: the furnace. G, reciprocity,
 * has its thin limit. Then the reflection and transmission of a slab.
 */
#ifndef vtkMediumClosedForms_h
#define vtkMediumClosedForms_h

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

/// Composite Simpson's rule.
inline double Simpson(double a, double b, int intervals, const std::function<double(double)>& f)
{
  const double h = (b - a) / intervals;
  double sum = f(a) + f(b);
  for (int i = 1; i < intervals; ++i)
  {
    sum += (i % 2 ? 4 : 2) * f(a + i * h);
  }
  return sum * h / 3;
}

/// B: a ball of which the eye sees a chord, lit along the view from behind it: every path has the chord's
/// length.
inline double BallLitFromBehind(double chord, double sigma)
{
  return sigma * chord * std::exp(-sigma * chord);
}

/// B: the same, lit from the eye: light goes in and out by the same way.
inline double BallLitFromTheEye(double chord, double sigma)
{
  return sigma * chord * MeanTransmittance(2 * sigma * chord);
}

/// The chord of a ball around the origin along a ray; 0 where it misses.
inline double BallChord(const Ray& ray, double radius)
{
  const double foot = -glm::dot(ray.Origin, ray.Direction);
  const glm::dvec3 nearest = ray.Origin + foot * ray.Direction;
  const double square = radius * radius - glm::dot(nearest, nearest);
  return square > 0 ? 2 * std::sqrt(square) : 0;
}

/// C: a point source of intensity 1 in a homogeneous medium, over the part of the ray between `first` and
/// `last`, the radiance that arrives at `first` (Sun, Ramamoorthi, Narasimhan and Nayar 2005,
/// doi:10.1145/1073204.1073309). The integrand is smooth in the angle; 20000 intervals of Simpson's rule keep
/// 1e-12 of the integral.
inline double PointSourceRadiance(
  const Ray& ray, const glm::dvec3& source, double sigma, double first, double last)
{
  const double foot = glm::dot(source - ray.Origin, ray.Direction);
  const double distance = glm::length(ray.Origin + foot * ray.Direction - source);
  const double begin = std::atan((first - foot) / distance);
  const double end = std::atan((last - foot) / distance);
  const double integral = Simpson(begin, end, 20000,
    [&](double angle) { return std::exp(-sigma * distance * std::tan(Pi / 4 + angle / 2)); });
  return sigma * std::exp(-sigma * (foot - first)) / distance * integral;
}

/// D: optical depth of sigma exp(-z / height) from a point at height z0 over a length s whose direction rises
/// by `slope` per unit of length.
inline double AtmosphereDepth(double sigma, double height, double z0, double slope, double s)
{
  return sigma * std::exp(-z0 / height) * s * MeanTransmittance(s * slope / height);
}

/// E: optical depth of an extinction that begins as `a` and grows by b per unit of length, over the length s.
inline double RampDepth(double a, double b, double s)
{
  return s * (a + 0.5 * b * s);
}

/// F: light that arrives unweakened everywhere, in a medium of constant albedo and optical depth tau, whatever
/// its density; an upper bound where light is weakened.
inline double FurnaceRadiance(double albedo, double tau)
{
  return -albedo * std::expm1(-tau);
}

/// G, thin limit: the power per unit of irradiance that a medium scatters into any view, the integral of its
/// radiance over the picture's area.
inline double ThinPower(double volume, double sigma)
{
  return sigma * volume;
}

/// Reflection of a wide slab of optical depth tau (Chandrasekhar, Radiative Transfer): mu is the cosine
/// between its normal and the view, mu0 that of the light.
inline double SlabReflection(double tau, double mu, double mu0)
{
  return mu0 / (mu0 + mu) * -std::expm1(-tau * (1 / mu + 1 / mu0));
}

/// Transmission of the slab: mu0 / (mu0 - mu) (exp(-tau / mu0) - exp(-tau / mu)), in a form that does not cancel
/// where mu and mu0 meet.
inline double SlabTransmission(double tau, double mu, double mu0)
{
  return tau / mu * std::exp(-tau / mu0) * MeanTransmittance(tau * (1 / mu - 1 / mu0));
}
}

#endif
