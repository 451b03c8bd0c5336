// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>

#include "haptics/core/DeviceInfo.h"
#include "haptics/force/StabilityLimits.h"
#include "haptics/tick/HapticParameters.h"

namespace palpate
{

/// The loop of these parameters, for StabilityLimits. `characteristic_u`: of the tool that is held; 0: the ball.
[[nodiscard]] inline LoopSettings loopSettings(
  const HapticParameters& parameters, double period_s, double characteristic_u = 0.0) noexcept
{
  return { period_s, parameters.damping_Ns_per_m, parameters.passivity,
    characteristic_u / parameters.map.scale_u_per_m };
}

/// How stiff a device can be, and why.
struct JudgedLoop
{
  StabilityLimits limits;
  std::string sentence;
};

/// Takes milliseconds: call after a change of an argument only.
[[nodiscard]] inline JudgedLoop judgeLoop(
  const HapticParameters& parameters, const DeviceInfo& device, double period_s, double characteristic_u = 0.0)
{
  const LoopSettings loop = loopSettings(parameters, period_s, characteristic_u);
  const StabilityLimits limits = stabilityLimits(device, loop);
  return { limits, describe(limits, device, loop) };
}

/// The settings of a person, completed by the device's description.
///
/// The velocity is estimated with the device's encoder step, the stiffness is limited to the stable one of the loop,
/// and passivity control is off where no force reaches a hand. Walls are left to the device only if it closes them.
/// Then nothing, held by the device or closed by the host, is stiffer or harder than the device can hold. Walls are
/// moved no more often than the device's link carries them. `viscosity_Ns_per_m`: need of the device's corridors
/// (Viscosity.h).
[[nodiscard]] inline HapticParameters adaptToDevice(HapticParameters parameters, const DeviceInfo& device,
  const StabilityLimits& limits, double viscosity_Ns_per_m = 0.0) noexcept
{
  parameters.keepsHand = true;
  parameters.contact.seatsBySide = true;
  parameters.passivity.enabled = parameters.passivity.enabled && device.rendersForce;
  if (parameters.velocity.resolution_m == 0.0)
  {
    parameters.velocity.resolution_m = device.resolution_m.value;
  }
  parameters.mechanismTurning_N_m_per_rad =
    device.rendersTorque || device.heldTurning_N_m_per_rad > 0.0
      ? std::max(parameters.mechanismTurning_N_m_per_rad, device.heldTurning_N_m_per_rad)
      : 0.0;
  parameters.turnResolution_rad = device.turnResolution_rad.value;
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
