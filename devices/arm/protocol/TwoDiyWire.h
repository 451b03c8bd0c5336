// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/arm/protocol/WireProtocol.h"

namespace palpate
{

/// The messages of the hAPI boards of Haply's 2DIY (facts of HaplyHaptics/Haply-Arduino-Firmware-Versions): no borders,
/// no checksum. The board keeps the last torque for ever; only a message of zeros ends it. A message of zeros says
/// nothing to a board that was not set up, so the greeting comes first; it is said again where the angles are to begin.
class TwoDiyWire final : public WireProtocol
{
public:
  static constexpr double largest_Nm = 0.123; ///< of a motor: where the firmware clamps

  /// How the board is wired; both motors stand on the first two ports.
  struct Setup
  {
    std::uint8_t device = 5;
    std::array<std::uint8_t, 2> motorTurned{}, encoderTurned{}; ///< 1: the other way round
    std::array<double, 2> offset_deg{}, countsPerTurn{};        ///< of joints; offset: where they stand at the set-up
    std::array<double, 2> gear{ 1.0, 1.0 };                     ///< turns of the motor per turn of the joint
  };
  explicit TwoDiyWire(const Setup& setup) : setup_(setup) {}

  void encode(const WireOrder& order, WireBytes& bytes) const override;
  [[nodiscard]] WireFrame frame(std::span<const std::uint8_t> bytes) const noexcept override;
  /// Degrees of the two encoders.
  [[nodiscard]] std::optional<WireReading> decode(std::span<const std::uint8_t> answer) const override;
  [[nodiscard]] WireBytes greeting() const override;
  /// The board takes the first bytes for the rest of a message that was cut short, so bytes come first that are small
  /// as torques and no command; then a reset, as pins of a greeting that was cut short may be counted; the greeting;
  /// zeros.
  [[nodiscard]] WireBytes farewell() const override;

private:
  Setup setup_;
};

} // namespace palpate
