// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "haptics/core/DeviceInfo.h"
#include "haptics/force/PassivityController.h"

namespace palpate
{

/// Which of the limits decides.
enum class StiffnessLimit : std::uint8_t
{
  None,    ///< nothing is known of the device, or no force reaches a hand
  Device,  ///< the largest stiffness the device is made for
  Loop,    ///< the sampled loop itself: mass, damping, rate, delay
  Turning, ///< likewise of the turns of a tool: inertia, damping, and the lever between turns and displacements
};

/// How stiff a wall a device can hold at a rate. All in N/m; infinity where nothing limits.
struct StabilityLimits
{
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  /// b / (T/2 + delay) less |B|: passive in any hand (Colgate & Schenkel 1997), without controller.
  double passive_N_per_m = unlimited;
  /// 2 c / D: friction dissipates the energy of the encoder's steps (Abbott & Okamura 2005).
  double quantised_N_per_m = unlimited;
  /// Exact eigenvalues of the loop without a hand on the device.
  double stable_N_per_m = unlimited;
  double device_N_per_m = unlimited;
  /// For rotation, referred to the tool's lever arm: eigenvalues of the loop of its inertia. Times the lever's square
  /// it is in N m/rad.
  double turning_N_per_m = unlimited;
  /// Limit of the coupling: a share of the stable stiffnesses, never above the device's own.
  double largest_N_per_m = unlimited;
  StiffnessLimit decides = StiffnessLimit::None;
  /// Force of one encoder step at the largest stiffness [N]; 0 if the step is not known.
  double grain_N = 0.0;
};

/// Parameters of a loop.
struct LoopSettings
{
  double period_s = 1e-3;
  double damping_Ns_per_m = 0.0; ///< B of the coupling
  PassivityPlan passivity;
  double lever_m = 0.0; ///< of a tool: a turn of 1 rad is felt as such a displacement is; 0: nothing turns

  friend bool operator==(const LoopSettings&, const LoopSettings&) = default;
};

/// From the description of the device, at a period, with a damping and a passivity plan. Where the device's link takes
/// longer for a force than that period, the period is the link's. Without the controller the loop is taken as in a
/// light hand (200 N/m, 2 N s/m, 20 g; 0.5 N m/rad, 5 mN m s, 5e-5 kg m2): many devices have so little damping of their
/// own that nothing but the hand keeps a wall still. Not real-time safe.
[[nodiscard]] StabilityLimits stabilityLimits(const DeviceInfo& device, const LoopSettings& loop);

/// One sentence: how stiff, and why.
[[nodiscard]] std::string describe(const StabilityLimits& limits, const DeviceInfo& device, const LoopSettings& loop);

} // namespace palpate
