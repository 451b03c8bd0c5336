// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Tool.h"

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// Where the hand would have the tool. After a clutch, and in another map, it takes it as it is turned then.
Pose lead(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  const bool anew = tick.otherMap || s.toolLoose;
  s.toolLoose = tick.p.clutch;
  return leadTool(tick.out.state.device_W, anew, s.toolLead);
}

/// The pull of the last tick's contacts now: none where the tool had no place, and that of the present contacts where
/// none are known, as in the first tick of a recording.
Vec6 pullBefore_u(const TickContext& tick, const ToolPull& now, const Pose& hand_W) noexcept
{
  const ToolContacts& was = tick.s.toolSet;
  const Vec6 unknown_u = was.held ? Vec6(Vec6::Zero()) : now.pull_u;
  return was.placed ? toolPull(was, hand_W, tick.p.toolCoupling, tick.p.contact.friction.kinetic).pull_u : unknown_u;
}

/// By how much the contacts of this tick change the pull of those before; they are kept for the next.
Vec6 step_u(TickContext& tick, const ToolPull& now, ToolState& tool) noexcept
{
  ToolContacts& was = tick.s.toolSet;
  const ToolContacts& set = *tick.input.tool;
  if (set.revision == was.revision)
  {
    return Vec6::Zero();
  }
  const Vec6 before_u = pullBefore_u(tick, now, tool.hand_W);
  const double scale = tick.p.map.scale_u_per_m;
  tool.injected_J =
    0.5 * tick.out.state.stiffness_N_per_m * (now.pull_u.squaredNorm() - before_u.squaredNorm()) / (scale * scale);
  was = set;
  return now.pull_u - before_u;
}

/// Of the newest contacts, whose step from those before is spread. Beyond the known part of a scene there are none.
Vec6 pull_u(TickContext& tick, ToolState& tool) noexcept
{
  if (!tick.input.tool->placed || tick.s.beyondKnown)
  {
    tick.s.toolSet = *tick.input.tool;
    tick.s.toolBlend = {}; // the force that it spread is gone
    return Vec6::Zero();
  }
  const double stiffness_N_per_u = tick.out.state.stiffness_N_per_m / tick.p.map.scale_u_per_m;
  const ToolPull now = toolPull(*tick.input.tool, tool.hand_W, tick.p.toolCoupling, tick.p.contact.friction.kinetic);
  tool.active = now.active;
  tool.presses = now.presses;
  return tick.s.toolBlend.blended(now.pull_u, step_u(tick, now, tool), stiffness_N_per_u, tick.input.dt_s);
}

/// The tool of this tick, where the hand had it last.
ToolState held(const TickContext& tick) noexcept
{
  const ToolContacts& set = *tick.input.tool;
  ToolState tool;
  tool.held = true;
  tool.placed = set.placed;
  tool.touching = static_cast<std::int32_t>(set.count);
  tool.hand_W = tick.s.toolHand_W;
  tool.ball_u = set.ball_u;
  tool.lever_m = set.ball_u > 0.0 ? 0.0 : set.characteristic_u / tick.p.map.scale_u_per_m;
  return tool;
}

void tell(const ToolContacts& set, const ToolState& tool, HapticState& state) noexcept
{
  state.tool = tool;
  state.contacts = tool.active;
  state.proxy_W = set.placed ? set.pose_W : tool.hand_W;
}

/// A tool that is a ball is where contact has moved it, turned as the hand turns it: its force goes through its middle,
/// where the hand is.
void followBall(TickContext& tick) noexcept
{
  HapticState& state = tick.out.state;
  ToolState tool = held(tick);
  tool.placed = tick.s.contact.placed;
  tool.touching = tool.active = state.tool.active;
  tool.presses = state.tool.presses;
  tick.s.toolSet = *tick.input.tool;
  tick.s.toolBlend = {};
  state.tool = tool;
  state.proxy_W.q = tool.hand_W.q;
}

/// A hand that takes a tool again takes it as its mesh was given.
void putDown(TickContext& tick) noexcept
{
  if (tick.s.toolLead.taken)
  {
    static_cast<Tool::State&>(tick.s) = Tool::State{};
  }
}

} // namespace

Vec3 Tool::turning_D(TickContext& tick, double lever_m) noexcept
{
  RendererState& s = tick.s;
  if (!tick.turn_D)
  {
    s.toolTurning.count = 0;
  }
  s.toolTurned_m += lever_m * tick.turn_D.value_or(Vec3::Zero());
  VelocityFilter filter = tick.p.velocity;
  filter.resolution_m = lever_m * tick.p.turnResolution_rad;
  return estimateVelocity(filter, s.toolTurned_m, tick.input.dt_s, s.toolTurning);
}

void Tool::step(TickContext& tick) noexcept
{
  if (tick.input.tool == nullptr)
  {
    putDown(tick);
    return;
  }
  const ToolContacts& set = *tick.input.tool;
  tick.s.toolHand_W = lead(tick);
  if (!tick.touchesByMesh())
  {
    followBall(tick);
    return;
  }
  ToolState tool = held(tick);
  const Vec6 pull_m = pull_u(tick, tool) / tick.p.map.scale_u_per_m;
  tick.pull_D = tick.p.map.directionToDevice(pull_m.head<3>());
  tick.turn = { tick.p.map.directionToDevice(pull_m.tail<3>()), turning_D(tick, tool.lever_m), tool.lever_m };
  tick.stretch_m = pull_m.norm();
  tick.toolWaits = tick.touchable() && !set.placed;
  tell(set, tool, tick.out.state);
}

void Tool::rest(TickContext& tick) noexcept
{
  tick.s.toolTurning.count = 0;
  tick.s.toolTorque_D = Vec3::Zero();
  if (tick.input.tool == nullptr)
  {
    return;
  }
  if (!tick.touchesByMesh())
  {
    tick.out.state.tool = held(tick);
    tick.out.state.proxy_W.q = tick.s.toolHand_W.q;
    return;
  }
  tell(*tick.input.tool, held(tick), tick.out.state);
}

} // namespace palpate::stage
