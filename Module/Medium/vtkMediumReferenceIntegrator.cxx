// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumReferenceIntegrator.h"

#include "vtkMediumNearRay.h"
#include "vtkMediumReferenceCut.h"
#include "vtkMediumReferenceLight.h"
#include "vtkMediumReferencePhase.h"
#include "vtkMediumShadowEdges.h"

#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <limits>

namespace
{
// Of the tolerance, what the inner optical depths may use up.
constexpr double DepthShare = 0.05;

// Of the ray's tolerance, the least share that a piece of it gets, however short it is.
constexpr double LeastShare = 1e-3;

// Gauss-Legendre rules of 3 points and more see an exponential whose exponent changes by so much over
// the interval, to 1e-3 and better, so that their disagreement means something.
constexpr double SteepestDepth = 4;

// Behind this optical depth less than 1e-17 of the light is left.
constexpr double DarkestDepth = 40;

// The outermost nodes of the rules leave so much of their range uncovered at either end.
constexpr double UncoveredRange = 0.12;

// A kink between two points needs about log2 of (error / tolerance) / 2 bisections; a steep
// exponential needs one for each factor 2 of its steepness.
constexpr int MaximumBisections = 40;
constexpr int MaximumSteepBisections = 1000;
}

//------------------------------------------------------------------------------
// What the samples of an interval have shown beside their sum: the range of a light's optical depth.
struct vtkMediumReferenceIntegrator::LightRange
{
  glm::dvec3 Least{ std::numeric_limits<double>::infinity() };
  glm::dvec3 Most{ 0 };

  void Add(const glm::dvec3& depth)
  {
    this->Least = glm::min(this->Least, depth);
    this->Most = glm::max(this->Most, depth);
  }

  /// True if the light may shine between the samples and the interval's ends unseen, in a channel in which
  /// the eye sees them.
  bool IsSteep(const glm::bvec3& seen) const
  {
    const glm::dvec3 range = this->Most - this->Least;
    const glm::dvec3 least = this->Least - UncoveredRange * range;
    for (int c = 0; c < 3; ++c)
    {
      if (seen[c] && range[c] > SteepestDepth && least[c] < DarkestDepth)
      {
        return true;
      }
    }
    return false;
  }
};

//------------------------------------------------------------------------------
struct vtkMediumReferenceIntegrator::Ray
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
  double Tolerance; ///< absolute, of the whole ray's radiance
  bool Estimate;
  std::vector<LightRange> Lights; ///< of the interval that is being looked at
};

// Where a ray's source is not smooth.
struct vtkMediumReferenceIntegrator::Kinks
{
  const std::vector<double>& OfLights;
  const std::vector<vtkMediumShadowEdges>& OfShadows; ///< between voxels, found cell by cell
};

// A part of a ray without a face, kink or foot point in it.
struct vtkMediumReferenceIntegrator::Piece
{
  Ray& Eye;
  const vtkMediumRayCells& Cells;
  double Begin;
  glm::dvec3 DepthToBegin; ///< optical depth from the eye
  double Tolerance;        ///< absolute, of this piece's radiance
};

//------------------------------------------------------------------------------
vtkMediumReferenceIntegrator::vtkMediumReferenceIntegrator(
  const vtkMediumScene& scene, const vtkMediumReferenceContent& content, double tolerance)
  : Scene(scene)
  , Content(content)
  , Tolerance(tolerance)
  , Depth(scene, content, DepthShare * tolerance)
{
}

//------------------------------------------------------------------------------
vtkMediumReferenceIntegrator::Result vtkMediumReferenceIntegrator::Evaluate(
  const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
  double peak) const
{
  if (!(peak > 0))
  {
    peak = vtkMediumMagnitude(this->Estimate(origin, direction, begin, end).Radiance);
  }
  Ray ray{ origin, direction, this->Tolerance * peak, false, {} };
  return this->Integrate(ray, begin, end);
}

//------------------------------------------------------------------------------
vtkMediumReferenceIntegrator::Result vtkMediumReferenceIntegrator::Estimate(
  const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end) const
{
  Ray ray{ origin, direction, 0, true, {} };
  return this->Integrate(ray, begin, end);
}

