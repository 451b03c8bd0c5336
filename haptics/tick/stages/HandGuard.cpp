// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/HandGuard.h"

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{

void HandGuard::step(TickContext& tick) noexcept
{
  const HapticState& state = tick.out.state;
  tick.latch(judgeHand(tick.p.safety.hand, state.velocity_D.norm(), tick.s.lastForce_D.norm(), state.energy.excess_J));
}

} // namespace palpate::stage
