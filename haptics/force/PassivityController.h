// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace palpate
{

/// How much a held force may be damped so that it gives back no more than it took.
struct PassivityPlan
{
  bool enabled = false;
  double delay_ticks = 0.0; ///< delay between command and effect in addition to the zero-order hold
  double reserve = 0.5;     ///< damping of the spring that is followed, in units of K T
  double repay = 1.0;       ///< most damping that repays energy, in units of K T

  friend bool operator==(const PassivityPlan&, const PassivityPlan&) = default;
};

/// Energy of the held force, measured as it was: force of the last period times the hand's displacement in it, which is
/// exact for a zero-order hold (Hannaford & Ryu 2002). The force must be the one the hand really got.
struct EnergyMeter
{
  double delivered_J = 0.0; ///< net work on the hand since the start; negative: taken from it
  double absorbed_J = 0.0;  ///< taken from the hand in this contact and not yet given back
  double excess_J = 0.0;    ///< by how much the contact has given more than its spring holds, now
  double peakExcess_J = 0.0;
  double stiffness_N_per_m = 0.0; ///< of the last tick
  bool touching = false;
};

/// Input of the controller in one tick.
struct SpringTick
{
  double stretch_m = 0.0;      ///< |proxy - device|, 0: free
  double inward_m_per_s = 0.0; ///< speed of the hand along the spring, positive: deeper
  double stiffness_N_per_m = 0.0;
  double work_J = 0.0; ///< of the held force on the hand since the last tick
  double dt_s = 1e-3;
  bool restart = false; ///< the force was not the spring's own (limits, ramps, another scene): nothing to compare with
};

/// Enters the work of the last period and compares with the energy V = K s^2 / 2 the spring holds. Energy that was
/// taken beyond V (a damper's share) is no credit for later: else long friction would mask an active contact.
void measureEnergy(const SpringTick& tick, EnergyMeter& meter) noexcept;

/// Damping [N s/m] along the spring, to be added to the coupling, >= 0.
///
/// One-tick prediction: a held spring misses K v T / 2 of the force of the true one, which is the leak K v T p of the
/// held spring. That much is added from the start, (1/2 + delay) K T. A reserve makes the spring that is followed a
/// dissipative one. A remaining excess is repaid while the hand moves, E / (v^2 T) as in the passivity controller of
/// Hannaford & Ryu (2002), but bounded, so that no speed near zero and no encoder step makes a pulse. Free space: 0, by
/// construction no drag. Real-time safe.
[[nodiscard]] double stabilisingDamping(
  const PassivityPlan& plan, const SpringTick& tick, const EnergyMeter& meter) noexcept;

} // namespace palpate
