// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "devices/arm/protocol/WireProtocol.h"

namespace palpate
{

/// The whole number nearest to a value within limits; 0 for NaN.
[[nodiscard]] inline std::int16_t nearest16(double value, double largest) noexcept
{
  return std::isfinite(value) ? static_cast<std::int16_t>(std::lround(std::clamp(value, -largest, largest)))
                              : std::int16_t{ 0 };
}

inline void put16(WireBytes& bytes, std::int16_t value)
{
  const auto bits = static_cast<std::uint16_t>(value);
  bytes.push_back(static_cast<std::uint8_t>(bits & 0xFFU));
  bytes.push_back(static_cast<std::uint8_t>(bits >> 8U));
}

[[nodiscard]] inline std::int16_t get16(std::span<const std::uint8_t> bytes, std::size_t at) noexcept
{
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8U));
}

/// IEEE 754, least byte first.
inline void putFloat(WireBytes& bytes, float value)
{
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (unsigned shift = 0; shift < 32; shift += 8)
  {
    bytes.push_back(static_cast<std::uint8_t>(bits >> shift & 0xFFU));
  }
}

[[nodiscard]] inline float getFloat(std::span<const std::uint8_t> bytes, std::size_t at) noexcept
{
  std::uint32_t bits = 0;
  for (unsigned i = 0; i < 4; ++i)
  {
    bits |= static_cast<std::uint32_t>(bytes[at + i]) << 8U * i;
  }
  return std::bit_cast<float>(bits);
}

} // namespace palpate
