// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/DeviceCommand.h"
#include "haptics/core/DeviceSample.h"
#include "haptics/core/Fault.h"
#include "haptics/core/HapticDevice.h"
#include "haptics/line/LineWorld.h"
#include "haptics/safety/SafetyLimits.h"
#include "haptics/tick/base/HapticState.h"

namespace palpate
{

/// All that a line remembers from tick to tick. Copyable.
struct LineState
{
  EngageState engage = EngageState::Safe;
  Fault fault = Fault::None;
  double gain = 0.0; ///< share of the force that is let through, 0 .. 1
  double s_m = 0.0;  ///< where the hand is along the line
  double speed_m_per_s = 0.0;
  double force_N = 0.0;  ///< that it got
  double anchor_m = 0.0; ///< of friction
  bool tracked = false;  ///< s_m is of the tick before
};

/// Input of one tick; x of the device is the position along the line.
struct LineTickInput
{
  DeviceSample sample;
  DeviceStatus status = DeviceStatus::Ok;
  bool engage = false; ///< the person asks for force now
  double dt_s = 1e-3;
};

/// The tick of a line: the limits, ramps and faults are those of every other tick (docs/faults.md). Nothing is pushed
/// before somebody engages, and then from a small force on. Pure; real-time safe.
[[nodiscard]] DeviceCommand stepLine(
  const LineWorld& world, const SafetyLimits& limits, const LineTickInput& input, LineState& state) noexcept;

} // namespace palpate
