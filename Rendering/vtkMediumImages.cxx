// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumImages.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkImageData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace
{
//------------------------------------------------------------------------------
bool IsHit(float first)
{
  return first > vtkMediumFrame::NoHit;
}
}

//------------------------------------------------------------------------------
vtkMediumFrame::Grey vtkMediumImages::FindGrey(const vtkMediumScene& scene, int output)
{
  vtkMediumFrame::Grey grey;
  if (output == vtkSingleScatteringVolumeMapper::Radiance)
  {
    return grey;
  }
  grey.Scale = 1; // the volume's diagonal is one local unit
  grey.First = output == vtkSingleScatteringVolumeMapper::FirstHit;
  if (grey.First)
  {
    // As the shader has it: along parallel rays t counts from the plane through the local origin.
    double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::dvec3 at = scene.Geometry.BoxToLocal(
        glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1));
      const double distance = scene.Eye.Parallel ? glm::dot(at, scene.Eye.Direction)
                                                 : glm::distance(at, scene.Eye.Origin);
      nearest = std::min(nearest, distance);
      farthest = std::max(farthest, distance);
    }
    grey.Nearest = nearest;
    grey.Scale = 1 / (farthest - nearest);
  }
  return grey;
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumImages::Distances(
  const std::vector<float>& hits, const vtkMediumScene& scene, bool first)
{
  std::vector<float> pixels(hits.size(), 0.0f);
  for (std::size_t i = 0; i < hits.size(); i += 4)
  {
    if (IsHit(hits[i]))
    {
      const double from = first ? scene.Eye.Start : hits[i];
      const double local = (first ? hits[i] : hits[i + 1]) - from;
      std::fill_n(&pixels[i], 3, static_cast<float>(local * scene.Geometry.Length));
      pixels[i + 3] = 1;
    }
  }
  return pixels;
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
      const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) / glm::dvec2(size) * 2.0 - 1.0;
      const glm::dvec3 direction =
        glm::normalize(eye.Direction + at.x * eye.DirectionX + at.y * eye.DirectionY);
      const glm::dvec4 point(
        eye.Origin + at.x * eye.OriginX + at.y * eye.OriginY + t * direction, 1);
      const double depth = 0.5 + 0.5 * glm::dot(eye.ClipZ, point) / glm::dot(eye.ClipW, point);
      depths.push_back(!IsHit(hits[4 * depths.size()]) ? 1.0f : static_cast<float>(glm::clamp(depth, 0.0, 1.0)));
    }
  }
  return depths;
}

//------------------------------------------------------------------------------
void vtkMediumImages::Count(
  const std::vector<float>& hits, vtkTypeInt64& taps, vtkTypeInt64& rays)
{
  taps = rays = 0;
  for (std::size_t i = 0; i < hits.size(); i += 4)
  {
    taps += static_cast<vtkTypeInt64>(hits[i + 2]);
    rays += static_cast<vtkTypeInt64>(hits[i + 3]);
  }
}

//------------------------------------------------------------------------------
void vtkMediumImages::Copy(const std::vector<float>& pixels, int components,
  const glm::ivec2& size, vtkImageData* image)
{
  image->SetExtent(0, size.x - 1, 0, size.y - 1, 0, 0);
  image->SetOrigin(0, 0, 0);
  image->SetSpacing(1, 1, 1);
  image->AllocateScalars(VTK_FLOAT, components);
  std::copy(pixels.begin(), pixels.end(), static_cast<float*>(image->GetScalarPointer()));
  image->Modified();
}
