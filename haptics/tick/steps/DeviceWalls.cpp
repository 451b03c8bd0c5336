// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/DeviceWalls.h"

#include <algorithm>
#include <numbers>

#include "haptics/safety/ForceLimits.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

void giveWalls(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  HapticState& state = tick.out.state;
  DeviceCommand& told = tick.out.command;
  const SafetyLimits& limits = tick.p.safety;
  const WallTick now{ *tick.input.scene, tick.contact, s.contact, tick.p.map, tick.input.sample.pose_D.p,
    state.stiffness_N_per_m, limits.maxRise_N_per_s, tick.input.dt_s, tick.input.scene->shareAt(s.sceneAge_s) };
  state.work += keepWalls(tick.p.walls, now, s.walls);
  const double share = smoothstep(s.gain);
  const double stiffness_N_per_m = heldStiffness(share * state.stiffness_N_per_m, now, s.walls);
  command(s.walls.walls, stiffness_N_per_m, told, limits.maxForce_N);
  told.viscosity_Ns_per_m = share * tick.p.walls.viscosity_Ns_per_m;
  rampLimits(now, s.walls, told);
}

/// Opposite walls at one place are the spring of the lead.
void giveLead(TickContext& tick) noexcept
{
  const double share = smoothstep(tick.s.gain);
  const Vec3& drawn_D = tick.s.game.drawn_D;
  tick.s.walls = {};
  AxisWalls walls;
  for (int i = 0; i < AxisWalls::count; ++i)
  {
    walls.offset_m[static_cast<std::size_t>(i)] = AxisWalls::direction(i).dot(drawn_D);
  }
  command(walls, share * tick.game.spring_N_per_m, tick.out.command,
    std::min(std::numbers::sqrt2 * share * tick.game.spring_N, tick.p.safety.maxForce_N)); // along an axis all of it
  tick.out.command.viscosity_Ns_per_m = share * tick.game.damping_Ns_per_m;
}

} // namespace

void DeviceWalls::step(TickContext& tick) noexcept
{
  const bool touches = tick.touchable() && !tick.homeless() && tick.holdsBall() && tick.input.tool == nullptr;
  tick.out.state.deviceHolds = tick.p.walls.hold && touches && tick.s.gain > 0.0;
  if (!tick.out.state.deviceHolds)
  {
    tick.s.walls = {};
    return;
  }
  tick.game.walls < 1.0 ? giveLead(tick) : giveWalls(tick);
}

void DeviceWalls::rest(TickContext& tick) noexcept
{
  tick.s.walls = {};
}

} // namespace palpate::stage
