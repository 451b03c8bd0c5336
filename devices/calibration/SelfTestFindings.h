// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "devices/calibration/Calibration.h"
#include "devices/calibration/SelfTest.h"

namespace palpate
{

/// What lies behind an axis of D, from where the hand was at its ends.
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
  None,    ///< it moves nothing
  Unclear, ///< the hand did something else
  Clear,
};

/// What a motor moves, from what its pushes did.
struct MotorFinding
{
  MotorMotion motion = MotorMotion::Unclear;
  int sensor = 0; ///< the driver's axis that it moves
  int sign = 1;   ///< -1: a positive command moves it down
  double response_m_per_N = 0.0;
  double strength = 0.0; ///< N against the device's own spring per N asked for; 0: not measured
};

/// The least motion that is told from standing still [m]. This and the next two are real-time safe.
[[nodiscard]] double leastMotion_m(const SelfTestPlan& plan, const SelfTestState& state) noexcept;
[[nodiscard]] AxisFinding findAxis(const SelfTestPlan& plan, const SelfTestState& state, int axis) noexcept;
[[nodiscard]] MotorFinding findMotor(const SelfTestPlan& plan, const SelfTestState& state, int motor) noexcept;

/// What a passed test says about the device, to be kept; none where it did not pass. `date`: YYYY-MM-DD.
[[nodiscard]] std::optional<Calibration> calibrationFrom(
  const SelfTestPlan& plan, const SelfTestState& state, const DeviceInfo& device, const std::string& date);

/// What the person is to do now, in one sentence; empty once there is a verdict.
[[nodiscard]] std::string askOf(const SelfTestPlan& plan, const SelfTestState& state);

/// What was found, in a few lines; empty before there is a verdict.
[[nodiscard]] std::string resultOf(const SelfTestPlan& plan, const SelfTestState& state);

} // namespace palpate
