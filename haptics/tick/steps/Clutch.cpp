// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Clutch.h"

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{

void Clutch::step(TickContext& tick) noexcept
{
  RendererState& s = tick.s;
  Pose& device_W = tick.out.state.device_W;
  tick.handBefore_W = s.known ? s.hand_W.p : device_W.p;
  if (tick.p.clutch && s.known)
  {
    device_W = s.hand_W;
  }
  s.hand_W = device_W;
  s.known = true;
}

} // namespace palpate::stage
