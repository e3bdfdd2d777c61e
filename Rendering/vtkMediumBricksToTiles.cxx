// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// vtkMediumBricks::ProjectToTiles.
#include "vtkMediumBricks.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Pixels that bounds are widened by; far more than double rounds, far less than a tile.
constexpr double PixelMargin = 1e-3;
// Relative widening of t, for its rounding to float and that of the eye rays.
constexpr double DepthMargin = 1e-5;

//------------------------------------------------------------------------------
// The pixels and the part of the eye rays that a convex set projects to.
struct Footprint
{
  glm::dvec2 Lower{ std::numeric_limits<double>::infinity() };
  glm::dvec2 Upper{ -std::numeric_limits<double>::infinity() };
  double First = std::numeric_limits<double>::infinity();
  double Last = -std::numeric_limits<double>::infinity();

  void AddPixel(const glm::dvec2& pixel)
  {
    this->Lower = glm::min(this->Lower, pixel);
    this->Upper = glm::max(this->Upper, pixel);
  }
  void AddDepth(double t)
  {
    this->First = std::min(this->First, t);
    this->Last = std::max(this->Last, t);
  }
};

//------------------------------------------------------------------------------
class Projection
{
public:
  Projection(const vtkMediumScene::View& view, int width, int height)
    : View(view)
    , Size(width, height)
  {
    // w grows with the distance along an eye ray; slowest in a corner of the viewport.
    this->LeastSlope = std::numeric_limits<double>::infinity();
    for (int corner = 0; corner < 4 && !view.Parallel; ++corner)
    {
      const glm::dvec3 direction = view.Direction + (corner & 1 ? 1.0 : -1.0) * view.DirectionX +
        (corner & 2 ? 1.0 : -1.0) * view.DirectionY;
      this->LeastSlope =
        std::min(this->LeastSlope, glm::dot(glm::dvec3(view.ClipW), glm::normalize(direction)));
    }
  }

  Footprint Project(const glm::dvec3 corners[8]) const
  {
    return this->View.Parallel ? this->ProjectParallel(corners) : this->ProjectPerspective(corners);
  }

private:
  glm::dvec2 ToPixel(const glm::dvec4& clip) const
  {
    return (glm::dvec2(clip) / clip.w + 1.0) * 0.5 * this->Size;
  }

  Footprint ProjectParallel(const glm::dvec3 corners[8]) const
  {
    const vtkMediumScene::View& view = this->View;
    Footprint footprint;
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec4 clip = view.LocalToClip * glm::dvec4(corners[i], 1);
      const glm::dvec2 at = glm::dvec2(clip) / clip.w;
      const glm::dvec3 origin = view.Origin + at.x * view.OriginX + at.y * view.OriginY;
      footprint.AddPixel(this->ToPixel(clip));
      footprint.AddDepth(glm::dot(corners[i] - origin, view.Direction));
    }
    return footprint;
  }

  Footprint ProjectPerspective(const glm::dvec3 corners[8]) const
  {
    const vtkMediumScene::View& view = this->View;
    Footprint footprint;
    glm::dvec4 clip[8];
    double leastW = std::numeric_limits<double>::infinity(), largestW = -leastW;
    for (int i = 0; i < 8; ++i)
    {
      clip[i] = view.LocalToClip * glm::dvec4(corners[i], 1);
      leastW = std::min(leastW, clip[i].w);
      largestW = std::max(largestW, clip[i].w);
      footprint.AddDepth(glm::length(corners[i] - view.Origin));
    }
    // Nearest point: no nearer than the sphere around the brick, nor than its w allows.
    const glm::dvec3 center = 0.5 * (corners[0] + corners[7]);
    double radius = 0;
    for (int i = 0; i < 4; ++i)
    {
      radius = std::max(radius, glm::length(corners[i] - center));
    }
    footprint.First = std::max({ 0.0, glm::length(center - view.Origin) - radius,
      leastW / glm::length(glm::dvec3(view.ClipW)) });
    if (largestW <= 0)
    {
      return Footprint(); // behind the eye
    }
    // What is visible of the brick has at least this w: it is no nearer than First.
    const double visibleW = 0.5 * footprint.First * this->LeastSlope;
    if (leastW > visibleW && leastW > 0)
    {
      for (const glm::dvec4& corner : clip)
      {
        footprint.AddPixel(this->ToPixel(corner));
      }
    }
    else if (visibleW > 0)
    {
      this->AddClipped(clip, visibleW, footprint);
    }
    else // the eye is in the brick, or as good as that
    {
      footprint.AddPixel(glm::dvec2(0));
      footprint.AddPixel(this->Size);
    }
    return footprint;
  }

  // The vertices of the brick's part with w > least.
  void AddClipped(const glm::dvec4 clip[8], double least, Footprint& footprint) const
  {
    for (int i = 0; i < 8; ++i)
    {
      if (clip[i].w >= least)
      {
        footprint.AddPixel(this->ToPixel(clip[i]));
      }
      for (int bit = 1; bit < 8; bit *= 2)
      {
        const glm::dvec4 &a = clip[i], &b = clip[i | bit];
        if ((a.w < least) != (b.w < least))
        {
          footprint.AddPixel(this->ToPixel(glm::mix(a, b, (least - a.w) / (b.w - a.w))));
        }
      }
    }
  }

  const vtkMediumScene::View& View;
  glm::dvec2 Size;
  double LeastSlope;
};

