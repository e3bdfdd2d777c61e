// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What a shader looks up in a light cache: filtered transmittances, and their roughness.
#include "vtkMediumLightCache.h"

#include "vtkMediumHalf.h"
#include "vtkMediumTargetClones.h"

#include "vtkSMPTools.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace
{
//------------------------------------------------------------------------------
// Slices of transmittances of a part of the lattice, of which the last three are kept.
class TransmittanceSlices
{
public:
  TransmittanceSlices(const std::vector<float>& depths, const glm::ivec3& dimensions,
    const vtkMediumLatticePart& part, double densityScale)
    : Depths(depths)
    , Dimensions(dimensions)
    , Part(part)
    , Scale(static_cast<float>(-densityScale))
  {
    for (std::vector<float>& slice : this->Slices)
    {
      slice.resize(static_cast<std::size_t>(part.GetSize().x) * part.GetSize().y);
    }
  }

  /// Optical depths of a row; indices count from the part's begin.
  const float* GetDepths(int y, int z) const
  {
    const glm::ivec3 at = this->Part.Begin + glm::ivec3(0, y, z);
    return this->Depths.data() + at.x +
      this->Dimensions.x * (at.y + static_cast<std::size_t>(this->Dimensions.y) * at.z);
  }

  float GetDensityScale() const { return -this->Scale; }

  /// Transmittances of a row.
  const float* GetRow(int y, int z)
  {
    const int place = z % Kept;
    if (this->Held[place] != z)
    {
      this->Fill(this->Slices[place], z);
      this->Held[place] = z;
    }
    return this->Slices[place].data() + y * static_cast<std::size_t>(this->Part.GetSize().x);
  }

private:
  static constexpr int Kept = 3;

  void Fill(std::vector<float>& slice, int z) const
  {
    float* target = slice.data();
    for (int y = 0; y < this->Part.GetSize().y; ++y)
    {
      const float* depths = this->GetDepths(y, z);
      for (int x = 0; x < this->Part.GetSize().x; ++x)
      {
        *target++ = std::exp(std::max(this->Scale * std::max(depths[x], 0.0f), -80.0f));
      }
    }
  }

  const std::vector<float>& Depths;
  glm::ivec3 Dimensions;
  vtkMediumLatticePart Part;
  float Scale;
  std::vector<float> Slices[Kept];
  int Held[Kept] = { -1, -1, -1 };
};

//------------------------------------------------------------------------------
VTK_MEDIUM_TARGET_CLONES
void AddSecondDifferences(const float* before, const float* center, const float* behind, int n,
  float* sum, float* magnitudes)
{
  for (int x = 0; x < n; ++x)
  {
    const float difference = before[x] + behind[x] - 2 * center[x];
    sum[x] += difference;
    magnitudes[x] += std::abs(difference);
  }
}

//------------------------------------------------------------------------------
// Where light enters the lattice, from optical depths on its face (0 there) and on the next two points inside:
// what the first cell may be curved by, which no second difference of transmittances has seen. Extinction
// that rises there bends them twice as much as it bends the optical depth of two cells; twice that, since
// the interpolated roughness has half of it.
float FaceCurvature(float face, float next, float second, float densityScale)
{
  if (face != 0 || next <= 0 || second < 0)
  {
    return 0;
  }
  const float bent = densityScale * std::abs(second - 2 * next);
  return 4 * std::min(bent, 1 - std::exp(-densityScale * next));
}

//------------------------------------------------------------------------------
VTK_MEDIUM_TARGET_CLONES
void Finish(const float* center, const float* depths, int n, float* sum, float* magnitudes)
{
  for (int x = 0; x < n; ++x)
  {
    sum[x] = center[x] - sum[x] * (1.0f / 12);
    magnitudes[x] = depths[x] < 0 ? 1.0f : magnitudes[x] * (1.0f / 8);
  }
}

//------------------------------------------------------------------------------
// Filters rows. On the lattice's faces nothing is known of the second difference across them: it counts as 0
// where it would move the value, and as that of the next point inside where it says how far off it may be, or
// as the curvature of the first cell.
class RowFilter
{
public:
  RowFilter(TransmittanceSlices& slices, const glm::ivec3& size)
    : Slices(slices)
    , Size(size)
    , Sum(size.x)
    , Magnitudes(size.x)
    , Ignored(size.x)
  {
  }

  void Apply(int y, int z)
  {
    const int n = this->Size.x;
    std::fill(this->Sum.begin(), this->Sum.end(), 0.0f);
    std::fill(this->Magnitudes.begin(), this->Magnitudes.end(), 0.0f);
    auto inSlice = [&](int at) { return glm::ivec2(at, z); };
    auto inColumn = [&](int at) { return glm::ivec2(y, at); };
    this->AddAcross(y, this->Size.y, inSlice);
    this->AddAcross(z, this->Size.z, inColumn);
    const float* row = this->Slices.GetRow(y, z);
    if (n > 2)
    {
      AddSecondDifferences(
        row, row + 1, row + 2, n - 2, this->Sum.data() + 1, this->Magnitudes.data() + 1);
      this->Magnitudes[0] += std::abs(row[0] + row[2] - 2 * row[1]);
      this->Magnitudes[n - 1] += std::abs(row[n - 3] + row[n - 1] - 2 * row[n - 2]);
      const float* depths = this->Slices.GetDepths(y, z);
      for (int x : { 0, 1 })
      {
        const int last = n - 1;
        this->AddFace(x, depths[0], depths[1], depths[2]);
        this->AddFace(last - x, depths[last], depths[last - 1], depths[last - 2]);
      }
    }
    Finish(row, this->Slices.GetDepths(y, z), n, this->Sum.data(), this->Magnitudes.data());
  }

  const float* GetTransmittance() const { return this->Sum.data(); }
  const float* GetRoughness() const { return this->Magnitudes.data(); }

private:
  void AddFace(int x, float face, float next, float second)
  {
    this->Magnitudes[x] += FaceCurvature(face, next, second, this->Slices.GetDensityScale());
  }

  // Along y or z; rowAt(i) is y and z of the row that is the i-th along it.
  template <typename RowAt>
  void AddAcross(int at, int count, const RowAt& rowAt)
  {
    if (count < 3)
    {
      return;
    }
    auto transmittances = [&](int i) { return this->Slices.GetRow(rowAt(i).x, rowAt(i).y); };
    auto depths = [&](int i) { return this->Slices.GetDepths(rowAt(i).x, rowAt(i).y); };
    const int middle = std::min(std::max(at, 1), count - 2), n = this->Size.x;
    AddSecondDifferences(transmittances(middle - 1), transmittances(middle),
      transmittances(middle + 1), n, middle == at ? this->Sum.data() : this->Ignored.data(),
      this->Magnitudes.data());
    for (int face : { 0, count - 1 })
    {
      const int inwards = face == 0 ? 1 : -1;
      if (at == face || at == face + inwards)
      {
        const float *first = depths(face), *next = depths(face + inwards),
                    *second = depths(face + 2 * inwards);
        for (int x = 0; x < n; ++x)
        {
          this->AddFace(x, first[x], next[x], second[x]);
        }
      }
    }
  }

  TransmittanceSlices& Slices;
  glm::ivec3 Size;
  std::vector<float> Sum, Magnitudes, Ignored;
};
}

