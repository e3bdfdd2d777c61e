// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file QuadShadow.h
 * @brief Where along a ray the shadow of a parallelogram is, in closed form.
 */
#ifndef QuadShadow_h
#define QuadShadow_h

#include "OpaquePlane.h"

#include <glm/vec4.hpp>

namespace vtkMediumTest
{
/// The part of space to which a parallelogram lets no light: behind its plane, and between the planes
/// through its edges that the light is in. All in world coordinates.
struct QuadShadow
{
  std::vector<glm::dvec4> Inside; ///< half-spaces: dot(xyz, point) + w <= 0

  /// `light` is (position, 1), or (direction towards the light, 0). The shadow's sides are moved outwards by
  /// `grown`.
  QuadShadow(const Quad& quad, const glm::dvec4& light, double grown = 0)
  {
    const glm::dvec3 center = quad.Corner + 0.5 * (quad.U + quad.V);
    const auto toLight = [&](const glm::dvec3& from) { return glm::dvec3(light) - light.w * from; };
    glm::dvec3 normal = glm::normalize(glm::cross(quad.U, quad.V));
    normal *= glm::dot(normal, toLight(center)) < 0 ? -1 : 1;
    this->Add(normal, quad.Corner);
    const glm::dvec3 corners[4] = { quad.Corner, quad.Corner + quad.U,
      quad.Corner + quad.U + quad.V, quad.Corner + quad.V };
    for (int i = 0; i < 4; ++i)
    {
      const glm::dvec3 edge = corners[(i + 1) % 4] - corners[i];
      glm::dvec3 side = glm::normalize(glm::cross(edge, toLight(corners[i])));
      side *= glm::dot(side, center - corners[i]) > 0 ? -1 : 1;
      this->Add(side, corners[i] + grown * side);
    }
  }

  /// (first, last) t of the shadow along the ray, first >= last if it misses it.
  std::array<double, 2> Intersect(const Ray& ray) const
  {
    std::array<double, 2> t = { -1e300, 1e300 };
    for (const glm::dvec4& plane : this->Inside)
    {
      const double at = glm::dot(glm::dvec3(plane), ray.Origin) + plane.w;
      const double slope = glm::dot(glm::dvec3(plane), ray.Direction);
      if (slope == 0)
      {
        t[1] = at > 0 ? -1e300 : t[1];
      }
      else
      {
        const double cut = -at / slope;
        slope > 0 ? t[1] = std::min(t[1], cut) : t[0] = std::max(t[0], cut);
      }
    }
    return t;
  }

  /// The integral over the parts of first...last that are lit, where `between(a, b)` is that over a part.
  double Lit(const Ray& ray, double first, double last,
    const std::function<double(double, double)>& between) const
  {
    const std::array<double, 2> dark = this->Intersect(ray);
    if (dark[0] >= dark[1])
    {
      return between(first, last);
    }
    const double begin = glm::clamp(dark[0], first, last), end = glm::clamp(dark[1], first, last);
    return (begin > first ? between(first, begin) : 0) + (last > end ? between(end, last) : 0);
  }

private:
  void Add(const glm::dvec3& normal, const glm::dvec3& point)
  {
    this->Inside.push_back({ normal, -glm::dot(normal, point) });
  }
};
}

#endif
