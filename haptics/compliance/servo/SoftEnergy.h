// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/compliance/servo/SoftSurfaceRef.h"

namespace palpate
{

/// Elastic energy that the hand has put in [N u]: of the bodies by their snapshots, of the springs below the patches
/// and of the coupling K [N/u], under the forces of the contacts. A snapshot's own energy is that of the state it was
/// made at; the way from there follows from its compliance.
[[nodiscard]] double storedEnergy(
  std::span<const SoftSurfaceRef> soft, const SoftState& state, double coupling_N_per_u) noexcept;

/// How much of the force may be bent so that a hand gets back no more than it gave.
struct EnergyBalancePlan
{
  double share = 0.05;        ///< of the force; .15 where snapshots are late
  double slew_N = 0.02;       ///< most change a tick
  double leastStep_u = 20e-6; ///< a hand that moves less in a tick is asked for as much less
};

struct EnergyBalance
{
  double taken_Nu = 0.0; ///< from the hand, since contact began
  double added_N = 0.0;  ///< along the force
};

/// Correction of one tick along the force [N]: more where the hand goes in, less where it comes out, while more is
/// stored than was taken. `step_u`: of the hand against the force, > 0: in; `felt_N`: the force on the hand in this
/// step, `force_N`: the force without correction. Begins anew where there is no force. After Hannaford & Ryu (2002),
/// with the energy that is stored known, so that it sees a gain while it arises.
[[nodiscard]] double balanceEnergy(const EnergyBalancePlan& plan, double stored_Nu, double step_u, double felt_N,
  double force_N, EnergyBalance& balance) noexcept;

} // namespace palpate
