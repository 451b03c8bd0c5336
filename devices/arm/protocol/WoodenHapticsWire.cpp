// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/arm/protocol/WoodenHapticsWire.h"

#include "devices/arm/protocol/WireNumbers.h"

namespace palpate
{
namespace
{

constexpr std::int16_t applyCurrents = 0, setCounters = 1;
constexpr std::int16_t gripped = 5000; ///< a fourth counter beyond it says that the grip is closed
constexpr double gripAdds = 10000.0;

} // namespace

void WoodenHapticsWire::encode(const WireOrder& order, WireBytes& bytes) const
{
  bytes.clear();
  for (std::size_t i = 0; i < WireOrder::motors; ++i)
  {
    const double current_mA = 1e3 * order.motor_Nm[i] / this->constants_Nm_per_A_[i];
    put16(bytes, order.counters ? (*order.counters)[3 + i] : nearest16(current_mA, largest_mA));
  }
  put16(bytes, order.counters ? setCounters : applyCurrents);
  for (std::size_t i = 0; i < 3; ++i)
  {
    put16(bytes, order.counters ? (*order.counters)[i] : std::int16_t{ 0 });
  }
}

std::optional<WireReading> WoodenHapticsWire::decode(std::span<const std::uint8_t> answer) const
{
  if (answer.size() < length)
  {
    return std::nullopt;
  }
  WireReading reading;
  for (std::size_t i = 0; i < WireReading::encoders; ++i)
  {
    reading.encoder[i] = get16(answer, 2 * i);
  }
  reading.grip = this->grips_ && reading.encoder[3] > gripped;
  reading.encoder[3] -= reading.grip ? gripAdds : 0.0;
  reading.calibrated = get16(answer, length - 2) != 0;
  return reading;
}

} // namespace palpate