//------------------------------------------------------------------------------
// One thread's share of the tiles.
struct Share
{
  std::vector<glm::dvec2> Ranges;
  std::size_t CutAway = 0;
  glm::dvec2 Lower{ std::numeric_limits<double>::infinity() };
  glm::dvec2 Upper{ -std::numeric_limits<double>::infinity() };
};

//------------------------------------------------------------------------------
void AddFootprint(const Footprint& footprint, const vtkMediumBricks::Tiles& tiles,
  const glm::dvec2& size, Share& share)
{
  const glm::dvec2 lower = glm::max(footprint.Lower - PixelMargin, 0.0);
  const glm::dvec2 upper = glm::min(footprint.Upper + PixelMargin, size);
  if (!(lower.x < upper.x && lower.y < upper.y))
  {
    return;
  }
  share.Lower = glm::min(share.Lower, lower);
  share.Upper = glm::max(share.Upper, upper);
  const glm::ivec2 first(glm::floor(lower / double(tiles.Edge)));
  const glm::ivec2 last =
    glm::min(glm::ivec2(glm::floor(upper / double(tiles.Edge))), tiles.Count - 1);
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      glm::dvec2& range = share.Ranges[x + static_cast<std::size_t>(tiles.Count.x) * y];
      range = { std::min(range.x, footprint.First), std::max(range.y, footprint.Last) };
    }
  }
}

//------------------------------------------------------------------------------
void FindCorners(const glm::dvec3& lower, const glm::dvec3& upper, glm::dvec3 corners[8])
{
  for (int i = 0; i < 8; ++i)
  {
    corners[i] =
      glm::dvec3(i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z);
  }
}

//------------------------------------------------------------------------------
// Those of tiles that bricks fall on, with a margin for the rounding of depths.
void WriteRanges(
  const std::vector<glm::dvec2>& ranges, bool parallel, vtkMediumBricks::Tiles& tiles)
{
  for (std::size_t i = 0; i < ranges.size(); ++i)
  {
    if (ranges[i].x <= ranges[i].y)
    {
      const double margin = DepthMargin * (std::abs(ranges[i].x) + std::abs(ranges[i].y));
      tiles.Ranges[i] = { parallel ? ranges[i].x - margin : std::max(ranges[i].x - margin, 0.0),
        ranges[i].y + margin };
    }
  }
}
}

//------------------------------------------------------------------------------
vtkMediumBricks::Tiles vtkMediumBricks::ProjectToTiles(
  const vtkMediumScene& scene, int width, int height, int edge) const
{
  Tiles tiles;
  tiles.Edge = edge;
  tiles.Count = glm::max((glm::ivec2(width, height) + edge - 1) / edge, glm::ivec2(0));
  const std::size_t count = static_cast<std::size_t>(tiles.Count.x) * tiles.Count.y;
  const double infinity = std::numeric_limits<double>::infinity();
  const glm::dvec2 size(width, height);
  const Projection projection(scene.Eye, width, height);
  vtkSMPThreadLocal<Share> shares;
  const glm::ivec3 n = this->Count;
  vtkSMPTools::For(0, static_cast<vtkIdType>(n.y) * n.z, [&](vtkIdType begin, vtkIdType end) {
    Share& share = shares.Local();
    share.Ranges.resize(count, glm::dvec2(infinity, -infinity));
    for (vtkIdType line = begin; line < end && count > 0; ++line)
    {
      glm::ivec3 brick(0, static_cast<int>(line % n.y), static_cast<int>(line / n.y));
      for (; brick.x < n.x; ++brick.x)
      {
        if (this->GetClass(brick) == Empty)
        {
          continue;
        }
        glm::dvec3 corners[8];
        FindCorners(this->GetLower(brick), this->GetUpper(brick), corners);
        for (glm::dvec3& corner : corners)
        {
          corner = this->LatticeToLocalOrigin + this->LatticeToLocalAxes * corner;
        }
        if (!scene.Cut.MayKeep(corners))
        {
          ++share.CutAway;
          continue;
        }
        AddFootprint(projection.Project(corners), tiles, size, share);
      }
    }
  });

  tiles.Ranges.assign(count, glm::vec2(1, -1));
  glm::dvec2 lower(infinity), upper(-infinity);
  std::vector<glm::dvec2> ranges(count, glm::dvec2(infinity, -infinity));
  for (const Share& share : shares)
  {
    tiles.CutAway += share.CutAway;
    lower = glm::min(lower, share.Lower);
    upper = glm::max(upper, share.Upper);
    for (std::size_t i = 0; i < share.Ranges.size(); ++i)
    {
      ranges[i] = { std::min(ranges[i].x, share.Ranges[i].x),
        std::max(ranges[i].y, share.Ranges[i].y) };
    }
  }
  WriteRanges(ranges, scene.Eye.Parallel, tiles);
  if (lower.x < upper.x)
  {
    const glm::ivec2 first(glm::floor(lower)), last(glm::ceil(upper));
    tiles.Scissor = glm::ivec4(first, glm::min(last, glm::ivec2(width, height)) - first);
  }
  return tiles;
}
