// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/Friction.h"
#include "haptics/contact/Tick.h"

namespace palpate
{

/// A ball in the air first lands; where it lands friction decides what becomes of the rest of the way. One that slid in
/// the last tick slides on, if its surface was replaced by other triangles it has to land on first.
template<class SceneView>
ContactResult moveUnderFriction(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  FrictionVerdict verdict = judgeFriction(scene, plan, p_W, state);
  ContactResult landing;
  if (verdict.motion == FrictionMotion::None)
  {
    landing = Tick(scene, plan, p_W, state, sink).run(true);
    if (state.count == 0 || landing.capped || landing.overBudget || landing.infeasible)
    {
      state.slips = false;
      return landing;
    }
    verdict = judgeFriction(scene, plan, p_W, state);
    state.slips = verdict.motion == FrictionMotion::Slips;
  }
  if (verdict.motion == FrictionMotion::Sticks && Tick(scene, plan, p_W, state, sink).wayIsFree())
  {
    state.count = 0; // it stands beside what seems to hold it
    return Tick(scene, plan, p_W, state, sink).run();
  }
  ContactResult result;
  result.proxy_W = state.x_W;
  result.held = verdict.held;
  result.heldCount = result.contacts = verdict.contacts;
  if (verdict.motion != FrictionMotion::Sticks)
  {
    result = Tick(scene, plan, verdict.pulled_W, state, sink).run();
    if (state.count == 0)
    {
      result = Tick(scene, plan, p_W, state, sink).run(); // it left the surface: nothing drags any more
    }
  }
  result.friction = verdict.motion;
  result.passes += landing.passes;
  result.sweeps += landing.sweeps;
  result.nodes += landing.nodes;
  return result;
}

/// The tick without shading.
template<class SceneView>
ContactResult moveUnshaded(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  return frictionMatters(scene, plan) ? moveUnderFriction(scene, plan, p_W, state, sink)
                                      : Tick(scene, plan, p_W, state, sink).run();
}

} // namespace palpate
