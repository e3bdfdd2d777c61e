// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumFixtures.h
 * @brief Procedural volumes for tests and benchmarks: the same values on every machine, no files.
 *
 * Each field is a density in [0, 1] over the unit box, given as a formula, so that it can be sampled
 * on any lattice and known between lattice points:
 * - Smooth: five Gaussian blobs; nothing is empty, every derivative is bounded;
 * - Cloud: fractal noise above a threshold inside a ball that cuts it off: a jump at the ball, finite slopes
 *   elsewhere; about half of the ball is empty;
 * - FadedCloud: the same, but it fades to 0 towards the ball: all slopes are finite;
 * - Binary: 1 inside a torus, a ball and a thin rod, 0 elsewhere; every border is a jump.
 *
 * The seed shifts the noise and the blobs; equal seeds give equal fields.
 */
#ifndef vtkMediumFixtures_h
#define vtkMediumFixtures_h

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMediumScene.h"
#include "vtkNew.h"
#include "vtkPerlinNoise.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vtkMediumFixtures
{
enum Fields
{
  Smooth,
  Cloud,
  Binary,
  FadedCloud,
};

inline const char* Name(Fields field)
{
  constexpr const char* names[] = { "smooth", "cloud", "binary", "faded-cloud" };
  return names[field];
}

/// A number in [0, 1) from an index and a seed (the finaliser of MurmurHash3), for tests too.
inline double Random(std::uint32_t index, std::uint32_t seed)
{
  std::uint32_t h = index * 0x9e3779b9u + seed * 0x85ebca6bu + 0x165667b1u;
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return (h ^ (h >> 16)) / 4294967296.0;
}

/// A unit vector, uniform over the sphere.
inline glm::dvec3 RandomDirection(std::uint32_t index, std::uint32_t seed)
{
  const double z = 2 * Random(2 * index, seed) - 1;
  const double angle = 6.283185307179586 * Random(2 * index + 1, seed);
  const double radius = std::sqrt(1 - z * z);
  return { radius * std::cos(angle), radius * std::sin(angle), z };
}

/// Fractal noise in about [-1, 1]: octaves of VTK's Perlin noise from 3 periods a box on.
inline double FractalNoise(const glm::dvec3& box, int octaves, std::uint32_t seed)
{
  vtkNew<vtkPerlinNoise> noise;
  const double shift = 31 * Random(0, seed);
  double sum = 0, amplitude = 0.5, frequency = 3;
  for (int octave = 0; octave < octaves; ++octave)
  {
    glm::dvec3 x = box * frequency + shift + 7.3 * octave;
    sum += amplitude * noise->EvaluateFunction(&x[0]);
    amplitude *= 0.5;
    frequency *= 2;
  }
  return 2 * sum;
}

inline double SmoothDensity(const glm::dvec3& box, std::uint32_t seed)
{
  double sum = 0.01;
  for (std::uint32_t blob = 0; blob < 5; ++blob)
  {
    glm::dvec3 center;
    for (int axis = 0; axis < 3; ++axis)
    {
      center[axis] = 0.25 + 0.5 * Random(3 * blob + axis, seed);
    }
    const double width = 0.08 + 0.1 * Random(100 + blob, seed);
    const glm::dvec3 offset = (box - center) / width;
    sum += 0.6 * std::exp(-0.5 * glm::dot(offset, offset));
  }
  return std::min(sum, 1.0);
}

inline double CloudDensity(const glm::dvec3& box, std::uint32_t seed)
{
  const double falloff = 1 - 4 * glm::dot(box - 0.5, box - 0.5); // 0 at radius 1/2
  if (falloff <= 0)
  {
    return 0;
  }
  const double value = 0.35 * falloff + FractalNoise(box, 5, seed) * 0.9 - 0.05;
  return std::min(std::max(1.6 * value, 0.0), 1.0);
}

inline double FadedCloudDensity(const glm::dvec3& box, std::uint32_t seed)
{
  const double falloff = std::max(1 - 4 * glm::dot(box - 0.5, box - 0.5), 0.0);
  const double fade = std::min(4 * falloff, 1.0); // over an eighth of the radius
  return fade * CloudDensity(box, seed);
}

inline double BinaryDensity(const glm::dvec3& box, std::uint32_t seed)
{
  const glm::dvec3 p = box - 0.5;
  const double ring = std::hypot(std::hypot(p.x, p.y) - 0.3, p.z);
  const glm::dvec3 ball =
    p - 0.1 * glm::dvec3(Random(1, seed) - 0.5, Random(2, seed) - 0.5, Random(3, seed) - 0.5);
  const bool rod = std::hypot(p.x - 0.12, p.z + 0.08) < 0.035 && std::abs(p.y) < 0.42;
  return ring < 0.11 || glm::length(ball) < 0.13 || rod ? 1 : 0;
}

inline double Density(Fields field, const glm::dvec3& box, std::uint32_t seed = 1)
{
  return field == Smooth  ? SmoothDensity(box, seed)
    : field == Cloud      ? CloudDensity(box, seed)
    : field == FadedCloud ? FadedCloudDensity(box, seed)
                          : BinaryDensity(box, seed);
}

/// An image whose active scalars "density" are the field on `points` points, or on the cells between
/// them. `size` are the lengths of its edges in world units; its centre is the world's origin.
inline vtkSmartPointer<vtkImageData> MakeImage(Fields field, const glm::ivec3& points,
  const glm::dvec3& size = glm::dvec3(1), bool onCells = false, std::uint32_t seed = 1)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(points.x, points.y, points.z);
  const glm::dvec3 spacing = size / glm::dvec3(points - 1);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  image->SetOrigin(-0.5 * size.x, -0.5 * size.y, -0.5 * size.z);
  const glm::ivec3 n = onCells ? points - 1 : points;
  vtkNew<vtkFloatArray> density;
  density->SetName("density");
  density->SetNumberOfTuples(static_cast<vtkIdType>(n.x) * n.y * n.z);
  float* values = density->GetPointer(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(n.y) * n.z, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType row = begin; row < end; ++row)
    {
      for (int i = 0; i < n.x; ++i)
      {
        const glm::dvec3 at(i, static_cast<int>(row % n.y), static_cast<int>(row / n.y));
        const glm::dvec3 box = onCells ? (at + 0.5) / glm::dvec3(n) : at / glm::dvec3(n - 1);
        values[row * n.x + i] = static_cast<float>(Density(field, box, seed));
      }
    }
  });
  if (onCells)
  {
    image->GetCellData()->SetScalars(density);
  }
  else
  {
    image->GetPointData()->SetScalars(density);
  }
  return vtkSmartPointer<vtkImageData>(image);
}

