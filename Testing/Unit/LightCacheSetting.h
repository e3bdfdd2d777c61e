// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LightCacheSetting_h
#define LightCacheSetting_h

#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumFixtures.h"
#include "vtkMediumHalf.h"
#include "vtkMediumLightCache.h"
#include "vtkMediumLightMarch.h"
#include "vtkMediumLightRays.h"
#include "vtkMediumLightStencil.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using Light = vtkMediumScene::Light;
using namespace vtkMediumFixtures;

constexpr double Sigma = 12; // per world unit: optical depths of several across the unit box

// Sums of up to 300 floats of one sign, whose rounding adds up to a few 1e-6 at worst.
constexpr double RelativeTolerance = 1e-5;

const glm::ivec3 Points(32, 27, 21);
const glm::dvec3 Size(1, 0.7, 0.4);

Light MakeDirectional(const glm::dvec3& direction)
{
  Light light;
  light.Direction = glm::normalize(direction);
  return light;
}

Light MakePoint(const glm::dvec3& position)
{
  Light light;
  light.Type = Light::Point;
  light.Position = position;
  return light;
}

std::vector<glm::dvec3> Directions()
{
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < 27; ++i)
  {
    if (i != 13)
    {
      directions.emplace_back(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    }
  }
  for (std::uint32_t i = 0; i < 6; ++i)
  {
    directions.push_back(RandomDirection(i, 11));
  }
  directions.emplace_back(1, 1e-3, -1e-5);   // nearly along an axis
  directions.emplace_back(6e-17, -1, 2e-17); // as along an axis as a cosine in double gets
  return directions;
}

// Lattice points all over, every fourth one on a face.
glm::ivec3 RandomLatticePoint(const glm::ivec3& n, std::uint32_t index)
{
  glm::ivec3 at;
  for (int axis = 0; axis < 3; ++axis)
  {
    at[axis] = static_cast<int>(Random(3 * index + axis, 23) * n[axis]);
  }
  if (index % 4 == 0)
  {
    const int axis = index / 4 % 3;
    at[axis] = index / 12 % 2 ? 0 : n[axis] - 1;
  }
  return at;
}

void ExpectStencilEqualsMarch(const vtkMediumExtinctionGrid& grid, const glm::dvec3& direction)
{
  const Light light = MakeDirectional(direction);
  vtkMediumLightStencil stencil;
  stencil.Build(grid, light.Direction);
  std::vector<float> tau;
  stencil.Apply(grid, -1, tau);
  // The stencil takes a drift of 1e-16 for none; so must the march, at points on the faces.
  Light snapped = light;
  for (int axis = 0; axis < 3; ++axis)
  {
    snapped.Direction[axis] = std::abs(light.Direction[axis]) < 1e-12 ? 0 : light.Direction[axis];
  }
  for (std::uint32_t i = 0; i < 300; ++i)
  {
    const glm::ivec3 at = RandomLatticePoint(grid.GetDimensions(), i);
    const double exact = vtkMediumLightOpticalDepth(grid, snapped, glm::dvec3(at));
    ASSERT_NEAR(tau[grid.GetIndex(at.x, at.y, at.z)], exact, RelativeTolerance * exact + 1e-6)
      << "at " << at.x << " " << at.y << " " << at.z << ", light along " << direction.x << " "
      << direction.y << " " << direction.z;
  }
}

// Errors of exp(-tau) at lattice points that the cache promises, in 1/255.
struct Errors
{
  double Largest = 0;
  double RootMeanSquare = 0;
};

Errors CompareWithMarch(
  const vtkMediumExtinctionGrid& grid, const Light& light, const std::vector<float>& tau)
{
  Errors errors;
  double sum = 0;
  int count = 0;
  for (std::uint32_t i = 0; i < 3000; ++i)
  {
    const glm::ivec3 at = RandomLatticePoint(grid.GetDimensions(), i);
    const std::size_t index = grid.GetIndex(at.x, at.y, at.z);
    if (!(grid.GetValues()[index] > 0))
    {
      continue;
    }
    const double exact = vtkMediumLightOpticalDepth(grid, light, glm::dvec3(at));
    const double error = 255 * std::abs(std::exp(-exact) - std::exp(-double(tau[index])));
    errors.Largest = std::max(errors.Largest, error);
    sum += error * error;
    ++count;
  }
  errors.RootMeanSquare = std::sqrt(sum / std::max(count, 1));
  return errors;
}

vtkMediumExtinctionGrid MakeGrid(Fields field, bool onCells = false)
{
  vtkMediumExtinctionGrid grid;
  grid.Build(MakeScene(MakeImage(field, Points, Size, onCells), Sigma, onCells));
  return grid;
}
}

#endif
