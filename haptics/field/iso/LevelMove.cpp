// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/LevelMove.h"

#include <algorithm>
#include <cmath>

#include "haptics/field/iso/LevelSet.h"

namespace palpate
{
namespace
{

constexpr double fairShare = 0.125; ///< of the wanted change of the level: with less the level is coming to a halt
constexpr int mostHalvings = 12, mostClimbs = 3;
constexpr double leastShare = 1e-3; ///< of the rest: where the gradient is small the level moves all the same
constexpr double steeper = 1.1;     ///< a surface may come that much faster than its slope says, and by rounding

/// As far as the surface may come without meeting a proxy that nothing holds: that moves nothing that is felt.
double levelBefore(const IsoSpace& space, const IsoSide& set, const GridPlace& x) noexcept
{
  const std::optional<GridPlace> place = space.within(x);
  if (!place)
  {
    return set.level;
  }
  const TrilinearCell cell = space.cell(place->cell, set);
  return set.level + set.side * std::max(0.0, cell.value(place->t) - 2.0 * landingMargin(cell));
}

/// Climbs the field from a place that is free at the old level until it is free at the new one, no further than
/// `most_u`. The displacements are free at the old level, so the old surface is not passed.
bool climb(const IsoSpace& space, const IsoSide& before, const IsoSide& now, double most_u, GridPlace& x,
  FieldPathSink* sink) noexcept
{
  GridPlace at = x;
  for (int i = 0; i <= mostClimbs; ++i)
  {
    const std::optional<GridPlace> place = space.within(at);
    if (!place)
    {
      return false;
    }
    const TrilinearCell cell = space.cell(place->cell, now);
    const double value = cell.value(place->t);
    if (value >= landingMargin(cell))
    {
      x = at;
      return true;
    }
    const Vec3 gradient = space.gradient_u(cell, *place);
    const double rise_u = 2.0 * landingMargin(cell) / gradient.norm() - value / gradient.norm();
    if (!(rise_u <= most_u) || i == mostClimbs)
    {
      return false;
    }
    most_u -= rise_u;
    const FieldSweepResult swept = space.sweep(before, *place, rise_u * gradient.normalized());
    if (swept.end != SweepEnd::Reached)
    {
      return false;
    }
    if (sink != nullptr)
    {
      sink->piece(*place, swept.place, before.level, before.side);
    }
    at = swept.place;
  }
  return false;
}

/// How far the level may go in one tick: as far as moves the surface by the plan's displacement.
double mostChange(const IsoSpace& space, const IsoSide& set, const IsoPlan& plan, const GridPlace& x) noexcept
{
  const std::optional<GridPlace> place = space.within(x);
  if (!place || plan.scrub_u == 0.0)
  {
    return std::fabs(plan.level - set.level);
  }
  const TrilinearCell cell = space.cell(place->cell, set);
  const double slope = space.gradient_u(cell, *place).norm();
  return std::max(slope * plan.scrub_u, leastShare * std::fabs(plan.level - set.level));
}

/// Counts the ticks in which the level could not go as it wanted; false once the surface has vanished.
bool outlasts(IsoState& state, bool moved) noexcept
{
  if (!moved)
  {
    ++state.stuck;
  }
  else if (state.stuck > 0)
  {
    --state.stuck;
  }
  return state.stuck < IsoState::mostStuck;
}

} // namespace

bool moveLevel(const IsoSpace& space, const IsoPlan& plan, IsoState& state, FieldPathSink* sink) noexcept
{
  if (state.level == plan.level)
  {
    return outlasts(state, true);
  }
  IsoSide before{ state.level, state.side };
  IsoSide now{ plan.level, state.side };
  const bool touches = state.count > 0;
  if (!touches && space.isFree(now, state.x))
  {
    state.level = plan.level; // no contact, and the new surface does not reach the hand
    return true;
  }
  before.level = state.level = touches ? state.level : levelBefore(space, before, state.x);
  const double most = mostChange(space, before, plan, state.x);
  const double wanted = std::clamp(plan.level - state.level, -most, most);
  double change = wanted;
  const double most_u = steeper * (plan.scrub_u > 0.0 ? plan.scrub_u : space.least_u(state.x));
  for (int i = 0; i <= mostHalvings; ++i, change *= 0.5)
  {
    now.level = std::fabs(change) == std::fabs(plan.level - state.level) ? plan.level : state.level + change;
    if (climb(space, before, now, most_u, state.x, sink))
    {
      state.level = now.level;
      state.catchingUp = true;
      return outlasts(state, std::fabs(change) >= fairShare * std::fabs(wanted));
    }
  }
  return outlasts(state, false);
}

} // namespace palpate
