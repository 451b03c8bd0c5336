// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate::testing
{

/// A NIfTI file as its public description lays it out (nifti1.h and nifti2.h of the NIfTI committee), number by number.
class NIfTIBytes
{
public:
  explicit NIfTIBytes(int version = 1, bool bigEndian = false)
    : second_(version == 2), swaps_(bigEndian == (std::endian::native == std::endian::little)),
      bytes_(version == 2 ? 544 : 352)
  {
    this->putInt32(0, this->second_ ? 540 : 348);
    const std::string magic = this->second_ ? std::string("n+2\0\r\n\032\n", 8) : std::string("n+1\0", 4);
    std::memcpy(this->bytes_.data() + (this->second_ ? 4 : 344), magic.data(), magic.size());
    this->setVoxOffset(static_cast<double>(this->bytes_.size()));
    this->setSpacing(Vec3::Ones());
  }

  /// dim[0] is how many there are.
  void setDim(const std::vector<std::int64_t>& counts)
  {
    this->setDim(0, static_cast<std::int64_t>(counts.size()));
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
      this->setDim(i + 1, counts[i]);
    }
  }
  void setDim(std::size_t i, std::int64_t count)
  {
    this->second_ ? this->put(16 + 8 * i, count) : this->put(40 + 2 * i, static_cast<std::int16_t>(count));
  }
  void setType(std::int16_t code) { this->put(this->second_ ? 12 : 70, code); }
  void setPixDim(std::size_t i, double value) { this->putReal(76, 104, i, value); }
  void setSpacing(const Vec3& lengths)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->setPixDim(static_cast<std::size_t>(axis) + 1, lengths[axis]);
    }
  }
  void setVoxOffset(double bytes)
  {
    this->second_ ? this->put(168, static_cast<std::int64_t>(bytes)) : this->put(108, static_cast<float>(bytes));
  }
  void setSlope(double slope, double intercept)
  {
    this->putReal(112, 176, 0, slope);
    this->putReal(116, 184, 0, intercept);
  }
  void setTimeOffset(double time) { this->putReal(136, 216, 0, time); }
  void setUnits(std::uint8_t code) { this->second_ ? this->putInt32(500, code) : this->put(123, code); }

  /// Row by row: [linear | shift].
  void setSForm(const Mat3& linear, const Vec3& shift)
  {
    this->putCode(254, 348, 1);
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        this->putReal(
          280, 400, static_cast<std::size_t>(4 * row + column), column < 3 ? linear(row, column) : shift[row]);
      }
    }
  }
  void setQForm(const Quat& q, const Vec3& shift, double qfac)
  {
    this->putCode(252, 344, 1);
    this->setPixDim(0, qfac);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->putReal(256, 352, static_cast<std::size_t>(axis), q.vec()[axis]);
      this->putReal(268, 376, static_cast<std::size_t>(axis), shift[axis]);
    }
  }

  /// Behind all that is there.
  template<class Value>
  void add(Value value)
  {
    const std::size_t at = this->bytes_.size();
    this->bytes_.resize(at + sizeof(value));
    this->put(at, value);
  }
  template<class Value>
  void put(std::size_t at, Value value)
  {
    char* const to = this->bytes_.data() + at;
    std::memcpy(to, &value, sizeof(value));
    if (this->swaps_)
    {
      std::reverse(to, to + sizeof(value));
    }
  }

  [[nodiscard]] const std::vector<char>& bytes() const { return this->bytes_; }
  void write(const std::string& path) const;
  /// Packed by gzip.
  void writePacked(const std::string& path) const;

private:
  void putInt32(std::size_t at, std::int32_t value) { this->put(at, value); }
  void putReal(std::size_t first, std::size_t second, std::size_t i, double value)
  {
    this->second_ ? this->put(second + 8 * i, value) : this->put(first + 4 * i, static_cast<float>(value));
  }
  void putCode(std::size_t first, std::size_t second, std::int16_t code)
  {
    this->second_ ? this->putInt32(second, code) : this->put(first, code);
  }

  bool second_;
  bool swaps_;
  std::vector<char> bytes_;
};

} // namespace palpate::testing
