// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "haptics/field/FieldBlock.h"
#include "haptics/field/LevelBounds.h"

namespace palpate
{

/// Levels of a scalar that hold the hand: at equal distances, or at chosen values.
struct DetentPlan
{
  static constexpr std::size_t mostLevels = 16;

  double strength_N = 0.0;  ///< largest force of a smooth detent where the slope is `slope_per_u`; that a click holds
  double origin = 0.0;      ///< a level
  double spacing = 1.0;     ///< from level to level, in values
  double slope_per_u = 1.0; ///< usual gradient of the scalar
  bool click = false;       ///< levels hold until their strength and then let go; else they are hollows of a potential
  std::int32_t levelCount = 0;                ///< of chosen levels; 0: they are at equal distances
  std::array<double, mostLevels> levels = {}; ///< that are chosen, rising; a hollow is as wide as `spacing`, at most as
                                              ///< two levels are apart
  LevelBounds bounds = {}; ///< of all of the data, whichever block is felt: they limit the strength of smooth levels
};

/// Sets the chosen levels from numbers between commas or blanks, in any order; none: equal distances. Empty, or one
/// sentence why they cannot be, and nothing is changed.
[[nodiscard]] std::string setLevels(DetentPlan& plan, std::string_view text);
/// Empty, or one sentence why these levels cannot be.
[[nodiscard]] std::string refuseLevels(const DetentPlan& plan);

/// A potential of the scalar whose hollows are the levels, even beyond those that are chosen, with its derivatives by
/// the scalar. A polynomial of the fourth degree across a hollow, with continuous slope, and at equal distances with
/// continuous second derivatives: nothing of the mathematical library, so the same bits everywhere.
struct DetentEnergy
{
  double energy = 0.0; ///< [N u]
  double slope = 0.0;
  double bend = 0.0;
};
[[nodiscard]] DetentEnergy detentEnergy(const DetentPlan& plan, double value) noexcept;

/// The largest strength with which hollows hold a hand smoothly on a spring of stiffness k. A strength s gives the
/// potential a slope of at most s / usual and a bend of at most 32 A / width^2 by the value, for a height of A = s
/// width / (3.08 usual); in space its least second derivative is therefore not below -(32 A |grad f|^2 / width^2 +
/// |f''| s / usual). The spring's k is to exceed that by a tenth everywhere: then there is one place of balance for
/// each place of the hand, the force has a potential, and no closed path loses. With more the hand jumps from level to
/// level, and loses. By the plan's bounds; 0 where they are infinite.
[[nodiscard]] double mostSmooth_N(const DetentPlan& plan, double stiffness_N_per_u) noexcept;

/// The largest force of smooth hollows on that spring: they hold with the strength, at most mostSmooth_N(), where the
/// gradient is usual, and the force grows with the gradient. Infinite where the steepest gradient is unknown.
[[nodiscard]] double mostFelt_N(const DetentPlan& plan, double stiffness_N_per_u) noexcept;

/// argmin k/2 |x - p|^2 + E(f(x)): the hand's spring against the potential, f without creases, sought from where the
/// proxy was. Takes no work over closed paths up to mostSmooth_N(). p_W itself where there is no value.
[[nodiscard]] Vec3 smoothDetent(const FieldBlock& brick, const DetentPlan& plan, double stiffness_N_per_u,
  const Vec3& p_W, const Vec3& from_W) noexcept;

/// The level between a proxy and its hand: the next one above or below the proxy's value, `above` if the hand is at
/// more. Beyond the last of chosen levels a value that no data have.
[[nodiscard]] double nextLevel(const DetentPlan& plan, double proxyValue, bool above) noexcept;

} // namespace palpate
