// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Blend.h"

#include <algorithm>

#include "haptics/core/Fade.h"
#include "haptics/tick/TickContext.h"

namespace palpate::stage
{
namespace
{

/// The person breaks it, and its force is gone at once.
bool breaksConstraint(const TickContext& tick) noexcept
{
  return std::any_of(tick.input.events.begin(), tick.input.events.end(),
    [](const HapticEvent& event) { return event.kind == EventKind::BreakConstraint; });
}

} // namespace

void Blend::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  HapticState& state = tick.out.state;
  const double blend_s = tick.p.sceneBlend_s;
  const bool tool = tick.touchesByMesh();
  const double ball_u = tick.input.tool != nullptr ? tick.input.tool->ball_u : 0.0;
  const bool body = tick.input.body != nullptr;
  const std::uint64_t mechanism = tick.input.mechanism != nullptr ? tick.input.mechanism->plan().revision : 0;
  const bool otherHeld = tool != s.blendTool || ball_u != s.blendBall_u || body != s.blendBody;
  const bool otherTouched =
    tick.scene.replaced || tick.knownChanged || (tick.otherMap && tick.p.keepsHand) || otherHeld;
  const bool otherConstraints = mechanism != s.blendMechanism || breaksConstraint(tick); // with a scene or without any
  s.blendTool = tool;
  s.blendBall_u = ball_u;
  s.blendBody = body;
  s.blendMechanism = mechanism;
  if (((otherTouched && !tick.scene.first) || otherConstraints) && blend_s > 0.0)
  {
    s.blend_D += s.lastRendered_D - state.rendered_D;
    s.blendTorque_D += s.lastRenderedTorque_D - state.renderedTorque_D;
  }
  else
  {
    const double left = Fade{ blend_s }.implicitShare(tick.input.dt_s);
    s.blend_D *= left;
    s.blendTorque_D *= left;
  }
  s.lastRendered_D = state.rendered_D;
  s.lastRenderedTorque_D = state.renderedTorque_D;
  state.rendered_D += s.blend_D;
  state.renderedTorque_D += s.blendTorque_D;
}

} // namespace palpate::stage