//------------------------------------------------------------------------------
vtkMediumReferenceIntegrator::Result vtkMediumReferenceIntegrator::Integrate(
  Ray& ray, double begin, double end) const
{
  Result result;
  const vtkMediumNearRay near(ray.Origin, ray.Direction, begin, end);
  ray.Origin = near.Origin;
  begin = near.Begin;
  end = near.End;
  const vtkMediumBoxRay boxRay(this->Scene.Geometry, ray.Origin, ray.Direction);
  if (!boxRay.Clip(begin, end))
  {
    return result;
  }
  std::vector<double> lightCuts;
  std::vector<vtkMediumShadowEdges> edges;
  for (const vtkMediumScene::Light& light : this->Scene.Lights)
  {
    vtkMediumAppendLightCuts(light, ray.Origin, ray.Direction, lightCuts);
    vtkMediumAppendCutEdges(this->Scene, light, ray.Origin, ray.Direction, begin, end, lightCuts);
    edges.emplace_back(this->Content, this->Scene.Geometry, light, boxRay);
    edges.back().AppendBoxEdges(begin, end, lightCuts);
  }
  const Kinks kinks{ lightCuts, edges };
  for (const glm::dvec2& part :
    vtkMediumKeptParts(this->Scene.Cut, ray.Origin, ray.Direction, begin, end))
  {
    vtkMediumRayCells cells(
      this->Content, this->Content.GetNumberOfFields(), boxRay, part.x, part.y);
    while (cells.Next())
    {
      this->IntegrateCell(ray, cells, kinks, end - begin, result);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
void vtkMediumReferenceIntegrator::IntegrateCell(Ray& ray, const vtkMediumRayCells& cells,
  const Kinks& kinks, double wholeLength, Result& result) const
{
  std::vector<double> cuts{ cells.GetBegin(), cells.GetEnd() };
  for (double cut : kinks.OfLights)
  {
    if (cut > cells.GetBegin() && cut < cells.GetEnd())
    {
      cuts.push_back(cut);
    }
  }
  cells.AppendKinks(cuts);
  for (const vtkMediumShadowEdges& edge : kinks.OfShadows)
  {
    edge.AppendVoxelEdges(cells.GetBegin(), cells.GetEnd(), cuts);
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
  {
    const double length = cuts[i + 1] - cuts[i];
    if (!(length > 0))
    {
      continue;
    }
    const Piece piece{ ray, cells, cuts[i], result.OpticalDepth,
      ray.Tolerance * std::max(length / wholeLength, LeastShare) };
    result.Radiance += this->IntegratePiece(piece, 0, length, glm::dvec3(0), 0);
    result.OpticalDepth += this->Depth.EvaluateInCell(cells, cuts[i], 0, length);
  }
}

//------------------------------------------------------------------------------
// Positions are counted from the beginning of the piece, so that they stay exact however near they
// come to it. depth0 is the optical depth from there to u0.
glm::dvec3 vtkMediumReferenceIntegrator::IntegratePiece(
  const Piece& piece, double u0, double u1, const glm::dvec3& depth0, int level) const
{
  const glm::dvec3 toBegin = piece.DepthToBegin + depth0;
  // A channel that is deep in the dark is as steep as it may be; another one goes on.
  const glm::bvec3 seen = glm::lessThanEqual(toBegin, glm::dvec3(2 * DarkestDepth));
  if (!glm::any(seen))
  {
    return glm::dvec3(0);
  }
  const double middle = 0.5 * (u0 + u1);
  const glm::dvec3 within = this->Depth.EvaluateInCell(piece.Cells, piece.Begin, u0, u1);
  const auto bisect = [&]() {
    const glm::dvec3 half = this->Depth.EvaluateInCell(piece.Cells, piece.Begin, u0, middle);
    return this->IntegratePiece(piece, u0, middle, depth0, level + 1) +
      this->IntegratePiece(piece, middle, u1, depth0 + half, level + 1);
  };
  if (vtkMediumMagnitude(within * glm::dvec3(seen)) > SteepestDepth &&
    level < MaximumSteepBisections)
  {
    return bisect();
  }

  std::vector<LightRange>& lights = piece.Eye.Lights;
  lights.assign(this->Scene.Lights.size(), LightRange());
  const glm::dvec3 fourth = this->Sum<4>(piece, u0, u1);
  if (piece.Eye.Estimate)
  {
    return fourth;
  }
  const vtkMediumAgreement agreement{ piece.Tolerance,
    std::max(2 * this->Content.GetFacetError(), 1e-14) };
  const glm::dvec3 third = this->Sum<3>(piece, u0, u1);
  const bool steep = std::any_of(
    lights.begin(), lights.end(), [&seen](const LightRange& range) { return range.IsSteep(seen); });
  if (!steep && agreement.Holds(third, fourth, vtkMediumFirstLookStrictness))
  {
    return fourth;
  }
  const glm::dvec3 eighth = this->Sum<8>(piece, u0, u1);
  if (level >= MaximumBisections ||
    (!steep && agreement.Holds(this->Sum<6>(piece, u0, u1), eighth)))
  {
    return eighth;
  }
  return bisect();
}

//------------------------------------------------------------------------------
template <int N>
glm::dvec3 vtkMediumReferenceIntegrator::Sum(const Piece& piece, double u0, double u1) const
{
  return this->Scene.Geometry.Length *
    vtkMediumGaussLegendre<N>::Integrate(u0, u1, [&](double u) { return this->Source(piece, u); });
}

//------------------------------------------------------------------------------
// T (sigma_e + sum sigma_s p E exp(-tau)) at a position, per world unit.
glm::dvec3 vtkMediumReferenceIntegrator::Source(const Piece& piece, double u) const
{
  const double t = piece.Begin + u;
  const vtkMediumScene::Coefficients at = piece.Cells.Evaluate(t);
  glm::dvec3 source = at.Emission;
  if (vtkMediumMagnitude(at.Scattering) > 0)
  {
    const glm::dvec3 position = piece.Eye.Origin + t * piece.Eye.Direction;
    for (std::size_t k = 0; k < this->Scene.Lights.size(); ++k)
    {
      const vtkMediumIncidentLight incident =
        vtkMediumReferenceLight(this->Scene.Lights[k], position);
      if (incident.Irradiance == glm::dvec3(0))
      {
        continue;
      }
      const glm::dvec3 depth =
        this->Depth.Evaluate(position, -incident.Direction, 0, incident.Distance);
      piece.Eye.Lights[k].Add(depth);
      const double phase = vtkMediumReferencePhase(this->Content.GetMedium(), at.Anisotropy,
        -glm::dot(incident.Direction, piece.Eye.Direction));
      source += phase * at.Scattering * incident.Irradiance * glm::exp(-depth);
    }
  }
  const glm::dvec3 depth =
    piece.DepthToBegin + this->Depth.EvaluateInCell(piece.Cells, piece.Begin, 0, u);
  return glm::exp(-depth) * source;
}
