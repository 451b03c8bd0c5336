// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace palpate
{

/// What the hand is protected by. The defaults are 60 % of a device's force, reached in
/// 20 ms or more, and a ramp of 1 s from a small force; forces of a device without a known maximum
/// are limited as if it had 5 N.
struct SafetyLimits
{
  double maxForce_N = 3.0;
  double maxRise_N_per_s = 150.0; ///< growth only: release is always free
  double engageRamp_s = 1.0;
  double engageBelow_N = 0.3; ///< engages only from a force this small
  double releaseRamp_s = 0.05;
  double faultRamp_s = 0.01;
  bool needsEngage = true; ///< false: a program's own path, engaged from the first tick

  /// No device, no hand: the headless tick.
  [[nodiscard]] static SafetyLimits none() noexcept
  {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    return { unlimited, unlimited, 0.0, unlimited, 0.0, 0.0, false };
  }

  /// Limits for a device that can give maxForce_N: 60 % of it, reached in no less than 20 ms (S1, S2).
  [[nodiscard]] static SafetyLimits forDevice(double deviceMaxForce_N) noexcept
  {
    SafetyLimits limits;
    if (deviceMaxForce_N < std::numeric_limits<double>::infinity())
    {
      limits.maxForce_N = 0.6 * deviceMaxForce_N;
      limits.maxRise_N_per_s = 50.0 * deviceMaxForce_N;
      limits.engageBelow_N = 0.1 * deviceMaxForce_N;
    }
    return limits;
  }
};

} // namespace palpate
