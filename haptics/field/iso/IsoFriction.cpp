// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/IsoFriction.h"

#include "haptics/field/iso/IsoRows.h"

namespace palpate
{

IsoFriction judgeIsoFriction(
  const IsoSpace& space, const FrictionPlan& friction, const Vec3& q_u, IsoState& state) noexcept
{
  IsoFriction verdict;
  const IsoSide of{ state.level, state.side };
  const IsoView view{ space, of, state.x, q_u };
  IsoRows rows = rowsAt(view, { state.cells.data(), static_cast<std::size_t>(state.count) });
  const ProjectionResult free = projectOntoRows(rows, q_u, {}, slackOf(view));
  if (friction.none() || free.count == 0 || !free.feasible)
  {
    state.slips = false;
    return verdict;
  }
  const double depth_u = free.lambda[0] + free.lambda[1] + free.lambda[2], behind_u = free.y.norm();
  constexpr double rounding = 1e-9; // of a slide: a hand that keeps still is not to slide for ever
  const double held_u = state.slips ? (1.0 + rounding) * friction.kinetic * depth_u : friction.statical * depth_u;
  state.slips = behind_u > held_u;
  verdict.sticks = !state.slips;
  if (state.slips)
  {
    verdict.shift_u = -(friction.kinetic * depth_u / behind_u) * free.y;
  }
  return verdict;
}

} // namespace palpate
