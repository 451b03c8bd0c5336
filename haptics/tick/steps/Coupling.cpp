// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Coupling.h"

#include <cmath>

#include "haptics/force/VirtualCoupling.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// A torque that the device cannot give counts as if it were given: a person who turns a tool against it brings that
/// energy along, and the force returns it from there, not from the contact.
double turningWork_J(const TickContext& tick) noexcept
{
  const Vec3& torque_D = tick.s.ownForce ? tick.s.toolTorque_D : tick.s.lastTorque_D;
  return tick.turn.lever_m > 0.0 && tick.turn_D ? torque_D.dot(*tick.turn_D) : 0.0;
}

/// Force and torque of the spring with that damping.
Wrench coupled_D(const TickContext& tick, double damping_Ns_per_m) noexcept
{
  const HapticState& state = tick.out.state;
  if (tick.turn.lever_m == 0.0)
  {
    return { coupleDevice(tick.pull_D, state.velocity_D, state.stiffness_N_per_m, damping_Ns_per_m), Vec3::Zero() };
  }
  Vec6 pull, velocity;
  pull << tick.pull_D, tick.turn.pull_D;
  velocity << state.velocity_D, tick.turn.velocity_D;
  const Vec6 push = coupleAlong(pull, velocity, state.stiffness_N_per_m, damping_Ns_per_m);
  return { push.head<3>(), tick.turn.lever_m * push.tail<3>() };
}

/// Motion and work of the hand in the period that ended, under the force that was given.
SpringTick springTick(const TickContext& tick) noexcept
{
  const RendererState& s = tick.s;
  const HapticState& state = tick.out.state;
  SpringTick spring;
  const double pull_m = std::sqrt(tick.pull_D.squaredNorm() + tick.turn.pull_D.squaredNorm());
  spring.stretch_m = tick.stretch_m;
  const double towards = tick.pull_D.dot(state.velocity_D) + tick.turn.pull_D.dot(tick.turn.velocity_D);
  spring.inward_m_per_s = pull_m > 0.0 ? -towards / pull_m : 0.0;
  spring.stiffness_N_per_m = state.stiffness_N_per_m;
  const Vec3 contact_D = s.ownForce ? Vec3(s.lastForce_D - s.besideContact_D) : s.lastForce_D;
  spring.work_J = (tick.way_D ? contact_D.dot(*tick.way_D) : 0.0) + turningWork_J(tick);
  spring.dt_s = tick.input.dt_s;
  spring.restart = !s.ownForce || tick.scene.replaced || tick.knownChanged;
  return spring;
}

} // namespace

void Coupling::step(TickContext& tick) noexcept
{
  HapticState& state = tick.out.state;
  const double damping_Ns_per_m = tick.p.damping_Ns_per_m;
  const Wrench plain_D = coupled_D(tick, damping_Ns_per_m);
  const SpringTick spring = springTick(tick);
  measureEnergy(spring, tick.s.energy);
  state.energy = tick.s.energy;
  const double more_Ns_per_m = stabilisingDamping(tick.p.passivity, spring, tick.s.energy);
  const Wrench wrench_D = more_Ns_per_m == 0.0 ? plain_D : coupled_D(tick, damping_Ns_per_m + more_Ns_per_m);
  state.rendered_D = wrench_D.force;
  state.renderedTorque_D = tick.s.toolTorque_D = wrench_D.torque;
  state.stabiliser_D = wrench_D.force - plain_D.force;
  tick.coupled_D = state.rendered_D;
  tick.s.besideContact_D = Vec3::Zero(); // the stages that follow add theirs
}

void Coupling::rest(TickContext& tick) noexcept
{
  tick.s.besideContact_D = Vec3::Zero();
}

} // namespace palpate::stage
