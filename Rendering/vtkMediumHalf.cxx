// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumHalf.h"

#include "vtkMediumTargetClones.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr std::uint32_t Largest = 0x477fe000;     // 65504
constexpr std::uint32_t LeastNormal = 0x38800000; // 2^-14
constexpr std::uint32_t BiasShift = 112u << 23;   // 127 - 15, in a float's exponent

//------------------------------------------------------------------------------
inline std::uint32_t BitsOf(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

//------------------------------------------------------------------------------
inline std::uint16_t Convert(float value)
{
  const std::uint32_t bits = BitsOf(value);
  const std::uint32_t sign = bits >> 16 & 0x8000;
  std::uint32_t magnitude = bits & 0x7fffffff;
  magnitude = magnitude > 0x7f800000 ? 0 : magnitude; // not a number
  magnitude = magnitude > Largest ? Largest : magnitude;
  // Normal halves: half an ulp less one, plus the last bit that stays, makes ties go to even.
  const std::uint32_t normal = (magnitude - BiasShift + 0xfff + (magnitude >> 13 & 1)) >> 13;
  // Subnormal halves: the float unit rounds when their ulp, 2^-24, becomes that of 0.5 + x.
  float small;
  std::memcpy(&small, &magnitude, sizeof(small));
  const std::uint32_t subnormal = BitsOf(small + 0.5f) - BitsOf(0.5f);
  return static_cast<std::uint16_t>(sign | (magnitude < LeastNormal ? subnormal : normal));
}

//------------------------------------------------------------------------------
VTK_MEDIUM_TARGET_CLONES
void ConvertRange(const float* values, std::size_t count, std::uint16_t* target)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    target[i] = Convert(values[i]);
  }
}
}

//------------------------------------------------------------------------------
std::uint16_t vtkMediumHalfFromFloat(float value)
{
  return Convert(value);
}

//------------------------------------------------------------------------------
float vtkMediumHalfToFloat(std::uint16_t half)
{
  const int exponent = half >> 10 & 31, mantissa = half & 1023;
  const float magnitude = exponent == 0
    ? std::ldexp(static_cast<float>(mantissa), -24)
    : std::ldexp(static_cast<float>(1024 + mantissa), exponent - 25);
  return half & 0x8000 ? -magnitude : magnitude;
}

//------------------------------------------------------------------------------
void vtkMediumPackHalf(
  const float* values, std::size_t count, std::uint16_t* target, std::size_t stride)
{
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), [&](vtkIdType begin, vtkIdType end) {
    constexpr vtkIdType Chunk = 256;
    std::uint16_t packed[Chunk];
    for (vtkIdType i = begin; i < end; i += Chunk)
    {
      const vtkIdType n = std::min(Chunk, end - i);
      if (stride == 1)
      {
        ConvertRange(values + i, n, target + i);
        continue;
      }
      ConvertRange(values + i, n, packed);
      for (vtkIdType k = 0; k < n; ++k)
      {
        target[(i + k) * stride] = packed[k];
      }
    }
  });
}
