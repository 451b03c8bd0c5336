// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Protect.h"

#include "haptics/safety/ForceLimits.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// A rendered force or torque as far as it is let through: no larger than `largest`, growing no faster than `rise` a
/// second, a number.
Vec3 limited(TickContext& tick, const Vec3& rendered, const Vec3& last, double largest, double rise) noexcept
{
  HapticState& state = tick.out.state;
  const Vec3 through = smoothstep(tick.s.gain) * (tick.homeless() ? Vec3(Vec3::Zero()) : rendered);
  const Vec3 clamped = clampMagnitude(through, largest);
  const Vec3 given = limitRise(clamped, last, rise, tick.input.dt_s);
  state.clamped = state.clamped || clamped != through;
  state.riseLimited = state.riseLimited || given != clamped;
  if (!given.allFinite())
  {
    tick.latch(Fault::NonFiniteSample);
    return Vec3::Zero();
  }
  return given;
}

void limitForce(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  HapticState& state = tick.out.state;
  const SafetyLimits& limits = tick.p.safety;
  state.force_D = limited(tick, state.rendered_D, s.lastForce_D, limits.maxForce_N, limits.maxRise_N_per_s);
  const bool clamped = state.clamped;
  state.torque_D =
    limited(tick, state.renderedTorque_D, s.lastTorque_D, limits.maxTorque_Nm, limits.maxTorqueRise_Nm_per_s);
  // That a device without torque gives none is no news.
  state.clamped = limits.maxTorque_Nm > 0.0 ? state.clamped : clamped;
  const bool ownTorque = limits.maxTorque_Nm == 0.0 || state.torque_D == state.renderedTorque_D;
  s.ownForce = state.force_D == tick.coupled_D && ownTorque;
  tick.out.command.wrench_D = { state.force_D, state.torque_D };
}

/// Where a spring of this tick's stiffness gives just this force from.
void aim(TickContext& tick) noexcept
{
  const HapticState& state = tick.out.state;
  PoseTarget& target = tick.out.command.target;
  target.pose_D = tick.input.sample.pose_D;
  if (!state.deviceHolds && state.stiffness_N_per_m > 0.0)
  {
    target.stiffness_N_per_m = state.stiffness_N_per_m;
    target.pose_D.p += state.force_D / state.stiffness_N_per_m;
  }
}

/// The torque of the tick before acted while the hand turned to where it is now.
void meterTurning(TickContext& tick) noexcept
{
  tick.s.turned_J += tick.turn_D ? tick.s.lastTorque_D.dot(*tick.turn_D) : 0.0;
  tick.out.state.turned_J = tick.s.turned_J;
}

/// Force of the command's walls and viscosity on a hand at the sample [N].
Vec3 heldForce(const TickContext& tick) noexcept
{
  const DeviceCommand& held = tick.out.command;
  return forceOfWalls(held, tick.input.sample.pose_D.p) - held.viscosity_Ns_per_m * tick.out.state.velocity_D;
}

/// The device's own force, as far as the host knows: that of its walls at rest. Walls that are not numbers are not
/// sent. Energy is not metered: the force that is told is a spring's, a function of the place, and gives no energy over
/// a closed path whatever the device really does.
void tellHeld(TickContext& tick) noexcept
{
  HapticState& state = tick.out.state;
  const Vec3 held_D = heldForce(tick);
  const Vec3 force_D = clampMagnitude(held_D, tick.p.safety.maxForce_N);
  state.clamped = force_D != held_D;
  const bool usable = isFinite(tick.out.command) && force_D.allFinite();
  if (!usable)
  {
    tick.s.walls = {};
    tick.out.command.wallCount = 0;
    tick.out.command.viscosity_Ns_per_m = 0.0;
    tick.latch(Fault::NonFiniteSample);
  }
  state.force_D = usable ? force_D : Vec3(Vec3::Zero());
  state.walls = tick.out.command.wallCount;
  tick.s.ownForce = false;
}

} // namespace

void Protect::step(TickContext& tick) noexcept
{
  HapticState& state = tick.out.state;
  meterTurning(tick);
  state.deviceHolds ? tellHeld(tick) : limitForce(tick);
  aim(tick);
  state.force_W = tick.p.map.directionToScene(state.force_D);
  tick.s.lastForce_D = state.force_D;
  tick.s.lastTorque_D = state.torque_D;
}

void Protect::rest(TickContext& tick) noexcept
{
  tick.s.lastForce_D = tick.s.lastTorque_D = Vec3::Zero();
  tick.out.state.turned_J = tick.s.turned_J;
  tick.s.ownForce = false;
}

} // namespace palpate::stage
