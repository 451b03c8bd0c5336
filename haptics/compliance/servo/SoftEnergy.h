// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/SoftSurfaceRef.h"

namespace palpate
{

/// Elastic energy that the hand has put in [N u]: in the bodies by their snapshots, in the springs below the patches
/// and in the coupling K [N/u], under the forces of the contacts. A snapshot's own energy is that of its state;
/// the change since then follows from its compliance.
[[nodiscard]] double storedEnergy(
  std::span<const SoftSurfaceRef> soft, const SoftState& state, double coupling_N_per_u) noexcept;

/// Limits of the correction by which a hand gets back no more energy than it gave.
struct EnergyBalancePlan
{
  double share = 0.05;        ///< of the force; .15 where snapshots are late
  double slew_N = 0.02;       ///< largest change per tick
  double leastStep_u = 20e-6; ///< a smaller motion in a tick reduces the correction in proportion
};

struct EnergyBalance
{
  double taken_Nu = 0.0; ///< from the hand, since contact began
  double added_N = 0.0;  ///< correction along the force
};

/// Correction of one tick along the force [N]: positive where the hand goes in, negative where it comes out, while more
/// is stored than was taken. `step_u`: motion of the hand against the force, > 0: in; `felt_N`: the force on the hand
/// in this step, `force_N`: the force without correction. Begins anew where there is no force. After Hannaford & Ryu
/// (2002), with the stored energy known, so that a gain is seen while it arises.
[[nodiscard]] double balanceEnergy(const EnergyBalancePlan& plan, double stored_Nu, double step_u, double felt_N,
  double force_N, EnergyBalance& balance) noexcept;

} // namespace palpate
