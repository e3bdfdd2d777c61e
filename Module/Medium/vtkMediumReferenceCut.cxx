// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumReferenceCut.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>

namespace
{
using Plane = vtkMediumCut::Plane;

// How far outside the box, as a fraction of it, an edge still counts: rounding.
constexpr double BoxMargin = 1e-9;

//------------------------------------------------------------------------------
std::vector<Plane> PlanesOf(const vtkMediumCut& cut)
{
  std::vector<Plane> planes = cut.Planes;
  if (cut.CutsRegions())
  {
    planes.insert(planes.end(), cut.Lower, cut.Lower + 3);
    planes.insert(planes.end(), cut.Upper, cut.Upper + 3);
  }
  return planes;
}

//------------------------------------------------------------------------------
// Box coordinate `axis` is 0 or 1; not normalised, for only where the distance is 0 counts.
Plane FaceOf(const vtkMediumScene::Box& box, int axis, double coordinate)
{
  const glm::dmat3& axes = box.LocalToBoxAxes;
  return { { axes[0][axis], axes[1][axis], axes[2][axis] },
    box.LocalToBoxOrigin[axis] - coordinate };
}

//------------------------------------------------------------------------------
// Of two planes f and g. The light ray p + s w, w = light - p or the way to a directional light, meets both
// at once where f(p) g(light) = g(p) f(light), with f(w) = f.Normal . w for a directional one: linear in
// the position along the eye ray.
class Edge
{
public:
  Edge(const Plane& f, const Plane& g, const vtkMediumScene::Light& light)
    : F(f)
    , G(g)
    , Positional(light.Type != vtkMediumScene::Light::Directional)
    , Light(this->Positional ? light.Position : -light.Direction)
  {
  }

  /// The fraction of the way from a to b, outside of (0,1) if there is none.
  double Cross(const glm::dvec3& a, const glm::dvec3& b) const
  {
    const double atA = this->Side(a), atB = this->Side(b);
    return atA != atB ? atA / (atA - atB) : -1;
  }

  /// Where the light ray from `point` meets the edge; false if behind the point or the light.
  bool Meet(const glm::dvec3& point, glm::dvec3& at) const
  {
    const glm::dvec3 way = this->Positional ? this->Light - point : this->Light;
    const double slopeF = glm::dot(this->F.Normal, way), slopeG = glm::dot(this->G.Normal, way);
    const bool useF = std::abs(slopeF) > std::abs(slopeG);
    const double reach =
      useF ? -this->F.Distance(point) / slopeF : -this->G.Distance(point) / slopeG;
    at = point + reach * way;
    return reach > 0 && !(this->Positional && reach > 1);
  }

private:
  double AtLight(const Plane& plane) const
  {
    return this->Positional ? plane.Distance(this->Light) : glm::dot(plane.Normal, this->Light);
  }
  double Side(const glm::dvec3& at) const
  {
    return this->F.Distance(at) * this->AtLight(this->G) -
      this->G.Distance(at) * this->AtLight(this->F);
  }

  const Plane& F;
  const Plane& G;
  bool Positional;
  glm::dvec3 Light;
};
}

//------------------------------------------------------------------------------
std::vector<glm::dvec2> vtkMediumKeptParts(const vtkMediumCut& cut, const glm::dvec3& origin,
  const glm::dvec3& direction, double begin, double end)
{
  if (!(begin < end))
  {
    return {};
  }
  std::vector<double> borders{ begin, end };
  for (const Plane& plane : PlanesOf(cut))
  {
    const double t = -plane.Distance(origin) / glm::dot(plane.Normal, direction);
    if (t > begin && t < end) // false for a ray along the plane
    {
      borders.push_back(t);
    }
  }
  std::sort(borders.begin(), borders.end());
  std::vector<glm::dvec2> parts;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i)
  {
    const double middle = 0.5 * (borders[i] + borders[i + 1]);
    if (borders[i] < borders[i + 1] && cut.Keeps(origin + middle * direction))
    {
      parts.emplace_back(borders[i], borders[i + 1]);
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
void vtkMediumAppendCutEdges(const vtkMediumScene& scene, const vtkMediumScene::Light& light,
  const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
  std::vector<double>& cuts)
{
  std::vector<Plane> planes = PlanesOf(scene.Cut);
  const std::size_t own = planes.size();
  for (int face = 0; face < 6 && own > 0; ++face)
  {
    planes.push_back(FaceOf(scene.Geometry, face / 2, face % 2));
  }
  const glm::dvec3 first = origin + begin * direction, last = origin + end * direction;
  for (std::size_t f = 0; f < own; ++f)
  {
    for (std::size_t g = f + 1; g < planes.size(); ++g)
    {
      const Edge edge(planes[f], planes[g], light);
      const double fraction = edge.Cross(first, last);
      glm::dvec3 at;
      if (!(fraction > 0 && fraction < 1) || !edge.Meet(glm::mix(first, last, fraction), at))
      {
        continue;
      }
      const glm::dvec3 box = scene.Geometry.LocalToBox(at);
      if (glm::all(glm::greaterThan(box, glm::dvec3(-BoxMargin))) &&
        glm::all(glm::lessThan(box, glm::dvec3(1 + BoxMargin))))
      {
        cuts.push_back(begin + fraction * (end - begin));
      }
    }
  }
}
