// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "haptics/core/Types.h"

namespace palpate
{

/// One touched plane seen from the ball: the displacement y must satisfy n . y >= bound.
struct PlaneRow
{
  Vec3 n;       ///< unit, towards the ball
  double bound; ///< [u]
};

/// The point of the feasible set nearest to the target, and its active planes.
struct ProjectionResult
{
  Vec3 y = Vec3::Zero();
  int count = 0;                  ///< active rows, at most 3 (Caratheodory for the normal cone in 3-D)
  std::array<int, 3> active{};    ///< indices into the rows given
  std::array<double, 3> lambda{}; ///< multipliers, all >= 0: y - q = sum lambda_i n_i
  int sets = 0;                   ///< pairs and triples of rows that were tried
  bool feasible = true;
};

/// argmin |y - q|^2 subject to n_i . y >= bound_i: free point, then single planes, pairs, triples.
/// Exact to rounding, also for duplicate, redundant and near-parallel planes; the result does not depend, bit for
/// bit, on the order of the rows. `slack` >= 0 [u] is how far a row may be violated by rounding.
/// Allocation-free, bounded: O(n^3) for n rows; of more than 48 the first 48 count.
[[nodiscard]] ProjectionResult projectOntoPlanes(std::span<const PlaneRow> rows, const Vec3& q, double slack) noexcept;

} // namespace palpate
