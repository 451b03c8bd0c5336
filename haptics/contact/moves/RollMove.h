// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "haptics/contact/moves/TickState.h"
#include "haptics/contact/planes/Roll.h"

namespace palpate
{

/// True if the ball would lie deeper than rounding in a touched feature, which sweeps leave out.
template<SceneView AnyScene>
[[nodiscard]] bool wouldOverlap(const TickState<AnyScene>& tick, const Vec3& end_W) noexcept
{
  for (const ActiveFeature& f : tick.contacts.features())
  {
    const bool under = f.kind != FeatureKind::Face || projectsInside(tick.contacts.surface(f), f.a, end_W, 0.0);
    if (under && planeOf(tick.contacts.surface(f), f, end_W, tick.plan.radius_u).gap < -tick.tol())
    {
      return true;
    }
  }
  return false;
}

/// Takes the way over the corner if that way ends nearer to the device.
template<SceneView AnyScene>
[[nodiscard]] bool commitRoll(
  TickState<AnyScene>& tick, const Vec3& corner_W, const Vec3& end_W, const SweepHit& hit, double tolerance_u2) noexcept
{
  if (wouldOverlap(tick, corner_W) || wouldOverlap(tick, end_W))
  {
    return false;
  }
  if ((end_W - tick.p_W).squaredNorm() >= (tick.x() - tick.p_W).squaredNorm() + tolerance_u2)
  {
    return false;
  }
  tick.moveOver(corner_W, end_W);
  tick.touch(hit);
  return true;
}

/// Goes the planned way as far as the way is free. `freeShare`: the free share of the way.
template<SceneView AnyScene>
[[nodiscard]] bool tryRoll(TickState<AnyScene>& tick, const RollPlan& plan, double& freeShare) noexcept
{
  const Vec3 corner_W = tick.x() + plan.first;
  Vec3 end_W = tick.x() + plan.second;
  const SweepHit first = tick.sweep(tick.x(), corner_W);
  freeShare = 0.5 * first.t;
  if (first.hit && first.t * plan.first.norm() <= tick.tol())
  {
    tick.contacts.add(first.feature); // it is touched already: the next projection takes it into account
    return true;
  }
  if (first.freeUntil < 1.0)
  {
    return false;
  }
  if (first.hit)
  {
    end_W = tick.x() + first.t * plan.first;
    return commitRoll(tick, end_W, end_W, first, 0.0);
  }
  const SweepHit second = tick.sweep(corner_W, end_W);
  freeShare = 0.5 + 0.5 * second.t;
  if (second.freeUntil < 1.0)
  {
    return false;
  }
  if (second.hit)
  {
    end_W = corner_W + second.t * (end_W - corner_W);
  }
  return commitRoll(tick, corner_W, end_W, second, plan.tolerance_u2);
}

/// Rolls the ball round an edge or a vertex if that brings the ball nearer to the device; false: a plain slide is due.
/// Where a roll gains nothing, smaller ones are tried. The first of the smallest ends at the obstacle that the last
/// roll met: for a device as deep as the radius, a slide along the tangent would lead away from that obstacle and back
/// to where it began.
template<SceneView AnyScene>
[[nodiscard]] bool rollBall(TickState<AnyScene>& tick) noexcept
{
  // Tangents of the largest turn: half a right angle, so that a roll over a box's edge takes two, then a fifth of the
  // last. 0: follows from where the last one ended. Six plans bound the work of a pass.
  constexpr std::array largest = { 1.0, 0.2, 0.04, 0.0, 0.0, 0.0 };
  double turn = 2.0, freeShare = 1.0;
  for (const double most : largest)
  {
    const double mostTurn = most > 0.0 ? most : (freeShare < 1.0 ? freeShare : 0.2) * turn;
    if (mostTurn >= turn)
    {
      continue; // the last plan turned less than that already
    }
    tick.countFans();
    const RollPlan plan =
      RollPlanner<AnyScene>(tick.contacts, tick.x(), tick.p_W, tick.plan.radius_u, tick.solution, mostTurn).plan();
    tick.result.work += static_cast<std::uint32_t>(plan.sets) * work::planeSet;
    if (!plan.worthwhile)
    {
      return false;
    }
    if (tryRoll(tick, plan, freeShare))
    {
      return true;
    }
    turn = plan.turn;
  }
  return false;
}

} // namespace palpate
