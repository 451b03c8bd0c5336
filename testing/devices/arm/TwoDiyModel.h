// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <vector>

#include "testing/devices/arm/BoardModel.h"

namespace palpate::test
{

/// The mechanics and the wiring of a pantograph behind such a board; the usual ones are those of the 2DIY.
struct TwoDiyBody
{
  double arm_m = 0.05, forearm_m = 0.07, base_m = 0.02;
  std::array<double, 2> pose_deg{ 180.0, 0.0 }; ///< angles in which a person sets the counters
  std::array<double, 2> gear{ 1.0, 1.0 };       ///< turns of motor and encoder per turn of the joint
  double countsPerTurn = 13824.0;               ///< of the encoders
  std::array<bool, 2> motorWiredTurned{}, encoderWiredTurned{};
};

/// A 2DIY: the pantograph's forward kinematics and the M3 board's firmware, from the facts that are public
/// (HaplyHaptics/Haply-Arduino-Firmware-Versions and Haply-API-cpp). Torque stays for ever, whatever but a message of
/// torques comes; a board that was reset or never set up has no motor that such a message means.
class TwoDiyModel final : public BoardModel
{
public:
  explicit TwoDiyModel(const TwoDiyBody& body = {});

  void take(std::span<const std::uint8_t> bytes) override;
  /// The third joint moves along z and nobody pushes it.
  [[nodiscard]] Vec3 tipOf(const Vec3& joints_rad) const override;
  [[nodiscard]] Vec3 force_N() const override;
  [[nodiscard]] double step_N() const override;

  std::array<double, 2> torque_Nm{}; ///< as the PWM has it, of 4095 steps
  int setUps = 0, resets = 0;

private:
  /// Of an encoder's counter.
  [[nodiscard]] double counts(std::size_t i) const;
  [[nodiscard]] Vec3 forceOfMotors(const std::array<double, 2>& motor_Nm) const;
  /// True: one command was taken off the front.
  bool takeOne();
  /// Of the command that the inbox begins with; more than the inbox has where more must come.
  [[nodiscard]] std::size_t commandLength() const;
  struct SetUp
  {
    std::size_t motorTurns = 0, encoderTurns = 0, pulses = 0, parameters = 0; ///< places in the inbox
    std::size_t encoders = 0, length = 0;
  };
  [[nodiscard]] SetUp setUpIn() const;
  void setUp();
  void push();

  TwoDiyBody body_;
  std::vector<std::uint8_t> inbox_;
  std::uint8_t device_ = 0;     ///< 0: not set up
  std::set<std::uint8_t> pins_; ///< whose pulse a message of torques begins with
  std::array<bool, 2> motorTurned_{}, encoderTurned_{};
  std::array<double, 2> offset_deg_{}, began_deg_{}, countsPerTurn_{};
};

} // namespace palpate::test
