// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Contact.h"

#include <algorithm>
#include <cmath>

#include "haptics/contact/view/Resolution.h"
#include "haptics/tick/BallPresses.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

Vec3 target_W(const TickContext& tick) noexcept
{
  const Vec3& p_W = tick.out.state.device_W.p;
  return tick.p.guide.on ? tick.p.guide.foot_W(p_W) : p_W;
}

/// The foot of a hand that moves across the plane stays but for rounding, and that is not a spring to be damped.
bool isRounding(const TickContext& tick, const ContactResult& result) noexcept
{
  Resolution resolution;
  resolution.include(result.proxy_W);
  resolution.include(tick.out.state.device_W.p);
  return tick.p.guide.on && result.pull_W.norm() <= resolution.tol();
}

void tell(const ProxyStep& moved, HapticState& state) noexcept
{
  const ContactResult& result = moved.contact;
  state.pinned = moved.pinned;
  state.proxy_W = { result.proxy_W, state.device_W.q };
  state.contacts = result.contacts;
  state.passes = result.passes;
  state.sweeps = result.sweeps;
  state.work = moved.carryWork + result.work;
  state.friction = result.friction;
  state.capped = result.capped;
  state.overBudget = result.overBudget;
  state.infeasible = result.infeasible;
}

/// The proxy where it is, until all is known around it again. In another scene it has no place: its contacts were of
/// the one before. Each snapshot of a soft body brings a scene that continues the one before.
void wait(TickContext& tick) noexcept
{
  GodObjectState& contact = tick.s.contact;
  const bool other = tick.input.body != nullptr ? tick.scene.replaced : tick.scene.changed;
  contact = other ? GodObjectState{} : contact;
  tick.out.state.proxy_W = tick.out.state.device_W;
  tick.out.state.proxy_W.p = contact.placed ? contact.x_W : tick.out.state.device_W.p;
}

/// How far the motion that a view shows has come. A soft body brings the motion along in a new scene with each
/// snapshot: a motion that has arrived once stays at its end.
void follow(const TickContext& tick, Contact::State& state) noexcept
{
  const bool same = tick.input.body != nullptr && tick.out.state.sceneRevision == state.sceneRevision;
  const double share = tick.input.scene != nullptr ? tick.input.scene->shareAt(tick.scene.age_s) : 1.0;
  state.shownAge_s = same ? state.shownAge_s + tick.input.dt_s : tick.scene.age_s;
  state.shownShare = same ? std::max(state.shownShare, share) : share;
}

/// The state that the next tick compares its scene with.
void remember(const TickContext& tick, Contact::State& state) noexcept
{
  follow(tick, state);
  state.sceneAge_s = tick.scene.age_s;
  state.sceneRevision = tick.out.state.sceneRevision;
  state.sceneGeometry = tick.input.scene != nullptr ? tick.input.scene->geometryHash() : 0;
}

} // namespace

bool Contact::feels(const TickContext& tick) noexcept
{
  return tick.touchable();
}

void Contact::step(TickContext& tick) noexcept
{
  const WorkspaceMap& map = tick.p.map;
  const bool touches = tick.touchable() && tick.game.contact && tick.holdsBall();
  tick.otherMap = !isSame(tick.s.map, map);
  const bool nearby = tick.p.keepsHand && isNearby(map, tick.handBefore_W, tick.out.state.device_W.p);
  const bool elsewhere = tick.otherMap && !nearby;
  tick.s.map = map;
  if (tick.s.beyondKnown)
  {
    tick.s.contact.placed = tick.s.contact.placed && !elsewhere;
    wait(tick);
    remember(tick, tick.s);
    return;
  }
  const ProxyTick now{ tick.input, tick.scene, tick.contact, tick.p.ballLead, elsewhere, touches, tick.sink };
  const ProxyStep moved = moveProxy(now, target_W(tick), tick.s);
  const ContactResult& result = moved.contact;
  tell(moved, tick.out.state);
  if (tick.input.tool != nullptr)
  {
    tellPresses(now, result, tick.s, tick.out.state.tool);
  }
  remember(tick, tick.s);
  tick.seatFailed = result.seatFailed;
  const double share = isRounding(tick, result) ? 0.0 : 1.0 / map.scale_u_per_m;
  tick.pull_D = map.directionToDevice(share * result.pull_W);
  tick.stretch_m = share * std::sqrt(result.held_u2);
}

void Contact::rest(TickContext& tick) noexcept
{
  tick.out.state.proxy_W.p = tick.s.contact.x_W;
}

} // namespace palpate::stage
