// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions and the tables made of them: a table stays within its samples, its bounds hold
// them, and a volume property is refused in words or sound.
#include "FuzzedInput.h"

#include "vtkMediumBricks.h"
#include "vtkMediumCoefficientBounds.h"
#include "vtkMediumExtinctionGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using vtkMediumFuzz::Bytes;
using vtkMediumFuzz::Demand;

/// A table on its own, over any range of a finite width.
void CheckTable(Bytes& bytes)
{
  const auto finite = [&bytes]() {
    const double value = bytes.Number(-1, 1);
    return std::isfinite(value) ? value : 0;
  };
  const double a = finite(), b = finite();
  if (!std::isfinite(b - a))
  {
    return;
  }
  std::vector<double> knots(bytes.Whole(6));
  std::generate(knots.begin(), knots.end(), [&]() { return bytes.Number(-1, 1); });
  // Of NaN std::sort asks what it is not given; a function's nodes come without.
  knots.erase(
    std::remove_if(knots.begin(), knots.end(), [](double knot) { return std::isnan(knot); }),
    knots.end());
  double least = std::numeric_limits<double>::max(), most = -least;
  vtkMediumFunction function;
  function.Sample(
    std::min(a, b), std::max(a, b), knots,
    [&](double at) {
      Demand(at >= std::min(a, b) && at <= std::max(a, b), "a table is sampled in its range");
      const double value = bytes.Unit();
      least = std::min(least, value);
      most = std::max(most, value);
      return glm::dvec4(value);
    },
    1 + bytes.Whole(16));
  for (int i = 0; i < 16; ++i)
  {
    const double value = function.Evaluate(bytes.Number(a, b)).x;
    Demand(value >= least - 1e-12 && value <= most + 1e-12, "a table stays within its samples");
  }
  for (double knot : function.GetKnots())
  {
    Demand(knot > std::min(a, b) && knot < std::max(a, b), "knots lie inside of the range");
  }
}

/// What bricks say of a scene holds where it is looked up.
void CheckBricks(const vtkMediumScene& scene)
{
  vtkMediumExtinctionGrid grid;
  grid.Build(scene);
  vtkMediumBricks bricks;
  bricks.Build(scene, grid);
  const vtkMediumBricks::Classes first = bricks.GetClass(glm::ivec3(0));
  const glm::vec2 range = bricks.GetRange(glm::ivec3(0)); // at most 5 points: one brick
  Demand(range.x <= range.y, "a brick's range is one");
  for (int i = 0; i < 125; ++i)
  {
    const glm::dvec3 box = glm::dvec3(i % 5, i / 5 % 5, i / 25) / 4.0;
    const vtkMediumScene::Coefficients at = scene.Evaluate(box);
    const double extinction = at.Extinction.x * scene.Geometry.Length;
    Demand(first != vtkMediumBricks::Empty || !(extinction > 0), "an empty brick is empty");
    if (scene.Content.DensityScale == 1 && extinction < 1e30)
    {
      Demand(
        extinction <= range.y * (1 + 1e-5) + 1e-30, "a brick's largest extinction is the largest");
    }
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  vtkMediumFuzz::Silence();
  if (bytes.Bit())
  {
    CheckTable(bytes);
    return 0;
  }
  vtkMediumFuzz::Input input(bytes);
  vtkMediumScene scene;
  for (int time = 0; time < 2; ++time)
  {
    if (scene
          .GatherVolume(
            input.Image, input.Scalars, input.OnCells, input.Volume, nullptr, bytes.Unit())
          .empty())
    {
      vtkMediumFuzz::DemandSoundScene(scene);
      CheckBricks(scene);
    }
    FillProperty(bytes, input.Property);
  }
  return 0;
}
