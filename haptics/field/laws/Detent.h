// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/field/Brick.h"

namespace palpate
{

/// Levels of a scalar at equal distances that hold the hand.
struct DetentPlan
{
  double strength_N = 0.0;  ///< largest force of a smooth detent where the slope is `slope_per_u`; that a click holds
  double origin = 0.0;      ///< a level
  double spacing = 1.0;     ///< from level to level, in values
  double slope_per_u = 1.0; ///< usual gradient of the scalar
  bool click = false;       ///< levels hold until their strength and then let go; else they are hollows of a potential
};

/// A periodic potential of the scalar whose hollows are the levels, with its derivatives by the scalar. A polynomial of
/// the fourth degree between two tops, with continuous second derivatives: nothing of the mathematical library, so the
/// same bits everywhere.
struct DetentEnergy
{
  double energy = 0.0; ///< [N u]
  double slope = 0.0;
  double bend = 0.0;
};
[[nodiscard]] DetentEnergy detentEnergy(const DetentPlan& plan, double value) noexcept;

/// argmin k/2 |x - p|^2 + E(f(x)), from where the proxy was: the hand's spring against the potential. Takes no work
/// over closed ways as long as 32 A (|grad f| / spacing)^2 < k, A being the height of the potential; above that it
/// snaps, and loses. p_W itself where there is no value.
[[nodiscard]] Vec3 smoothDetent(
  const Brick& brick, const DetentPlan& plan, double stiffness_N_per_u, const Vec3& p_W, const Vec3& from_W) noexcept;

/// The level between a proxy and its hand: the next one above or below the proxy's value, `above` if the hand is at
/// more.
[[nodiscard]] double nextLevel(const DetentPlan& plan, double proxyValue, bool above) noexcept;

} // namespace palpate
