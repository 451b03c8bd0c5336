// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "haptics/core/DeviceInfo.h"
#include "haptics/force/StabilityLimits.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// What the loop of these parameters is, for StabilityLimits.
[[nodiscard]] inline LoopSettings loopSettings(const HapticParameters& parameters, double period_s) noexcept
{
  return { period_s, parameters.damping_Ns_per_m, parameters.passivity };
}

/// What a person set, completed by what the device says about itself: the encoder step the velocity is estimated
/// with, the largest stiffness, no passivity control where no force reaches a hand, and walls left to it only if it
/// closes them: then no stiffer and no harder than it can, and what the host closes beside them neither, and no more
/// often than its link carries them. `viscosity_Ns_per_m`: what its corridors need (Viscosity.h).
[[nodiscard]] inline HapticParameters adaptToDevice(HapticParameters parameters, const DeviceInfo& device,
  const StabilityLimits& limits, double viscosity_Ns_per_m = 0.0) noexcept
{
  parameters.passivity.enabled = parameters.passivity.enabled && device.rendersForce;
  if (parameters.velocity.resolution_m == 0.0)
  {
    parameters.velocity.resolution_m = device.resolution_m.value;
  }
  parameters.stiffnessLimit_N_per_m = parameters.limitStiffness ? limits.largest_N_per_m : StabilityLimits::unlimited;
  parameters.walls.hold = parameters.walls.hold && device.closesWalls();
  if (parameters.walls.hold)
  {
    parameters.stiffnessLimit_N_per_m = std::min(parameters.stiffnessLimit_N_per_m, device.heldStiffness_N_per_m.value);
    parameters.safety.maxForce_N = std::min(parameters.safety.maxForce_N, device.heldForce_N.value);
  }
  parameters.walls.every_s = std::max(parameters.walls.every_s, device.wallUpdate_s.value);
  if (parameters.walls.step_m == 0.0)
  {
    parameters.walls.step_m = device.resolution_m.value;
  }
  parameters.walls.viscosity_Ns_per_m = std::max(parameters.walls.viscosity_Ns_per_m, viscosity_Ns_per_m);
  return parameters;
}

} // namespace palpate
