// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/protocol/TwoDiyWire.h"

#include "devices/arm/protocol/WireNumbers.h"

namespace palpate
{
namespace
{

constexpr std::uint8_t reset = 0, setUp = 1, pushAndTell = 2, noCommand = 3;
constexpr std::uint8_t firstTwo = 0x03; ///< a bit for each port
constexpr std::size_t axes = 2, length = 1 + 4 * axes;
constexpr double farthest_deg = 7200.0;

} // namespace

WireBytes TwoDiyWire::greeting() const
{
  const Setup& s = this->setup_;
  WireBytes bytes{ setUp, s.device, firstTwo, s.motorTurned[0], s.motorTurned[1], firstTwo, s.encoderTurned[0],
    s.encoderTurned[1], 0, 0 };
  for (std::size_t i = 0; i < axes; ++i)
  {
    putFloat(bytes, static_cast<float>(s.offset_deg[i]));
    putFloat(bytes, static_cast<float>(s.countsPerTurn[i]));
  }
  return bytes;
}

void TwoDiyWire::encode(const WireOrder& order, WireBytes& bytes) const
{
  bytes = order.counters ? this->greeting() : WireBytes{};
  bytes.insert(bytes.end(), { pushAndTell, this->setup_.device });
  for (std::size_t i = 0; i < axes; ++i)
  {
    const double asked_Nm = order.counters ? 0.0 : order.joint_Nm[i] / this->setup_.gear[i];
    putFloat(bytes, std::isfinite(asked_Nm) ? static_cast<float>(std::clamp(asked_Nm, -largest_Nm, largest_Nm)) : 0.0F);
  }
}

WireBytes TwoDiyWire::farewell() const
{
  constexpr std::size_t longestRest = 64; // no message of the firmware waits for more
  WireBytes bytes(longestRest, noCommand);
  bytes.insert(bytes.end(), { reset, this->setup_.device });
  WireOrder order;
  order.counters.emplace();
  WireBytes zeros;
  this->encode(order, zeros);
  bytes.insert(bytes.end(), zeros.begin(), zeros.end());
  return bytes;
}

/// A message has no mark but the number of the device that it begins with.
WireFrame TwoDiyWire::frame(std::span<const std::uint8_t> bytes) const noexcept
{
  const auto at = static_cast<std::size_t>(std::find(bytes.begin(), bytes.end(), this->setup_.device) - bytes.begin());
  return { at, bytes.size() - at < length ? 0 : length };
}

std::optional<WireReading> TwoDiyWire::decode(std::span<const std::uint8_t> answer) const
{
  if (answer.size() != length || answer.front() != this->setup_.device)
  {
    return std::nullopt;
  }
  WireReading reading;
  for (std::size_t i = 0; i < axes; ++i)
  {
    reading.encoder[i] = getFloat(answer, 1 + 4 * i);
    if (!(std::abs(reading.encoder[i]) <= farthest_deg))
    {
      return std::nullopt;
    }
  }
  return reading;
}

} // namespace palpate
