// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A light's views hold all of the volume that it lights, and depths in them grow away from it.
#include "vtkMediumFixtures.h"
#include "vtkMediumShadowViews.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace vtkMediumFixtures;
using Light = vtkMediumScene::Light;
using Views = vtkMediumShadowViews;

namespace
{
constexpr int Pixels = 64;
constexpr double Inner = (Pixels - 2.0) / Pixels;

/// A slanted box whose longest diagonal is 1.
vtkMediumScene::Box MakeBox()
{
  vtkMediumScene::Box box;
  box.BoxToLocalAxes = glm::dmat3(0.5, 0.1, 0, 0.1, 0.4, 0, 0.05, 0, 0.3);
  const glm::dvec3 diagonal = box.BoxToLocalAxes * glm::dvec3(1);
  box.BoxToLocalAxes = box.BoxToLocalAxes / glm::length(diagonal);
  box.BoxToLocalOrigin = -0.5 * (box.BoxToLocalAxes * glm::dvec3(1));
  return box;
}

Light MakeLight(Light::Types type, const glm::dvec3& position, double coneAngle = 60)
{
  Light light;
  light.Type = type;
  light.Position = position;
  light.Direction = -glm::normalize(position);
  light.CosCone = std::cos(coneAngle * 3.14159265358979 / 180);
  return light;
}

int FaceOf(const glm::dvec3& way)
{
  const glm::dvec3 size = glm::abs(way);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return 2 * axis + (way[axis] > 0 ? 0 : 1);
}

/// Every point of the volume that the light reaches is in the view of its face; so many views there are.
void ExpectVolumeInViews(const Light& light, std::size_t views)
{
  const vtkMediumScene::Box box = MakeBox();
  const Views seen(light, box, Pixels);
  EXPECT_EQ(seen.Views.size(), views);
  const bool beam = light.Type == Light::Directional;
  for (std::uint32_t i = 0; i < 4000; ++i)
  {
    glm::dvec3 at(Random(3 * i, 5), Random(3 * i + 1, 5), Random(3 * i + 2, 5));
    at = i % 4 ? at : glm::round(at); // corners too
    const glm::dvec3 point = box.BoxToLocal(at);
    const glm::dvec3 way = beam ? light.Direction : point - light.Position;
    const bool reached =
      light.Type != Light::Spot || glm::dot(glm::normalize(way), light.Direction) >= light.CosCone;
    if (!reached || (!beam && glm::length(way) < 3 * Views::NearestDepth))
    {
      continue;
    }
    const int number = seen.OfFace[beam ? 0 : FaceOf(way)];
    ASSERT_GE(number, 0) << i;
    const glm::dmat4 matrix = seen.Views[number].LocalToClip();
    const glm::dvec4 clip = matrix * glm::dvec4(point, 1);
    ASSERT_GT(clip.w, 0);
    const glm::dvec3 seenAt = glm::dvec3(clip) / clip.w;
    ASSERT_LE(std::max(std::abs(seenAt.x), std::abs(seenAt.y)), Inner * (1 + 1e-9)) << i;
    ASSERT_LT(std::abs(seenAt.z), 1) << i;
    // The way of the light is one pixel, at growing depths.
    const glm::dvec4 farther = matrix * glm::dvec4(point + 1e-3 * glm::normalize(way), 1);
    ASSERT_NEAR(farther.x / farther.w, seenAt.x, 1e-9);
    ASSERT_NEAR(farther.y / farther.w, seenAt.y, 1e-9);
    ASSERT_GT(farther.z / farther.w, seenAt.z);
  }
}
}

//------------------------------------------------------------------------------
TEST(ShadowViews, BeamHasOneViewThatTheVolumeFills)
{
  for (std::uint32_t i = 0; i < 20; ++i)
  {
    Light light;
    light.Direction = i < 3 ? glm::dvec3(i == 0, i == 1, i == 2) : RandomDirection(i, 3);
    ExpectVolumeInViews(light, 1);
    const Views seen(light, MakeBox(), Pixels);
    glm::dvec2 lower(1), upper(-1);
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 at(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
      const glm::dvec4 clip = seen.Views[0].LocalToClip() * glm::dvec4(MakeBox().BoxToLocal(at), 1);
      lower = glm::min(lower, glm::dvec2(clip));
      upper = glm::max(upper, glm::dvec2(clip));
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      EXPECT_NEAR(lower[axis], -Inner, 1e-12);
      EXPECT_NEAR(upper[axis], Inner, 1e-12);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowViews, DistantLampHasOneView)
{
  for (std::uint32_t i = 0; i < 20; ++i)
  {
    for (double distance : { 0.8, 3.0, 1e4 })
    {
      ExpectVolumeInViews(MakeLight(Light::Point, distance * RandomDirection(i, 4)), 1);
      ExpectVolumeInViews(MakeLight(Light::Spot, distance * RandomDirection(i, 4)), 1);
      ExpectVolumeInViews(MakeLight(Light::Spot, distance * RandomDirection(i, 4), 5), 1);
    }
  }
}

//------------------------------------------------------------------------------
TEST(ShadowViews, LampInsideHasACubeOfThem)
{
  for (std::uint32_t i = 0; i < 20; ++i)
  {
    const glm::dvec3 position = 0.1 * RandomDirection(i, 7);
    ExpectVolumeInViews(MakeLight(Light::Point, position), 6);
    ExpectVolumeInViews(MakeLight(Light::Spot, position, 85), 6);
    ExpectVolumeInViews(MakeLight(Light::Spot, position, 30), 1);
  }
}

//------------------------------------------------------------------------------
TEST(ShadowViews, LampBesideTheVolumeHasViewsThroughTheFacesThatSeeIt)
{
  const glm::dvec3 beside = MakeBox().BoxToLocal({ 0.5, 0.5, 1.02 });
  const Views seen(MakeLight(Light::Point, beside), MakeBox(), Pixels);
  EXPECT_EQ(seen.OfFace[4], -1); // none of the volume is there
  ExpectVolumeInViews(MakeLight(Light::Point, beside), 5);
}

//------------------------------------------------------------------------------
TEST(ShadowViews, SpotThatLooksAwayHasNone)
{
  Light light = MakeLight(Light::Spot, { 0, 0, 2 }, 10);
  light.Direction = { 0, 0, 1 };
  const Views seen(light, MakeBox(), Pixels);
  EXPECT_TRUE(seen.Views.empty());
  for (int face : seen.OfFace)
  {
    EXPECT_EQ(face, -1);
  }
}
