// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumImages.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkImageData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
//------------------------------------------------------------------------------
bool IsHit(float first)
{
  return first > vtkMediumFrame::NoHit;
}

//------------------------------------------------------------------------------
// The t of the nearest and of the farthest corner. Along parallel rays t counts from the plane through
// the local origin.
glm::dvec2 FindRange(const vtkMediumScene& scene)
{
  glm::dvec2 range(std::numeric_limits<double>::infinity(), 0);
  range[1] = -range[0];
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 at =
      scene.Geometry.BoxToLocal(glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1));
    const double distance =
      scene.Eye.Parallel ? glm::dot(at, scene.Eye.Direction) : glm::distance(at, scene.Eye.Origin);
    range[0] = std::min(range[0], distance);
    range[1] = std::max(range[1], distance);
  }
  return range;
}
}

//------------------------------------------------------------------------------
vtkMediumFrame::Shown vtkMediumImages::FindShown(const vtkMediumScene& scene, int output)
{
  using Shown = vtkMediumFrame::Shown;
  Shown shown;
  switch (output)
  {
    case vtkSingleScatteringVolumeMapper::Transmittance:
      shown.Content = Shown::Transmittance;
      break;
    case vtkSingleScatteringVolumeMapper::OpticalDepth:
      shown.Content = Shown::OpticalDepth;
      break;
    case vtkSingleScatteringVolumeMapper::Distance:
      shown.Content = Shown::Distance; // the volume's diagonal is one local unit
      break;
    case vtkSingleScatteringVolumeMapper::SampleCount:
      shown.Content = Shown::Count;
      shown.Scale = 1.0 / 1000;
      break;
    case vtkSingleScatteringVolumeMapper::FirstHit:
    case vtkSingleScatteringVolumeMapper::Depth:
    {
      shown.Content = Shown::FirstHit;
      const glm::dvec2 range = FindRange(scene);
      shown.Nearest = range[0];
      shown.Scale = 1 / (range[1] - range[0]);
      break;
    }
    case vtkSingleScatteringVolumeMapper::ErrorEstimate:
      shown.Content = Shown::Error;
      shown.Scale = 64;
      break;
    default:
      break;
  }
  return shown;
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumImages::Values(const std::vector<float>& radiance,
  const std::vector<float>& hits, const vtkMediumScene& scene, int output)
{
  using Mapper = vtkSingleScatteringVolumeMapper;
  if (output == Mapper::Radiance)
  {
    return radiance;
  }
  std::vector<float> pixels(hits.size(), 0.0f);
  for (std::size_t i = 0; i < hits.size(); i += 4)
  {
    const bool met = hits[i + 3] > 0;
    const float* source = nullptr;
    float value = output == Mapper::Transmittance ? 1.0f : 0.0f;
    bool has = output == Mapper::Transmittance || output == Mapper::OpticalDepth;
    if (has && met)
    {
      source = &radiance[i];
    }
    else if (output == Mapper::SampleCount)
    {
      has = met;
      value = hits[i + 2];
    }
    else if (!has && IsHit(hits[i]))
    {
      const bool first = output != Mapper::Distance;
      const double local =
        first ? hits[i] - scene.Eye.Start : static_cast<double>(hits[i + 1]) - hits[i];
      has = true;
      // Seen from within the medium, a float's rounding may put the first hit before the near plane.
      value = static_cast<float>(std::max(local, 0.0) * scene.Geometry.Length);
    }
    for (int c = 0; c < 3; ++c)
    {
      pixels[i + c] = source ? source[c] : value;
    }
    pixels[i + 3] = has ? 1.0f : 0.0f;
  }
  return pixels;
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumImages::Errors(const std::vector<float>& radiance,
  const std::vector<float>& coarser, const std::vector<float>& hits)
{
  std::vector<float> pixels(radiance.size(), 0.0f);
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    const bool alpha = i % 4 == 3;
    pixels[i] = alpha ? (hits[i] > 0 ? 1.0f : 0.0f) : std::abs(radiance[i] - coarser[i]) / 3;
  }
  return pixels;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumImages::FindPoint(
  const vtkMediumScene::View& eye, const glm::ivec2& size, const glm::ivec2& pixel, double t)
{
  const glm::dvec2 at = (glm::dvec2(pixel) + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
  const glm::dvec3 direction =
    glm::normalize(eye.Direction + at.x * eye.DirectionX + at.y * eye.DirectionY);
  return eye.Origin + at.x * eye.OriginX + at.y * eye.OriginY + t * direction;
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumImages::WindowDepths(
  const std::vector<float>& hits, const vtkMediumScene::View& eye, const glm::ivec2& size)
{
  std::vector<float> depths;
  for (int y = 0; y < size.y; ++y)
  {
    for (int x = 0; x < size.x; ++x)
    {
      const double t = hits[4 * depths.size()];
      const glm::dvec4 point(FindPoint(eye, size, { x, y }, t), 1);
      const double depth = 0.5 + 0.5 * glm::dot(eye.ClipZ, point) / glm::dot(eye.ClipW, point);
      depths.push_back(
        !IsHit(hits[4 * depths.size()]) ? 1.0f : static_cast<float>(glm::clamp(depth, 0.0, 1.0)));
    }
  }
  return depths;
}

//------------------------------------------------------------------------------
vtkMediumImages::Counts vtkMediumImages::Count(const std::vector<float>& hits)
{
  Counts counts;
  for (std::size_t i = 0; i < hits.size(); i += 4)
  {
    counts.Taps += static_cast<vtkTypeInt64>(hits[i + 2]);
    counts.Rays += hits[i + 3] >= 1 ? 1 : 0;
    counts.Refined += hits[i + 3] >= 2 ? 1 : 0;
  }
  return counts;
}

//------------------------------------------------------------------------------
void vtkMediumImages::Copy(
  const std::vector<float>& pixels, int components, const glm::ivec2& size, vtkImageData* image)
{
  image->SetExtent(0, size.x - 1, 0, size.y - 1, 0, 0);
  image->SetOrigin(0, 0, 0);
  image->SetSpacing(1, 1, 1);
  image->AllocateScalars(VTK_FLOAT, components);
  std::copy(pixels.begin(), pixels.end(), static_cast<float*>(image->GetScalarPointer()));
  image->Modified();
}
