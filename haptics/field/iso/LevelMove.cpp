// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/field/iso/LevelMove.h"

#include <algorithm>
#include <cmath>

#include "haptics/field/iso/FieldSweep.h"

namespace palpate
{
namespace
{

constexpr double fairShare = 0.125; ///< of what a level wanted to go: with less it is on its way to a halt
constexpr int mostHalvings = 12, mostClimbs = 3;
constexpr double leastShare = 1e-3; ///< of what is left: where the gradient is small the level moves all the same
constexpr double steeper = 1.1;     ///< a surface may come that much faster than its slope says, and by rounding

/// True if rounding cannot deny that a place is on its side.
bool isFree(const LevelSet& set, const GridPlace& at) noexcept
{
  const std::optional<GridPlace> place = set.field.within(at);
  if (!place)
  {
    return false;
  }
  const TrilinearCell cell = set.cell(place->cell);
  return cell.value(place->t) >= landingMargin(cell);
}

/// As far as the surface may come without meeting a proxy that nothing holds: that moves nothing that is felt.
double levelBefore(const LevelSet& set, const GridPlace& x) noexcept
{
  const std::optional<GridPlace> place = set.field.within(x);
  if (!place)
  {
    return set.level;
  }
  const TrilinearCell cell = set.cell(place->cell);
  return set.level + set.side * std::max(0.0, cell.value(place->t) - 2.0 * landingMargin(cell));
}

/// Climbs the field from a place that is free at the old level until it is free at the new one, no further than
/// `most_u`. The ways are free at the old level, so the old surface is not passed.
bool climb(const LevelSet& before, const LevelSet& now, const Vec3& spacing_u, double most_u, GridPlace& x,
  FieldPathSink* sink) noexcept
{
  GridPlace at = x;
  for (int i = 0; i <= mostClimbs; ++i)
  {
    const std::optional<GridPlace> place = now.field.within(at);
    if (!place)
    {
      return false;
    }
    const TrilinearCell cell = now.cell(place->cell);
    const double value = cell.value(place->t);
    if (value >= landingMargin(cell))
    {
      x = at;
      return true;
    }
    const Vec3 gradient = cell.gradient(place->t).cwiseQuotient(spacing_u);
    const double rise_u = 2.0 * landingMargin(cell) / gradient.norm() - value / gradient.norm();
    if (!(rise_u <= most_u) || i == mostClimbs)
    {
      return false;
    }
    most_u -= rise_u;
    const Vec3 way = (rise_u * gradient.normalized()).cwiseQuotient(spacing_u);
    const FieldSweepResult swept = sweepField(before, *place, way);
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

/// How far the level may go in one tick: as far as moves the surface by the plan's way.
double mostChange(const LevelSet& set, const Vec3& spacing_u, const IsoPlan& plan, const GridPlace& x) noexcept
{
  const std::optional<GridPlace> place = set.field.within(x);
  if (!place || plan.scrub_u == 0.0)
  {
    return std::fabs(plan.level - set.level);
  }
  const TrilinearCell cell = set.cell(place->cell);
  const double slope = cell.gradient(place->t).cwiseQuotient(spacing_u).norm();
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

bool moveLevel(const BrickComponent& field, const Vec3& spacing_u, const IsoPlan& plan, IsoState& state,
  FieldPathSink* sink) noexcept
{
  if (state.level == plan.level)
  {
    return outlasts(state, true);
  }
  LevelSet before{ field, state.level, state.side };
  LevelSet now{ field, plan.level, state.side };
  const bool touches = state.count > 0;
  if (!touches && isFree(now, state.x))
  {
    state.level = plan.level; // nothing is held, and the new surface does not reach the hand
    return true;
  }
  before.level = state.level = touches ? state.level : levelBefore(before, state.x);
  const double most = mostChange(before, spacing_u, plan, state.x);
  const double wanted = std::clamp(plan.level - state.level, -most, most);
  double change = wanted;
  const double most_u = steeper * (plan.scrub_u > 0.0 ? plan.scrub_u : spacing_u.minCoeff());
  for (int i = 0; i <= mostHalvings; ++i, change *= 0.5)
  {
    now.level = std::fabs(change) == std::fabs(plan.level - state.level) ? plan.level : state.level + change;
    if (climb(before, now, spacing_u, most_u, state.x, sink))
    {
      state.level = now.level;
      state.catchingUp = true;
      return outlasts(state, std::fabs(change) >= fairShare * std::fabs(wanted));
    }
  }
  return outlasts(state, false);
}

} // namespace palpate
