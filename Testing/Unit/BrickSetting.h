// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef BrickSetting_h
#define BrickSetting_h

#include "vtkMediumBricks.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
using Coefficient = vtkMediumScene::Coefficient;
using namespace vtkMediumFixtures;

// Everything about one scene.
struct Setting
{
  vtkMediumScene Scene;
  vtkMediumExtinctionGrid Grid;
  vtkMediumBricks Bricks;

  void Build()
  {
    this->Grid.Build(this->Scene);
    this->Bricks.Build(this->Scene, this->Grid);
  }
};

vtkSmartPointer<vtkImageData> MakeFilled(
  const glm::ivec3& points, const std::function<float(const glm::ivec3&)>& value)
{
  auto image = MakeImage(Smooth, points);
  vtkDataArray* density = image->GetPointData()->GetScalars();
  vtkIdType tuple = 0;
  for (int k = 0; k < points.z; ++k)
  {
    for (int j = 0; j < points.y; ++j)
    {
      for (int i = 0; i < points.x; ++i)
      {
        density->SetComponent(tuple++, 0, value({ i, j, k }));
      }
    }
  }
  return image;
}

Setting MakeSetting(vtkImageData* image, bool onCells = false)
{
  Setting setting;
  setting.Scene = MakeScene(image, 10, onCells);
  setting.Build();
  return setting;
}

void UseFunction(vtkMediumScene& scene, const std::function<double(double)>& extinction)
{
  vtkMediumFunction function;
  function.Sample(0, 1, {}, [&](double s) { return glm::dvec4(0, 0, 0, extinction(s)); });
  scene.Content.Functions.assign(1, function);
  scene.Content.Extinction = Coefficient{ Coefficient::FunctionAlpha, 0, 0, -1, glm::dvec3(10) };
}

double Wavy(double s)
{
  return std::max(std::sin(23 * s) * s, 0.0);
}

glm::dvec3 RandomBox(std::uint32_t index, std::uint32_t seed)
{
  return { Random(3 * index, seed), Random(3 * index + 1, seed), Random(3 * index + 2, seed) };
}

std::size_t Occupied(const vtkMediumBricks& bricks)
{
  return bricks.GetNumberOf(vtkMediumBricks::Uniform) + bricks.GetNumberOf(vtkMediumBricks::Mixed);
}

// A camera as vtkMediumScene::View describes it: rays through x right + y up + forward.
vtkMediumScene::View MakeView(
  const glm::dvec3& eye, const glm::dvec3& target, double halfWidth, bool parallel)
{
  const glm::dvec3 forward = glm::normalize(target - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.1, 1, 0.2)));
  const glm::dvec3 up = glm::cross(right, forward);
  vtkMediumScene::View view;
  view.Parallel = parallel;
  view.Direction = forward;
  const glm::dvec4 alongRight(right, -glm::dot(right, eye)), alongUp(up, -glm::dot(up, eye));
  const glm::dvec4 alongForward(forward, -glm::dot(forward, eye));
  const glm::dvec4 rowX = alongRight / halfWidth, rowY = alongUp / halfWidth;
  const glm::dvec4 rowZ = alongForward, rowW = parallel ? glm::dvec4(0, 0, 0, 1) : alongForward;
  view.LocalToClip = glm::transpose(glm::dmat4(rowX, rowY, rowZ, rowW));
  view.ClipZ = rowZ;
  view.ClipW = rowW;
  if (parallel)
  {
    view.Origin = eye - forward * glm::dot(eye, forward);
    view.OriginX = right * halfWidth;
    view.OriginY = up * halfWidth;
  }
  else
  {
    view.Origin = eye;
    view.DirectionX = right * halfWidth;
    view.DirectionY = up * halfWidth;
  }
  return view;
}

// Samples random eye rays; whatever has extinction must be inside its tile's range and the scissor.
// Returns how many samples had any.
int ExpectTilesCoverTheMedium(const Setting& setting, int width, int height)
{
  const vtkMediumScene::View& view = setting.Scene.Eye;
  const vtkMediumBricks::Tiles tiles = setting.Bricks.ProjectToTiles(setting.Scene, width, height);
  int hits = 0;
  for (std::uint32_t i = 0; i < 40000; ++i)
  {
    const glm::dvec2 pixel(Random(3 * i, 41) * width, Random(3 * i + 1, 41) * height);
    const glm::dvec2 at = 2.0 * pixel / glm::dvec2(width, height) - 1.0;
    const glm::dvec3 origin = view.Origin + at.x * view.OriginX + at.y * view.OriginY;
    const glm::dvec3 direction =
      glm::normalize(view.Direction + at.x * view.DirectionX + at.y * view.DirectionY);
    const double t = view.Parallel ? 1.2 * Random(3 * i + 2, 41) - 0.6 : 3 * Random(3 * i + 2, 41);
    const glm::dvec3 box = setting.Scene.Geometry.LocalToBox(origin + t * direction);
    if (glm::clamp(box, 0.0, 1.0) != box || !(setting.Scene.Evaluate(box).Extinction.x > 0))
    {
      continue;
    }
    ++hits;
    const glm::ivec2 tile(pixel / double(tiles.Edge));
    const glm::vec2 range = tiles.Ranges[tile.x + tiles.Count.x * tile.y];
    EXPECT_LE(range.x, t) << "pixel " << pixel.x << " " << pixel.y;
    EXPECT_GE(range.y, t) << "pixel " << pixel.x << " " << pixel.y;
    EXPECT_GE(pixel.x, tiles.Scissor.x);
    EXPECT_GE(pixel.y, tiles.Scissor.y);
    EXPECT_LE(pixel.x, tiles.Scissor.x + tiles.Scissor.z);
    EXPECT_LE(pixel.y, tiles.Scissor.y + tiles.Scissor.w);
    if (testing::Test::HasFailure())
    {
      break;
    }
  }
  return hits;
}
}

#endif
