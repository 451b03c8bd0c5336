// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// A polyline with fewer points and how far it is from the one it came from.
struct SimplifiedCurve
{
  std::vector<std::uint32_t> kept; ///< indices of the points that stay, ascending
  double error_u = 0.0;            ///< Hausdorff distance of both polylines [u]: no more than this, no more than asked
};

/// How far the point is from the closed segment [u].
[[nodiscard]] double distanceToSegment(const Vec3& p_W, const Vec3& a_W, const Vec3& b_W) noexcept;

/// Leaves out points after Douglas & Peucker 1973 as long as every one left out is within tolerance_u >= 0 of the
/// segment that stands for it. That bounds the distance both ways: the distance to a segment is convex, so whatever
/// lies between two such points is as near, and the nearest points run without a gap from one end of the segment to the
/// other. Ends stay; a curve whose first point is its last keeps the point farthest from it as well. The distance is to
/// the segment and not to its line, so that a curve that turns back keeps its tip.
/// O(n log n) as a rule, O(n^2) at worst. The curve must be finite; fewer than three points are returned as they are.
[[nodiscard]] SimplifiedCurve simplify(std::span<const Vec3> points_W, double tolerance_u);

} // namespace palpate
