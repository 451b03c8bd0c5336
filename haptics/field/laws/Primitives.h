// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "haptics/core/Types.h"

namespace palpate
{

enum class PrimitiveKind : std::uint8_t
{
  Point,   ///< pulls to its anchor
  Line,    ///< pulls to the line through its anchor along its axis
  Plane,   ///< pushes along its axis out of the half space behind its anchor
  Directed ///< the same force everywhere, along its axis
};

/// A pull that is limited by a strength: the proxy stays at the anchor while that needs no more (Lundin et al. 2002).
struct Primitive
{
  PrimitiveKind kind = PrimitiveKind::Point;
  double strength_N = 0.0;
  Vec3 anchor = Vec3::Zero(); ///< [u]
  Vec3 axis = Vec3::UnitX();  ///< unit
};

struct PrimitiveSolution
{
  static constexpr int mostPrimitives = 8;

  Vec3 x = Vec3::Zero();                     ///< [u]
  std::array<Vec3, mostPrimitives> pull_N{}; ///< of each primitive, in the order given
  double error_u = 0.0; ///< x is certainly no further than this from the solution; 0 where it is solved to rounding
  int rounds = 0;
};

/// argmin k/2 |x - device|^2 + sum of strength times distance over all primitives, which is convex and has one answer:
/// where the spring of the hand and all pulls balance. Rounds over the pulls guess which primitives hold, slide or are
/// slack, Newton's steps on the equations of that guess finish; a guess counts only if no pull exceeds its strength.
/// Where no guess does within the bounded work, the duality gap of the best answer bounds its error. Of more than eight
/// the first eight count. k: `stiffness_N_per_u` > 0.
[[nodiscard]] PrimitiveSolution solvePrimitives(
  std::span<const Primitive> primitives, const Vec3& device, double stiffness_N_per_u) noexcept;

} // namespace palpate
