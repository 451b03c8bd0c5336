// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Hand.h"

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

void tellButtons(TickContext& tick) noexcept
{
  const DeviceSample& sample = tick.input.sample;
  tick.out.state.buttons = sample.buttons;
  tick.out.state.letGo = !isHeld(tick.p.safety.deadMan, sample.buttons, sample.grip);
}

/// A hand turns by far less than a radian in a tick, so twice the sine of half its angle is the angle.
Vec3 turnBetween(const Quat& before, const Quat& now) noexcept
{
  const Quat turn = now * before.conjugate();
  return turn.w() < 0.0 ? Vec3(-2.0 * turn.vec()) : Vec3(2.0 * turn.vec());
}

} // namespace

void Hand::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  HapticState& state = tick.out.state;
  const Pose& pose_D = tick.input.sample.pose_D;
  const double dt_s = tick.input.dt_s;
  state.frozen =
    s.tracked && s.watch.look(pose_D.p, s.lastP_D, s.lastForce_D.norm(), tick.p.safety.frozenAbove_N, dt_s);
  tellButtons(tick);
  if (state.letGo && s.engage == EngageState::Engaged)
  {
    s.engage = EngageState::Armed;
  }
  state.handle_D = pose_D.p;
  state.device_W = { tick.p.map.toScene(pose_D.p), tick.p.map.q_WD * pose_D.q };
  state.velocity_D = estimateVelocity(tick.p.velocity, pose_D.p, dt_s, s.velocity);
  if (s.tracked)
  {
    tick.way_D = pose_D.p - s.lastP_D;
    tick.turn_D = turnBetween(s.lastQ_D, pose_D.q);
  }
  s.lastP_D = pose_D.p;
  s.lastQ_D = pose_D.q;
  s.tracked = true;
}

void Hand::rest(TickContext& tick) noexcept
{
  tellButtons(tick);
  tick.s.velocity.count = 0;
  tick.s.tracked = false;
}

void HandGuard::step(TickContext& tick) noexcept
{
  const HapticState& state = tick.out.state;
  // A push is a source that the person asked for: it is in neither meter.
  const double excess_J = state.energy.excess_J + state.field.energy.excess_J;
  tick.latch(judgeHand(tick.p.safety.hand, state.velocity_D.norm(), tick.s.lastForce_D.norm(), excess_J));
}

} // namespace palpate::stage
