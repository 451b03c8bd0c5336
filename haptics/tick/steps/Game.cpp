// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Game.h"

#include <algorithm>

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

constexpr double deviceLoop_s = 1e-3; // of a device that closes walls itself

bool isAskedFor(std::span<const HapticEvent> events) noexcept
{
  return std::any_of(events.begin(), events.end(), [](const HapticEvent& e) { return e.kind == EventKind::Play; });
}

void tellGame(TickContext& tick) noexcept
{
  tick.out.state.game = tick.s.game.phase;
  tick.out.state.gameTime_s = tick.s.game.time_s;
}

} // namespace

void GameLead::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  GameTick now;
  now.hand_D = tick.input.sample.pose_D.p;
  now.velocity_D = tick.out.state.velocity_D;
  now.start_D = tick.p.map.toDevice(tick.p.game.start_W);
  now.stiffness_N_per_m = tick.p.stiffnessLimit_N_per_m * tick.out.state.stiffnessFactor;
  now.engaged = s.engage == EngageState::Engaged && tick.touchable();
  now.again = isAskedFor(tick.input.events);
  now.dt_s = tick.input.dt_s;
  now.loop_s = tick.p.walls.hold ? deviceLoop_s : tick.input.dt_s;
  tick.game = lead(tick.p.game, now, s.game);
  if (tick.game.seat)
  {
    s.contact = GodObjectState{};
    s.contact.x_W = s.contact.device_W = tick.p.game.start_W;
    s.contact.placed = true;
  }
}

void GameArrival::step(TickContext& tick) noexcept
{
  HapticState& state = tick.out.state;
  const Vec3 shake_D = arrive(tick.p.game, state.proxy_W.p, tick.input.dt_s, tick.s.game);
  tellGame(tick);
  if (tick.p.walls.hold && state.game == GamePhase::Arrived)
  {
    tick.out.command.signal = Signal::Oscillation;
  }
  if (tick.game.walls < 1.0)
  {
    state.rendered_D = tick.game.walls * state.rendered_D + tick.game.lead_D;
  }
  state.rendered_D += shake_D;
}

void GameArrival::rest(TickContext& tick) noexcept
{
  tellGame(tick);
}

} // namespace palpate::stage
