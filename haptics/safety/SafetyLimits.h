// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "haptics/core/DeviceInfo.h"
#include "haptics/safety/DeadMan.h"
#include "haptics/safety/HandLimits.h"
#include "haptics/safety/PositionWatch.h"

namespace palpate
{

/// Limits that protect the hand. The defaults are for a device of unknown largest force and without torque: 3 N,
/// reached in 20 ms or more, and a ramp of 1 s from a small force.
struct SafetyLimits
{
  double maxForce_N = 3.0;
  double maxRise_N_per_s = 150.0;      ///< growth only: release is always free
  double maxTorque_Nm = 0.0;           ///< likewise
  double maxTorqueRise_Nm_per_s = 0.0; ///< likewise
  double engageRamp_s = 1.0;
  double engageBelow_N = 0.3; ///< engages only from a force this small
  double releaseRamp_s = 0.05;
  double faultRamp_s = 0.01;
  bool needsEngage = true; ///< false: a program's own path, engaged from the first tick
  DeadMan deadMan;         ///< controls that must be held; let go: force to zero, and armed again
  HandLimits hand;
  double frozenAbove_N = PositionWatch::never; ///< a position that stays the same under more force than this is said

  /// No device, no hand: the headless tick.
  [[nodiscard]] static SafetyLimits none() noexcept
  {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    SafetyLimits limits;
    limits.maxForce_N = limits.maxRise_N_per_s = limits.engageBelow_N = unlimited;
    limits.maxTorque_Nm = limits.maxTorqueRise_Nm_per_s = unlimited;
    limits.engageRamp_s = limits.releaseRamp_s = limits.faultRamp_s = 0.0;
    limits.needsEngage = false;
    return limits;
  }

  /// Of a device: 60 % of its largest force, growing by no more than all of it in 20 ms, and the limits of a hand. A
  /// device without a force may be led at any speed; a simulated one may stand still to the bit.
  [[nodiscard]] static SafetyLimits forDevice(const DeviceInfo& device) noexcept
  {
    SafetyLimits limits;
    const double most_N = device.maxForce_N.value;
    if (most_N < std::numeric_limits<double>::infinity())
    {
      limits.maxForce_N = 0.6 * most_N;
      limits.maxRise_N_per_s = 50.0 * most_N;
      limits.engageBelow_N = 0.1 * most_N;
    }
    if (device.rendersTorque)
    {
      // Of one with unknown largest torque: the largest force on an arm of 30 mm, from the fingers to the middle of a
      // handle.
      constexpr double unknownArm_m = 0.03;
      const double known_Nm = device.maxTorque_Nm.value;
      const double largest_Nm = known_Nm < std::numeric_limits<double>::infinity() ? known_Nm : 5.0 * unknownArm_m;
      limits.maxTorque_Nm = 0.6 * largest_Nm;
      limits.maxTorqueRise_Nm_per_s = 50.0 * largest_Nm;
    }
    if (device.rendersForce)
    {
      limits.hand = handLimits(device.workspaceRadius_m.value, most_N);
      limits.frozenAbove_N = device.simulated ? PositionWatch::never : PositionWatch::counts * most_N;
    }
    return limits;
  }
};

} // namespace palpate
