// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What the processor builds before a frame can skip work, timed by Google Benchmark without OpenGL:
// the extinction grid, bricks, their tiles, light caches of each kind, and their packing.
//
// usage: ParticipatingMediaBuildBenchmark [--benchmark_... OPTION]
#include "vtkMediumBricks.h"
#include "vtkMediumEmptyBricks.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFixtures.h"
#include "vtkMediumLightCache.h"

#include <benchmark/benchmark.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Light = vtkMediumScene::Light;
using namespace vtkMediumFixtures;

/// A field's scene and what is built for it, made once for each size.
struct Setting
{
  vtkSmartPointer<vtkImageData> Image;
  vtkMediumScene Scene;
  vtkMediumExtinctionGrid Grid, Coarser;
};

//------------------------------------------------------------------------------
// As Testing/Benchmark/points.py has it.
double ExtinctionOf(Fields field)
{
  return field == Cloud || field == FadedCloud ? 20 : 8;
}

//------------------------------------------------------------------------------
const Setting& SettingOf(Fields field, int points)
{
  static std::map<std::pair<Fields, int>, Setting> settings;
  Setting& setting = settings[{ field, points }];
  if (!setting.Image)
  {
    setting.Image = MakeImage(field, glm::ivec3(points));
    setting.Scene = MakeScene(setting.Image, ExtinctionOf(field));
    setting.Grid.Build(setting.Scene);
    setting.Coarser.BuildCoarser(setting.Grid);
  }
  return setting;
}

//------------------------------------------------------------------------------
// A box of unit edges in local units has edges of 1 / sqrt(3).
glm::dvec3 ToLocal(const glm::dvec3& world)
{
  return world / std::sqrt(3.0);
}

//------------------------------------------------------------------------------
Light DirectionalLight()
{
  Light light;
  light.Direction = -glm::normalize(glm::dvec3(0.6, 1, 0.8));
  return light;
}

//------------------------------------------------------------------------------
Light PointLight(const glm::dvec3& at)
{
  Light light;
  light.Type = Light::Point;
  light.Position = ToLocal(at);
  return light;
}

//------------------------------------------------------------------------------
vtkMediumScene::View View()
{
  const glm::dvec3 eye = ToLocal({ 1.1, 0.8, 1.9 });
  const glm::dvec3 forward = -glm::normalize(eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  const double angle = glm::radians(35.0), half = std::tan(0.5 * angle);
  vtkMediumScene::View view;
  view.Origin = eye;
  view.Direction = forward;
  view.DirectionX = half * right;
  view.DirectionY = half * glm::cross(right, forward);
  view.LocalToClip = glm::perspective(angle, 1.0, 0.01, 100.0) *
    glm::lookAt(eye, glm::dvec3(0), glm::dvec3(0, 1, 0));
  view.ClipZ = glm::row(view.LocalToClip, 2);
  view.ClipW = glm::row(view.LocalToClip, 3);
  return view;
}

//------------------------------------------------------------------------------
void BuildGrid(benchmark::State& state, Fields field)
{
  const Setting& setting = SettingOf(field, static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    vtkMediumExtinctionGrid grid;
    grid.Build(setting.Scene);
    benchmark::DoNotOptimize(grid.GetValues().data());
  }
}

//------------------------------------------------------------------------------
void BuildBricks(benchmark::State& state, Fields field)
{
  const Setting& setting = SettingOf(field, static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    vtkMediumBricks bricks;
    bricks.Build(setting.Scene, setting.Grid);
    vtkMediumEmptyBricks empty;
    empty.Build(bricks);
    benchmark::DoNotOptimize(empty.GetReaches().data());
  }
}

//------------------------------------------------------------------------------
void ProjectTiles(benchmark::State& state, Fields field)
{
  const int pixels = 512;
  const Setting& setting = SettingOf(field, static_cast<int>(state.range(0)));
  vtkMediumScene scene = setting.Scene;
  scene.Eye = View();
  vtkMediumBricks bricks;
  bricks.Build(scene, setting.Grid);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(bricks.ProjectToTiles(scene, pixels, pixels).Ranges.data());
  }
}

//------------------------------------------------------------------------------
void BuildCoarserGrid(benchmark::State& state, Fields field)
{
  const Setting& setting = SettingOf(field, static_cast<int>(state.range(0)));
  for (auto _ : state)
  {
    vtkMediumExtinctionGrid grid;
    grid.BuildCoarser(setting.Grid);
    benchmark::DoNotOptimize(grid.GetValues().data());
  }
}

//------------------------------------------------------------------------------
// While a light is dragged its cache has half the points along each axis.
void BuildLightCache(benchmark::State& state, Fields field, const Light& light, bool dragged)
{
  const Setting& setting = SettingOf(field, static_cast<int>(state.range(0)));
  vtkMediumLightCache cache;
  for (auto _ : state)
  {
    cache.Build(dragged ? setting.Coarser : setting.Grid, light);
    benchmark::DoNotOptimize(cache.GetOpticalDepths().data());
  }
}

//------------------------------------------------------------------------------
void PackLightCache(benchmark::State& state, Fields field)
{
  const Setting& setting = SettingOf(field, static_cast<int>(state.range(0)));
  vtkMediumLightCache cache;
  cache.Build(setting.Grid, DirectionalLight());
  const vtkMediumLatticePart part =
    setting.Grid.GetOccupiedPart().Grow(1, setting.Grid.GetDimensions());
  std::vector<std::uint16_t> texels(2 * part.GetNumberOfPoints());
  for (auto _ : state)
  {
    cache.Pack(1, part, true, texels.data(), 2);
    benchmark::DoNotOptimize(texels.data());
  }
}

//------------------------------------------------------------------------------
// Wall-clock time, since VTK's threads share the work.
template <typename Function, typename... Arguments>
void Register(const std::string& what, Fields field, Function function, Arguments... arguments)
{
  benchmark::RegisterBenchmark((what + '/' + Name(field)).c_str(), function, field, arguments...)
    ->Arg(64)
    ->Arg(128)
    ->Arg(256)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
}
}

int main(int argc, char* argv[])
{
  for (Fields field : { Smooth, FadedCloud, Cloud, Binary })
  {
    Register("extinction grid", field, BuildGrid);
    Register("bricks", field, BuildBricks);
    Register("tiles of 512 x 512 pixels", field, ProjectTiles);
    Register("coarser grid", field, BuildCoarserGrid);
    const Light beam = DirectionalLight();
    Register("light cache, directional, final", field, BuildLightCache, beam, false);
    Register("light cache, directional, dragged", field, BuildLightCache, beam, true);
    const Light beside = PointLight({ 0.6, 1, 0.8 }), inside = PointLight({ 0.1, 0.2, 0.1 });
    Register("light cache, point beside", field, BuildLightCache, beside, false);
    Register("light cache, point inside", field, BuildLightCache, inside, false);
    Register("packing a light cache", field, PackLightCache);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
  {
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
