// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <vector>

#include "testing/devices/arm/BoardModel.h"

namespace palpate::test
{

/// A 2DIY: the pantograph's forward kinematics and the M3 board's firmware, from the facts that are public
/// (HaplyHaptics/Haply-Arduino-Firmware-Versions and Haply-API-cpp). Torque stays for ever, whatever but a message of
/// torques comes; a board that was reset or never set up has no motor that such a message means.
class TwoDiyModel final : public BoardModel
{
public:
  TwoDiyModel();

  void take(std::span<const std::uint8_t> bytes) override;
  /// The third joint moves along z and nobody pushes it.
  [[nodiscard]] Vec3 tipOf(const Vec3& joints_rad) const override;
  [[nodiscard]] Vec3 force_N() const override;
  [[nodiscard]] double step_N() const override;

  std::array<double, 2> torque_Nm{}; ///< as the PWM has it, of 4095 steps
  int setUps = 0, resets = 0;

private:
  /// True: one command was taken off the front.
  bool takeOne();
  /// Of the command that the inbox begins with; more than the inbox has where more must come.
  [[nodiscard]] std::size_t commandLength() const;
  struct SetUp
  {
    std::size_t pulses = 0, parameters = 0, encoders = 0, length = 0; ///< places in the inbox; how many
  };
  [[nodiscard]] SetUp setUpIn() const;
  void setUp();
  void push();

  std::vector<std::uint8_t> inbox_;
  std::uint8_t device_ = 0;     ///< 0: not set up
  std::set<std::uint8_t> pins_; ///< whose pulse a message of torques begins with
  std::array<double, 2> offset_deg_{}, began_deg_{}, countsPerTurn_{};
};

} // namespace palpate::test
