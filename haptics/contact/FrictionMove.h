// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/Friction.h"
#include "haptics/contact/Tick.h"

namespace palpate
{

/// So often is a slide that came too far to lie in its cone drawn on: after a step over a bend the planes are others
/// than those that friction was judged by. Where that does not converge the next tick goes on.
inline constexpr int mostSlides = 8;

/// The work of several runs is that of a tick.
inline void addWork(ContactResult& result, const ContactResult& before) noexcept
{
  result.passes += before.passes;
  result.sweeps += before.sweeps;
  result.nodes += before.nodes;
}

/// True if what seems to hold the ball is beside its way: then nothing drags.
template<class SceneView>
[[nodiscard]] bool standsBeside(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  Tick tick(scene, plan, p_W, state, sink);
  return tick.wayIsOpen() || tick.wayIsFree();
}

/// Follows the pull of friction until the god-object lies within the cone of the planes where it has come to.
template<class SceneView>
ContactResult slideUnderFriction(const SceneView& scene, const ContactPlan& plan, const Vec3& p_W,
  FrictionVerdict verdict, GodObjectState& state, PathSink* sink) noexcept
{
  ContactResult result;
  for (int slide = 0; slide < mostSlides; ++slide)
  {
    const ContactResult before = result;
    result = Tick(scene, plan, verdict.pulled_W, state, sink).run();
    addWork(result, before);
    if (state.count == 0 || Tick(scene, plan, p_W, state, sink).wayIsOpen())
    {
      const ContactResult left = result;
      state.count = 0;
      result = Tick(scene, plan, p_W, state, sink).run(); // it left the surface: nothing drags any more
      addWork(result, left);
      break;
    }
    if (result.capped || result.overBudget || result.infeasible)
    {
      break;
    }
    verdict = judgeFriction(scene, plan, p_W, state);
    if (!verdict.trailsTooFar)
    {
      break;
    }
  }
  state.slips = true;
  result.friction = FrictionMotion::Slips;
  return result;
}

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
  if (verdict.motion == FrictionMotion::Sticks && standsBeside(scene, plan, p_W, state, sink))
  {
    state.count = 0;
    return Tick(scene, plan, p_W, state, sink).run();
  }
  ContactResult result;
  if (verdict.motion == FrictionMotion::Slips)
  {
    result = slideUnderFriction(scene, plan, p_W, verdict, state, sink);
  }
  else if (verdict.motion == FrictionMotion::None)
  {
    result = Tick(scene, plan, p_W, state, sink).run();
  }
  else
  {
    result.proxy_W = state.x_W;
    result.held = verdict.held;
    result.heldCount = result.contacts = verdict.contacts;
    result.friction = FrictionMotion::Sticks;
  }
  addWork(result, landing);
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
