// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/protocol/FalconWire.h"

#include <algorithm>

#include "devices/arm/protocol/WireNumbers.h"

namespace palpate
{
namespace
{

constexpr std::uint8_t begin = '<', end = '>', zero = 0x41;
constexpr std::uint8_t home = 1, green = 2;
constexpr std::size_t lights = 13, nibbles = 4; ///< the place of the lights, and of the buttons

} // namespace

void FalconWire::encode(const WireOrder& order, WireBytes& bytes) const
{
  bytes.assign(1, begin);
  for (const double torque_Nm : order.joint_Nm)
  {
    const auto number = static_cast<std::uint16_t>(nearest16(number_per_Nm * torque_Nm, largestNumber));
    for (std::size_t i = 0; i < nibbles; ++i)
    {
      bytes.push_back(static_cast<std::uint8_t>(zero + (number >> 4 * i & 0xFU)));
    }
  }
  bytes.push_back(zero + home + green);
  bytes.push_back(zero);
  bytes.push_back(end);
}

/// From the first beginning that has its end; whatever lies before it is the rest of something else.
WireFrame FalconWire::frame(std::span<const std::uint8_t> bytes) const noexcept
{
  for (std::size_t at = 0; at < bytes.size(); ++at)
  {
    if (bytes[at] == begin && (bytes.size() - at < length || bytes[at + length - 1] == end))
    {
      return { at, bytes.size() - at < length ? 0 : length };
    }
  }
  return { bytes.size(), 0 };
}

std::optional<WireReading> FalconWire::decode(std::span<const std::uint8_t> answer) const
{
  const auto isNibble = [](std::uint8_t c) { return c >= zero && c < zero + 16; };
  if (answer.size() != length || answer.front() != begin || answer.back() != end ||
      !std::all_of(answer.begin() + 1, answer.begin() + lights, isNibble) || answer[lights] < zero ||
      answer[lights] >= zero + 128)
  {
    return std::nullopt;
  }
  WireReading reading;
  for (std::size_t i = 0; i < 3; ++i)
  {
    unsigned number = 0;
    for (std::size_t k = 0; k < nibbles; ++k)
    {
      number |= static_cast<unsigned>(answer[1 + nibbles * i + k] - zero) << 4 * k;
    }
    reading.encoder[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(number));
  }
  const unsigned said = answer[lights] - zero;
  reading.buttons = said & 0xFU;
  reading.homed = said >> 4U == 7;
  return reading;
}

} // namespace palpate
