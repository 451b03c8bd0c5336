// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>

namespace palpate
{

/// FNV-1a over 64-bit words: names content, not for adversaries.
class WordHash
{
public:
  void add(std::uint64_t word) noexcept
  {
    this->value_ = (this->value_ ^ word) * 0x100000001b3ull;
    this->value_ ^= this->value_ >> 32; // else the high bits never reach the low ones
  }
  void add(double number) noexcept { this->add(std::bit_cast<std::uint64_t>(number)); }
  [[nodiscard]] std::uint64_t value() const noexcept { return this->value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325ull;
};

} // namespace palpate
