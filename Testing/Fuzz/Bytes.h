// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Bytes.h
 * @brief Turns a fuzzer's bytes into numbers; once they are used up, each is zero.
 */
#ifndef Bytes_h
#define Bytes_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace vtkMediumFuzz
{
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : Data(data)
    , Left(size)
  {
  }

  std::uint8_t Byte()
  {
    if (this->Left == 0)
    {
      return 0;
    }
    --this->Left;
    return *this->Data++;
  }

  /// 0 to count - 1; count is at most 256.
  int Whole(int count) { return this->Byte() % count; }

  bool Bit() { return this->Byte() & 1; }

  /// 0 to 1, both included.
  double Unit() { return this->Byte() / 255.0; }

  /// Any double at all.
  double Any()
  {
    std::uint8_t bytes[sizeof(double)];
    for (std::uint8_t& byte : bytes)
    {
      byte = this->Byte();
    }
    double value;
    std::memcpy(&value, bytes, sizeof(value));
    return value;
  }

  /// Of 3000 numbers so many are odd, so that not every input is refused.
  int Oddness = 64;

  /// Mostly a number of `low` to `high`; else one that nobody would type.
  double Number(double low, double high)
  {
    int kind = this->Byte();
    kind = kind < Unlikely && this->Byte() >= this->Oddness ? 255 : kind;
    const double infinity = std::numeric_limits<double>::infinity();
    const double odd[] = { 0.0, -0.0, 1.0, -1.0, 5e-324, -1e-300, 1e-40, 1e-12, 1e12, 1e38, 1e39,
      -1e300, std::numeric_limits<double>::max(), -std::numeric_limits<double>::max(), infinity,
      -infinity, std::numeric_limits<double>::quiet_NaN() };
    const int odds = sizeof(odd) / sizeof(odd[0]);
    return kind < odds  ? odd[kind]
      : kind < Unlikely ? this->Any()
                        : low + (high - low) * this->Unit();
  }

private:
  static constexpr int Unlikely = 21; ///< of the 256 kinds of a number

  const std::uint8_t* Data;
  std::size_t Left;
};
}

#endif
