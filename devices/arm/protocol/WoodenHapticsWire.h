// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/arm/protocol/WireProtocol.h"

namespace palpate
{

/// The reports of WoodenHaptics and Polhem arms: seven little-endian int16 each way, currents out, counters in
/// (forsslund/haptikfabrikenapi, firmware/main.cpp). The firmware switches its amplifiers off 0.5 s after the last one.
class WoodenHapticsWire final : public WireProtocol
{
public:
  static constexpr std::size_t length = 14;
  static constexpr double largest_mA = 2000.0;

  /// `constants_Nm_per_A`: torque of each motor for an ampere. `grips`: the fourth counter tells whether the arm is
  /// gripped; else it is that of a joint alone.
  WoodenHapticsWire(const std::array<double, WireOrder::motors>& constants_Nm_per_A, bool grips)
    : constants_Nm_per_A_(constants_Nm_per_A), grips_(grips)
  {
  }

  void encode(const WireOrder& order, WireBytes& bytes) const override;
  [[nodiscard]] std::optional<WireReading> decode(std::span<const std::uint8_t> answer) const override;

private:
  std::array<double, WireOrder::motors> constants_Nm_per_A_;
  bool grips_;
};

} // namespace palpate
