// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/mechanism/servo/WireInHand.h"

#include "haptics/mechanism/wire/WirePlan.h"

namespace palpate
{

void stepWire(const MechanismInput& input, WireTick& ticks, MechanismState& state, MechanismResult& result) noexcept
{
  const WirePlan& plan = *input.plan->wire;
  WireInput asked;
  asked.plan = &plan;
  asked.hand_W = input.hand_W;
  asked.coupling_N_per_u = input.grip.coupling_N_per_u;
  asked.turning_Nu_per_rad = input.grip.turning_Nu_per_rad;
  asked.turnBy_rad = input.turnBy_rad;
  asked.budget = input.wireBudget;
  ticks.restore(state.wire);
  const WireResult& wire = ticks.step(asked);
  state.wire = ticks.state();
  state.pose_W[input.plan->held] = { wire.tip_W, plan.mouth_W.q };
  state.tip_W = wire.tip_W;
  state.placed = true;
  state.capped = wire.capped;
  result = {};
  result.wrench_W = result.exact_W = wire.wrench_W;
  result.stored_Nu = wire.stored_Nu;
  result.work = wire.work;
  result.capped = wire.capped;
  result.residual_u = wire.residual_u;
  result.pose_W = state.pose_W;
  result.wire = wire;
}

} // namespace palpate