//------------------------------------------------------------------------------
// Slices [begin, end) of the part; `write` takes each slice of it, its transmittances and roughnesses.
template <typename Write>
void vtkMediumLightCache::FilterSlices(double densityScale, const vtkMediumLatticePart& part,
  int begin, int end, const Write& write) const
{
  const vtkMediumLatticePart read = part.Grow(2, this->Dimensions);
  const glm::ivec3 first = part.Begin - read.Begin, size = part.GetSize();
  TransmittanceSlices slices(this->Depths, this->Dimensions, read, densityScale);
  RowFilter filter(slices, read.GetSize());
  std::vector<float> transmittance(static_cast<std::size_t>(size.x) * size.y);
  std::vector<float> roughness(transmittance.size());
  for (int z = begin; z < end; ++z)
  {
    for (int y = 0; y < size.y; ++y)
    {
      filter.Apply(first.y + y, first.z + z);
      const std::size_t at = y * static_cast<std::size_t>(size.x);
      std::copy_n(filter.GetTransmittance() + first.x, size.x, transmittance.data() + at);
      std::copy_n(filter.GetRoughness() + first.x, size.x, roughness.data() + at);
    }
    write(z, transmittance, roughness);
  }
}

//------------------------------------------------------------------------------
void vtkMediumLightCache::Pack(double densityScale, const vtkMediumLatticePart& part,
  bool withRoughness, std::uint16_t* target, std::size_t stride) const
{
  vtkSMPTools::For(0, part.GetSize().z, 16, [&](vtkIdType begin, vtkIdType end) {
    this->FilterSlices(densityScale, part, static_cast<int>(begin), static_cast<int>(end),
      [&](int z, const std::vector<float>& transmittance, const std::vector<float>& roughness) {
        std::uint16_t* slice = target + z * transmittance.size() * stride;
        vtkMediumPackHalf(transmittance.data(), transmittance.size(), slice, stride);
        if (withRoughness)
        {
          vtkMediumPackHalf(roughness.data(), roughness.size(), slice + 1, stride);
        }
      });
  });
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumLightCache::GetTransmittance(double densityScale) const
{
  std::vector<float> values;
  this->FilterSlices(densityScale, { glm::ivec3(0), this->Dimensions }, 0, this->Dimensions.z,
    [&](int, const std::vector<float>& transmittance, const std::vector<float>&) {
      values.insert(values.end(), transmittance.begin(), transmittance.end());
    });
  return values;
}

//------------------------------------------------------------------------------
std::vector<float> vtkMediumLightCache::GetRoughness(double densityScale) const
{
  std::vector<float> values;
  this->FilterSlices(densityScale, { glm::ivec3(0), this->Dimensions }, 0, this->Dimensions.z,
    [&](int, const std::vector<float>&, const std::vector<float>& roughness) {
      values.insert(values.end(), roughness.begin(), roughness.end());
    });
  return values;
}
