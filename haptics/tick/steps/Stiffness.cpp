// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/tick/stages/Stiffness.h"

#include <algorithm>

#include "haptics/tick/TickContext.h"

namespace palpate::stage
{

void Stiffness::step(TickContext& tick) noexcept
{
  const Plan& p = tick.p;
  HapticState& state = tick.out.state;
  state.stiffnessFactor = tick.input.lateness.stiffnessFactor;
  state.stiffnessLimited = p.stiffness_N_per_m > p.stiffnessLimit_N_per_m;
  state.stiffness_N_per_m =
    std::min(p.stiffness_N_per_m, p.stiffnessLimit_N_per_m) * state.stiffnessFactor / tick.springs();
  tick.contact.coupling_N_per_m = state.stiffness_N_per_m;
}

} // namespace palpate::stage
