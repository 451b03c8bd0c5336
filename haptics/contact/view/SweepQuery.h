// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "haptics/contact/view/GodObjectState.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/core/Types.h"

namespace palpate
{

/// A ball of radius r on its way from x to e.
struct SweepQuery
{
  Vec3 from_W = Vec3::Zero();
  Vec3 to_W = Vec3::Zero();
  double radius_u = 0.0;
  Resolution resolution;
  std::span<const ActiveFeature> touched; ///< not hit again: their planes already hold the ball
};

/// A straight way with nothing touched, resolved as its ends are.
[[nodiscard]] inline SweepQuery straightQuery(const Vec3& from_W, const Vec3& to_W, double radius_u = 0.0) noexcept
{
  SweepQuery query{ from_W, to_W, radius_u, {}, {} };
  query.resolution.include(from_W);
  query.resolution.include(to_W);
  return query;
}

/// The first contact, if any.
struct SweepHit
{
  bool hit = false;
  double t = 1.0; ///< fraction of the way, in [0, 1]
  ActiveFeature feature;
  double freeUntil = 1.0; ///< below 1 only when the budget was met: proven free up to here
  std::uint32_t work = 0; ///< done, in the unit of ContactPlan::workBudget
};

} // namespace palpate
