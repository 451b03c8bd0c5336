// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/arm/protocol/WireProtocol.h"

namespace palpate
{

/// The packets of a Novint Falcon whose firmware runs: '<', fourteen characters, '>' each way, a character being 0x41
/// and a value (facts of libnifalcon/libnifalcon). The order to home stays in every packet: without it the places of
/// the motors mean nothing.
class FalconWire final : public WireProtocol
{
public:
  static constexpr std::size_t length = 16;
  static constexpr double number_per_Nm = -10000.0; ///< of the joint's torque; the library's figure, measured by nobody
  static constexpr double largestNumber = 4096.0;

  void encode(const WireOrder& order, WireBytes& bytes) const override;
  [[nodiscard]] WireFrame frame(std::span<const std::uint8_t> bytes) const noexcept override;
  /// Counts of the three motors; buttons: plus, forward, centre, minus.
  [[nodiscard]] std::optional<WireReading> decode(std::span<const std::uint8_t> answer) const override;
};

} // namespace palpate
