// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/forces/Coupling.h"

#include "haptics/force/VirtualCoupling.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// What the hand did in the period that ended, under the force it really got.
SpringTick springTick(const TickContext& tick) noexcept
{
  const RendererState& s = tick.s;
  const HapticState& state = tick.out.state;
  SpringTick spring;
  const double pull_m = tick.pull_D.norm();
  spring.stretch_m = tick.stretch_m;
  spring.inward_m_per_s = pull_m > 0.0 ? -tick.pull_D.dot(state.velocity_D) / pull_m : 0.0;
  spring.stiffness_N_per_m = state.stiffness_N_per_m;
  const Vec3 contact_D = s.ownForce ? Vec3(s.lastForce_D - s.besideContact_D) : s.lastForce_D;
  spring.work_J = tick.way_D ? contact_D.dot(*tick.way_D) : 0.0;
  spring.dt_s = tick.input.dt_s;
  spring.restart = !s.ownForce || tick.scene.replaced;
  return spring;
}

} // namespace

void Coupling::step(TickContext& tick) noexcept
{
  HapticState& state = tick.out.state;
  const double damping_Ns_per_m = tick.p.damping_Ns_per_m;
  const auto coupled_D = [&tick, &state](double damping)
  { return coupleDevice(tick.pull_D, state.velocity_D, state.stiffness_N_per_m, damping); };
  const Vec3 plain_D = coupled_D(damping_Ns_per_m);
  const SpringTick spring = springTick(tick);
  measureEnergy(spring, tick.s.energy);
  state.energy = tick.s.energy;
  const double more_Ns_per_m = stabilisingDamping(tick.p.passivity, spring, tick.s.energy);
  state.rendered_D = more_Ns_per_m == 0.0 ? plain_D : coupled_D(damping_Ns_per_m + more_Ns_per_m);
  state.stabiliser_D = state.rendered_D - plain_D;
  tick.coupled_D = state.rendered_D;
  tick.s.besideContact_D = Vec3::Zero(); // the stages that follow add theirs
}

void Coupling::rest(TickContext& tick) noexcept
{
  tick.s.besideContact_D = Vec3::Zero();
}

} // namespace palpate::stage
