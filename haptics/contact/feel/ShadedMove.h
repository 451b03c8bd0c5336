// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/feel/FrictionMove.h"
#include "haptics/contact/feel/Shading.h"

namespace palpate
{

/// The planes that hold the ball, for a device at p.
template<SceneView AnyScene>
void holdShaded(const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state,
  ContactResult& result) noexcept
{
  ContactSet<AnyScene> contacts(scene, plan.radius_u, state);
  contacts.include(p_W);
  contacts.relinearise();
  result.proxy_W = state.x_W;
  result.heldCount = result.contacts =
    listHeld(contacts, contacts.solve(p_W - state.x_W, contacts.lift()), result.held);
}

/// A few rounds bring the ball to where the shaded force is at rest; the next tick goes on from where they end.
template<SceneView AnyScene>
ContactResult moveShaded(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  constexpr int mostRounds = 4; // each is a whole run of the contact move
  ContactResult result;
  const auto add = [&result](ContactResult more)
  {
    more.passes += result.passes;
    more.sweeps += result.sweeps;
    more.work += result.work;
    result = more;
  };
  bool slipping = false, settled = false;
  for (int round = 0; round < mostRounds && !settled; ++round)
  {
    const ShadedStep step = judgeShading(scene, plan, p_W, slipping, state);
    slipping = step.motion == FrictionState::Slips;
    if (!step.touches)
    {
      add(moveUnshaded(scene, plan, p_W, state, sink));
    }
    else if (!step.rests)
    {
      add(FrictionlessMove(scene, plan, step.target_W, state, sink).run());
      result.friction = step.motion;
    }
    else
    {
      result.friction = step.motion;
    }
    settled = (step.touches ? step.rests : state.count == 0) || result.capped || result.overBudget;
  }
  holdShaded(scene, plan, p_W, state, result);
  return result;
}

} // namespace palpate
