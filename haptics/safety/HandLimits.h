// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "haptics/core/Fault.h"

namespace palpate
{

/// Limits beyond the motion of any hand and the energy of any wall. Beyond them the force ends until the person engages
/// again.
struct HandLimits
{
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  double speed_m_per_s = unlimited; ///< of the hand while there is a force: a workspace radius in 50 ms
  double excess_J = unlimited;      ///< energy beyond the stored energy of the touched spring: five times 5 mJ for a
                                    ///< device of 3 N
};

/// The speed cut and the energy latch. `force_N`: on the hand in the last tick; without a force no speed is too fast.
/// Pure; real-time safe.
[[nodiscard]] constexpr Fault judgeHand(
  const HandLimits& limits, double speed_m_per_s, double force_N, double excess_J) noexcept
{
  if (force_N > 0.0 && speed_m_per_s > limits.speed_m_per_s)
  {
    return Fault::VelocityCut;
  }
  return excess_J > limits.excess_J ? Fault::EnergyLatch : Fault::None;
}

/// Those of a device, from its workspace radius [m] and its largest force [N]; an unknown value sets no limit.
[[nodiscard]] constexpr HandLimits handLimits(double workspaceRadius_m, double maxForce_N) noexcept
{
  constexpr double radiusWithin_s = 0.05;
  constexpr double allowance_J_per_N = 5.0 * 5e-3 / 3.0; // J per N of the device's largest force
  return { workspaceRadius_m > 0.0 ? workspaceRadius_m / radiusWithin_s : HandLimits::unlimited,
    allowance_J_per_N * maxForce_N };
}

} // namespace palpate
