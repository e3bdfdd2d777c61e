// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Opaque geometry casts its shadow into the medium: against closed forms, by kind of light and integrator.
#include "QuadShadow.h"
#include "ReferenceScene.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;
using Mapper = vtkSingleScatteringVolumeMapper;

namespace
{
const glm::dvec3 Size(1, 0.8, 0.6);
constexpr double Step = 0.004;
constexpr int Edge = 16; // pixels

struct Lamp
{
  const char* Name;
  glm::dvec4 Place; ///< (position, 1), or (direction towards the light, 0)
  double ConeAngle; ///< of a spot light that points at Aim; 180: none
  glm::dvec3 Aim;
  Quad Blocker;
  double
    Texel; ///< of the light's view where it is widest over the box, world units times its pixels

  bool IsBeam() const { return this->Place.w == 0; }
  glm::dvec3 ToLight() const { return glm::normalize(glm::dvec3(this->Place)); }
  bool Reaches(const glm::dvec3& point) const
  {
    const glm::dvec3 place(this->Place);
    const double cosine =
      glm::dot(glm::normalize(this->Aim - place), glm::normalize(point - place));
    return this->ConeAngle >= 90 || cosine >= std::cos(this->ConeAngle * Pi / 180);
  }
};

// Outside of the box: above it, and beside it in a slant. Inside: between a lamp and one corner.
const Quad Above = { { -0.15, 0.55, -0.2 }, { 0.4, 0, 0.1 }, { 0, 0.1, 0.35 } };
const Quad Inside = { { 0.15, -0.15, -0.2 }, { 0, 0.35, 0.05 }, { 0.1, 0, 0.4 } };
const Lamp Lamps[] = {
  { "beam", { 0.3, 1, 0.2, 0 }, 180, {}, Above, 1.5 },
  { "beam, blocked inside", { 0.9, 0.4, 0.2, 0 }, 180, {}, Inside, 1.5 },
  { "lamp far off", { 300, 900, 100, 1 }, 180, {},
    { { -0.15, 0.55, -0.2 }, { 0.4, 0, 0.1 }, { 0, 0.1, 0.35 } }, 1.5 },
  { "lamp", { 0.2, 1.2, 0.1, 1 }, 180, {}, Above, 4 },
  { "lamp beside the box", { 0.1, 0.6, 0, 1 }, 180, {},
    { { -0.1, 0.45, -0.1 }, { 0.3, 0, 0.05 }, { 0, 0, 0.25 } }, 3 },
  { "lamp inside", { 0.05, 0.02, -0.03, 1 }, 180, {}, Inside, 2 },
  { "spot on all", { 0.2, 1.2, 0.1, 1 }, 50, { 0, 0, 0 }, Above, 4 },
  { "narrow spot", { 0.2, 1.2, 0.1, 1 }, 12, { 0, 0, 0 }, Above, 1 },
};

/// A box in the light of a lamp, with its blocker.
struct ShadowScene : Scene
{
  const Lamp& Source;
  Box Shape{ Size };
  double Sigma;

  explicit ShadowScene(const Lamp& lamp)
    : Scene(MakeBox(Size), Edge)
    , Source(lamp)
    , Sigma(lamp.IsBeam() ? 1.5 : 1e-6) // thin, so that light paths weaken nothing
  {
    this->Medium->SetExtinction(this->Sigma);
    this->Mapper->SetTransmittanceThreshold(0);
    this->Mapper->SetJitter(0);
    this->Mapper->OpaqueShadowsOn();
    this->SetSteps(Step, 0.1);
    this->Look({ 0.3, -0.25, -1 }, 4);
    this->Camera->SetViewAngle(18);
    lamp.Blocker.AddTo(this->Renderer);
    const glm::dvec3 place(lamp.Place);
    if (lamp.IsBeam())
    {
      this->AddBeam(-lamp.ToLight());
      return;
    }
    auto light = this->AddPointLight(place);
    light->SetFocalPoint(lamp.Aim.x, lamp.Aim.y, lamp.Aim.z);
    light->SetConeAngle(lamp.ConeAngle);
    light->SetExponent(0);
  }

  /// Radiance between a and b of a ray that enters the box at `first`, without the blocker.
  double Between(const Ray& ray, double first, double a, double b) const
  {
    if (this->Source.IsBeam())
    {
      return std::exp(-this->Sigma * (a - first)) *
        BoxRadiance(this->Shape, ray, this->Source.ToLight(), this->Sigma, a, b);
    }
    if (this->Source.ConeAngle < 45)
    {
      return this->BetweenInCone(ray, a, b);
    }
    const glm::dvec3 place(this->Source.Place);
    const double foot = glm::dot(place - ray.Origin, ray.Direction);
    const double distance = glm::length(ray.Origin + foot * ray.Direction - place);
    return this->Sigma / distance *
      (std::atan((b - foot) / distance) - std::atan((a - foot) / distance));
  }

