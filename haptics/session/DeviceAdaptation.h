// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/DeviceInfo.h"
#include "haptics/force/StabilityLimits.h"
#include "haptics/session/HapticParameters.h"

namespace palpate
{

/// What the loop of these parameters is, for StabilityLimits.
[[nodiscard]] inline LoopSettings loopSettings(const HapticParameters& parameters, double period_s) noexcept
{
  return { period_s, parameters.damping_Ns_per_m, parameters.passivity };
}

/// What a person set, completed by what the device says about itself: the encoder step the velocity is estimated
/// with, the largest stiffness, and no passivity control where no force reaches a hand.
[[nodiscard]] inline HapticParameters adaptToDevice(
  HapticParameters parameters, const DeviceInfo& device, const StabilityLimits& limits) noexcept
{
  parameters.passivity.enabled = parameters.passivity.enabled && device.rendersForce;
  if (parameters.velocity.resolution_m == 0.0)
  {
    parameters.velocity.resolution_m = device.resolution_m.value;
  }
  parameters.stiffnessLimit_N_per_m =
    parameters.limitStiffness ? limits.largest_N_per_m : StabilityLimits::unlimited;
  return parameters;
}

} // namespace palpate
