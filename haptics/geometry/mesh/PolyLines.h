// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// Curves in space as they come in: poly-lines by the numbers of their points. Nothing about them is trusted.
struct PolyLines
{
  std::vector<Vec3> points_W; ///< [u]
  std::vector<std::vector<std::uint32_t>> lines;
};

/// Each piece between two points of a line as the triangle (a, b, b), which is how curves share tree and query with
/// surfaces. A line of one point becomes (a, a, a), which cleanSegments() drops and counts.
[[nodiscard]] TriangleMesh segmentsOf(const PolyLines& curves);

/// Empty, or why curves of points up to `largest_u` from the origin cannot be touched as tubes of this radius [u]: it
/// must be finite, above 0, and not so thin that rounding of the points is felt.
[[nodiscard]] std::string refuseLineRadius(double radius_u, double largest_u);

} // namespace palpate
