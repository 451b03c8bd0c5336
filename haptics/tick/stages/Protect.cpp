// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Protect.h"

#include "haptics/safety/ForceLimits.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

void limitForce(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  HapticState& state = tick.out.state;
  const SafetyLimits& limits = tick.p.safety;
  Vec3 force = smoothstep(s.gain) * (tick.seatFailed ? Vec3(Vec3::Zero()) : state.rendered_D);
  const Vec3 clamped = clampMagnitude(force, limits.maxForce_N);
  state.clamped = clamped != force;
  force = limitRise(clamped, s.lastForce_D, limits.maxRise_N_per_s, tick.input.dt_s);
  state.riseLimited = force != clamped;
  if (!force.allFinite())
  {
    force = Vec3::Zero();
    tick.latch(Fault::NonFiniteSample);
  }
  s.ownForce = force == tick.coupled_D;
  state.force_D = force;
  tick.out.command.wrench_D.force = force;
}

/// What walls and viscosity of the command give a hand where it is [N].
Vec3 heldForce(const TickContext& tick) noexcept
{
  const DeviceCommand& held = tick.out.command;
  return forceOfWalls(held, tick.input.sample.pose_D.p) - held.viscosity_Ns_per_m * tick.out.state.velocity_D;
}

/// What the device gives by itself, as far as the host knows: what its walls give at rest. Walls that are not numbers
/// are not sent. Energy is not metered: the force that is told is a spring's, a function of the place, and gives
/// nothing over a closed way whatever the device really does.
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
  state.deviceHolds ? tellHeld(tick) : limitForce(tick);
  state.force_W = tick.p.map.directionToScene(state.force_D);
  tick.s.lastForce_D = state.force_D;
}

void Protect::rest(TickContext& tick) noexcept
{
  tick.s.lastForce_D = Vec3::Zero();
  tick.s.ownForce = false;
}

} // namespace palpate::stage
