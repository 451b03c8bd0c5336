// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "devices/calibration/Calibration.h"
#include "devices/calibration/SelfTest.h"

namespace palpate
{

/// Sensor and motor of an axis of D, from the positions of the hand at its ends.
struct AxisFinding
{
  bool found = false; ///< the ends lie along one axis of the driver
  int sensor = 0;
  int sign = 1;       ///< -1: the driver counts it the other way
  double low_m = 0.0; ///< along the driver's axis, low_m < high_m
  double high_m = 0.0;
};

enum class MotorMotion : std::uint8_t
{
  None,      ///< it moves nothing
  Unclear,   ///< the hand did something else
  Mixed,     ///< it moves two axes at once
  Late,      ///< it moves once the push is over
  Sometimes, ///< some pushes move nothing
  Fades,     ///< the second time it moved much less
  Clear,
};

/// The axis that a motor moves, from the effect of its pushes.
struct MotorFinding
{
  MotorMotion motion = MotorMotion::Unclear;
  int sensor = 0; ///< the driver's axis that it moves
  int sign = 1;   ///< -1: a positive command moves it down
  double response_m_per_N = 0.0;
};

/// The effect of the device's own walls and viscosity along one axis: [0] of a push up by its motor, [1] down.
struct HeldFinding
{
  HeldProof proof = HeldProof::Unfelt;
  std::array<double, 2> walls{};   ///< stiffness, as a share of the requested one; < 0: it pulls through
  std::array<double, 2> braking{}; ///< share of the way that was left while it braked; > 1: it drives
};

/// The least motion that is told from standing still [m]. All of these are real-time safe.
[[nodiscard]] double leastMotion_m(const SelfTestPlan& plan, const SelfTestState& state) noexcept;
[[nodiscard]] AxisFinding findAxis(const SelfTestPlan& plan, const SelfTestState& state, int axis) noexcept;
/// After the pushes of the first `repetitions`, 1 or 2, that only a constant force made.
[[nodiscard]] MotorFinding findMotor(
  const SelfTestPlan& plan, const SelfTestState& state, int motor, int repetitions = 2) noexcept;
[[nodiscard]] HeldFinding findHeld(const SelfTestPlan& plan, const SelfTestState& state, int motor) noexcept;
/// Of the walls that a motor, whose free pushes were clear, pushes the hand into: as stiff as the hand, where its
/// stiffness shows best.
[[nodiscard]] double wallStiffness_N_per_m(const SelfTestPlan& plan, const SelfTestState& state, int motor) noexcept;
/// N of the motor against the device's own walls per N asked for; 0: not measured.
[[nodiscard]] double strengthOf(const HeldFinding& held) noexcept;
/// The first motor that moves the driver's axis; -1: none.
[[nodiscard]] int motorOf(const SelfTestPlan& plan, const SelfTestState& state, int sensor) noexcept;
/// Of all axes: the worst.
[[nodiscard]] HeldProof heldProofOf(const SelfTestPlan& plan, const SelfTestState& state) noexcept;
/// A command that was not renewed has expired; nothing: not tried, or not observed.
[[nodiscard]] std::optional<bool> endedByItself(
  const SelfTestPlan& plan, const SelfTestState& state, int motor) noexcept;
/// Why the pushes show that the device does not work, or that they show nothing; None: it works.
[[nodiscard]] SelfTestReason judgePushes(const SelfTestPlan& plan, const SelfTestState& state) noexcept;

/// The calibration from a passed test; none if the test did not pass. `date`: YYYY-MM-DD.
[[nodiscard]] std::optional<Calibration> calibrationFrom(
  const SelfTestPlan& plan, const SelfTestState& state, const DeviceInfo& device, const std::string& date);

} // namespace palpate