/// A scene whose extinction is `sigma` x density per world unit, with albedo 1, without lights and
/// without a view, for code that needs no renderer. `axes` has the edges of a voxel, world units, as
/// columns and may shear; it replaces the image's spacing.
inline vtkMediumScene MakeScene(vtkImageData* image, double sigma, bool onCells, glm::dmat3 axes)
{
  vtkMediumScene scene;
  vtkMediumField field;
  field.Array = onCells ? image->GetCellData()->GetScalars() : image->GetPointData()->GetScalars();
  field.OnCells = onCells;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int points = image->GetDimensions()[axis];
    field.Dimensions[axis] = onCells ? points - 1 : points;
    axes[axis] *= points - 1;
  }
  field.FindRange();
  scene.Content.Fields.push_back(field);
  using Coefficient = vtkMediumScene::Coefficient;
  scene.Content.Extinction = Coefficient{ Coefficient::Field, 0, -1, 0, glm::dvec3(sigma) };
  scene.Content.Scattering.Scale = glm::dvec3(1);
  vtkMediumScene::Box& box = scene.Geometry;
  box.Length = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    box.Length = std::max(
      box.Length, glm::length(axes * glm::dvec3(1, corner & 1 ? -1 : 1, corner & 2 ? -1 : 1)));
  }
  box.BoxToLocalAxes = axes / box.Length;
  box.BoxToLocalOrigin = -(box.BoxToLocalAxes * glm::dvec3(0.5));
  box.LocalToBoxAxes = glm::inverse(box.BoxToLocalAxes);
  box.LocalToBoxOrigin = glm::dvec3(0.5);
  const double* spacing = image->GetSpacing();
  box.VoxelLength = std::min({ spacing[0], spacing[1], spacing[2] });
  return scene;
}

inline vtkMediumScene MakeScene(vtkImageData* image, double sigma, bool onCells = false)
{
  const double* spacing = image->GetSpacing();
  glm::dmat3 axes(1);
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[axis] *= spacing[axis];
  }
  return MakeScene(image, sigma, onCells, axes);
}
}

#endif
