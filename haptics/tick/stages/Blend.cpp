// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Blend.h"

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{

void Blend::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  HapticState& state = tick.out.state;
  const double blend_s = tick.p.sceneBlend_s;
  const bool tool = tick.input.tool != nullptr;
  const bool body = tick.input.body != nullptr;
  const bool blends =
    tick.scene.replaced || (tick.otherMap && tick.p.keepsHand) || tool != s.blendTool || body != s.blendBody;
  s.blendTool = tool;
  s.blendBody = body;
  if (blends && !tick.scene.first && blend_s > 0.0)
  {
    s.blend_D += s.lastRendered_D - state.rendered_D;
    s.blendTorque_D += s.lastRenderedTorque_D - state.renderedTorque_D;
  }
  else
  {
    const double left = blend_s > 0.0 ? blend_s / (blend_s + tick.input.dt_s) : 0.0;
    s.blend_D *= left;
    s.blendTorque_D *= left;
  }
  s.lastRendered_D = state.rendered_D;
  s.lastRenderedTorque_D = state.renderedTorque_D;
  state.rendered_D += s.blend_D;
  state.renderedTorque_D += s.blendTorque_D;
}

} // namespace palpate::stage
