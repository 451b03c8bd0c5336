// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "devices/common/Condition.h"
#include "devices/hid/report/ReportDescriptor.h"
#include "haptics/core/Outcome.h"

namespace palpate
{

struct EffectSettings;

/// Creates and changes effects on a joystick, in either protocol: the PID class over hidraw, or the
/// kernel's driver over evdev. Blocks are numbers of effects that the engine gives out; forces and positions are shares
/// of the device's largest, -1 .. 1. Blocking: one thread, not the servo's. Each bool says whether it was taken.
class EffectEngine
{
public:
  virtual ~EffectEngine() = default;

  using Created = Outcome<int>; ///< its block, 1 .. ; 0: not created
  /// An effect of a type of the PID class.
  [[nodiscard]] virtual Created create(HidUsage type) = 0;
  [[nodiscard]] virtual bool setEffect(int block, const EffectSettings& settings) noexcept = 0;
  /// One axis, 0 or 1, of a spring or a damper; centre, dead band, coefficients and saturations as shares.
  [[nodiscard]] virtual bool setCondition(int block, int axis, const Condition& condition) noexcept = 0;
  [[nodiscard]] virtual bool setConstantForce(int block, double share) noexcept = 0;
  [[nodiscard]] virtual bool setPeriodic(int block, double magnitude, double period_ms) noexcept = 0;
  /// Starting a playing effect restarts its clock.
  [[nodiscard]] virtual bool start(int block) noexcept = 0;
  [[nodiscard]] virtual bool stop(int block) noexcept = 0;
  /// enableActuators, disableActuators, stopAll or reset; true too where there is no such control.
  [[nodiscard]] virtual bool control(HidUsage what) noexcept = 0;

  /// A constant force in the device's own numbers: equal ones need not be sent twice.
  [[nodiscard]] virtual std::int64_t constantForceSteps(double share) const noexcept = 0;
  /// The system's message for the last failure.
  [[nodiscard]] virtual std::string error() const = 0;
};

} // namespace palpate
