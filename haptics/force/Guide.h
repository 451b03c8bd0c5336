// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/core/Types.h"

namespace palpate
{

/// Leads a hand that moves in space to the plane of a plane world.
struct GuidePlan
{
  bool on = false;
  Vec3 point_W = Vec3::Zero();      ///< of the plane [u]
  Vec3 normal_W = Vec3::UnitZ();    ///< unit
  double stiffness_N_per_m = 200.0; ///< towards the plane
  double largest_N = 2.0;           ///< a hand that pushes harder leaves the plane
  double ramp_s = 0.5;              ///< from nothing to all of it, and back once it is switched off

  friend bool operator==(const GuidePlan&, const GuidePlan&) = default;

  /// The point of the plane below p_W.
  [[nodiscard]] Vec3 foot_W(const Vec3& p_W) const noexcept
  {
    return p_W - this->normal_W.dot(p_W - this->point_W) * this->normal_W;
  }
};

/// How much of a guide acts, 0..1, a tick later: up while it is on, down while it is not.
[[nodiscard]] double rampedShare(double share, bool on, double ramp_s, double dt_s) noexcept;

/// Force [N] along the unit normal of a guide whose plane is `height_m` below the hand, which leaves it with
/// `speed_m_per_s`. Within the limit a spring with the damping K T / 2 that a force held for a period T lacks (Colgate
/// & Schenkel 1997) and as much again, so that a device without damping comes to rest too: the least damping that
/// StabilityLimits counts with. Beyond it the limit: a potential, so that a closed path takes no work but the
/// damping's. Never pushes away from the plane. `share` scales stiffness and limit alike.
[[nodiscard]] double guideForce(
  const GuidePlan& plan, double share, double height_m, double speed_m_per_s, double dt_s) noexcept;

} // namespace palpate
