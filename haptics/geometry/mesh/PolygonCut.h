// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// Result for a polygon. A polygon whose triangles are not all of it would let a hand through.
struct PolygonCut
{
  std::size_t holeEdges = 0; ///< edges round an unfilled part, because a corner is not finite; 0: filled
  bool lasts = true; ///< false: corners in one place may part and self-intersections may open, so cut it anew then
};

/// "2 holes of 5 and 7 edges: ...", for a person; "" of none. `holeEdges`: as cutPolygon() gave them.
[[nodiscard]] std::string describeHoles(const std::vector<std::size_t>& holeEdges);

/// Cuts a polygon into triangles, whatever its shape: concave, touching or crossing itself, with holes by keyholes,
/// with corners on a line or in one place, flat or not. Appends a surface to `triangles`, as numbers of vertices, with
/// the polygon's own edges as its border: an edge that the polygon passes an even number of times is none, and corners
/// in one place are one. So a mesh that was closed stays closed. Where the polygon, seen along its largest coordinate
/// of area, does not cross itself, its triangles cover its inside once (constrained Delaunay triangulation, Chew 1989);
/// elsewhere ears are cut, one after the other, which always ends, and may leave folds. Some triangles may have no
/// area, which cleaning drops. They run round as the polygon does. `corners`: numbers of vertices, each below
/// vertices_W.size(); fewer than three are nothing. Throws nothing but std::bad_alloc. O(n log n); O(n^2) to O(n^3) for
/// ears, bounded.
PolygonCut cutPolygon(const std::vector<Vec3>& vertices_W, std::span<const std::uint32_t> corners,
  std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace palpate