  /// The same by its definition, in 4000 points: the cone cuts the ray.
  double BetweenInCone(const Ray& ray, double a, double b) const
  {
    const int points = 4000;
    double sum = 0;
    for (int i = 0; i < points; ++i)
    {
      const glm::dvec3 at = ray.Origin + (a + (b - a) * (i + 0.5) / points) * ray.Direction;
      const glm::dvec3 way = at - glm::dvec3(this->Source.Place);
      sum += this->Source.Reaches(at) ? 1 / glm::dot(way, way) : 0;
    }
    return this->Sigma * sum * (b - a) / points;
  }

  /// Radiance of a ray where the shadow's sides are moved outwards by `grown`.
  double Truth(const Ray& ray, double grown) const
  {
    std::array<double, 2> t = this->Shape.Intersect(ray);
    const Quad& quad = this->Source.Blocker;
    const Plane plane = { glm::cross(quad.U, quad.V),
      glm::dot(quad.Corner, glm::cross(quad.U, quad.V)) };
    const glm::dvec3 hit = ray.Origin + plane.Hit(ray) * ray.Direction - quad.Corner;
    const glm::dvec3 alongU = glm::cross(quad.V, plane.Normal),
                     alongV = glm::cross(plane.Normal, quad.U);
    const double u = glm::dot(hit, alongU) / glm::dot(quad.U, alongU);
    const double v = glm::dot(hit, alongV) / glm::dot(quad.V, alongV);
    if (u >= 0 && u <= 1 && v >= 0 && v <= 1)
    {
      t[1] = std::min(t[1], plane.Hit(ray));
    }
    return t[0] < t[1] ? Isotropic *
        QuadShadow(quad, this->Source.Place, grown)
          .Lit(ray, t[0], t[1], [&](double a, double b) { return this->Between(ray, t[0], a, b); })
                       : 0;
  }
};

/// Compares with the closed form, whose shadow may be off by a texel and a half; `tolerance` is of the peak.
void ExpectShadow(ShadowScene& scene, double tolerance)
{
  const double edge = 1.5 * scene.Source.Texel / scene.Mapper->GetOpaqueShadowResolution();
  const Picture picture = scene.Render();
  ASSERT_TRUE(picture.IsLight());
  double peak = 0, shaded = 0, meanError = 0;
  ForEachPixel(scene, [&](int, int, const Ray& ray) {
    const double open = scene.Truth(ray, -1e3); // no shadow is left
    peak = std::max(peak, open);
    shaded += open - scene.Truth(ray, 0);
  });
  ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
    const double found = picture.At(x, y);
    ASSERT_GE(found, scene.Truth(ray, edge) - tolerance * peak) << x << ", " << y;
    ASSERT_LE(found, scene.Truth(ray, -edge) + tolerance * peak) << x << ", " << y;
    meanError += std::abs(found - scene.Truth(ray, 0));
  });
  EXPECT_GT(shaded, 0.2 * peak) << "the shadow is seen";
  EXPECT_LT(meanError, tolerance * peak * Edge * Edge);
}
}

//------------------------------------------------------------------------------
// A step that a shadow begins in is off by half of its width at most.
TEST(OpaqueShadows, FixedStepHasTheClosedFormOfEveryLight)
{
  for (const Lamp& lamp : Lamps)
  {
    SCOPED_TRACE(lamp.Name);
    ShadowScene scene(lamp);
    ExpectShadow(scene, 0.006);
  }
}

//------------------------------------------------------------------------------
TEST(OpaqueShadows, ExactHasTheClosedFormOfEveryLight)
{
  for (const Lamp& lamp : Lamps)
  {
    SCOPED_TRACE(lamp.Name);
    ShadowScene scene(lamp);
    scene.Mapper->SetIntegratorToExact();
    ExpectShadow(scene, 1e-3);
  }
}

//------------------------------------------------------------------------------
// The largest error that is asked for, and as much again for probe pixels that missed a shadow's edge.
TEST(OpaqueShadows, ErrorControlledHasTheClosedFormOfEveryLight)
{
  for (const Lamp& lamp : Lamps)
  {
    SCOPED_TRACE(lamp.Name);
    ShadowScene scene(lamp);
    scene.Mapper->SetIntegratorToErrorControlled();
    scene.Mapper->SetMaximumError(0.003);
    ExpectShadow(scene, 0.006);
  }
}

//------------------------------------------------------------------------------
// Sums from the left are of first order in the step.
TEST(OpaqueShadows, PaperHasTheClosedFormOfEveryLight)
{
  for (const Lamp& lamp : Lamps)
  {
    SCOPED_TRACE(lamp.Name);
    ShadowScene scene(lamp);
    scene.Mapper->SetIntegratorToPaper();
    ExpectShadow(scene, 0.02);
  }
}
