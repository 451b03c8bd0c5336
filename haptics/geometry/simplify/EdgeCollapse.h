// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "haptics/geometry/simplify/SimplifyLimits.h"

namespace palpate
{

/// The result after all allowed edge collapses.
struct CollapsedMesh
{
  TriangleMesh mesh; ///< with vertices that no triangle has, and equal ones where it was cut open: cleanMesh mends it
  std::size_t verticesGone = 0;
};

/// Collapses edges onto one of their ends in the order of Garland & Heckbert's quadrics (1997), as long as every vertex
/// and every middle of a triangle that went stays within the limit [u] of its replacement and no triangle turns over;
/// between those points nothing is watched. Vertices for which `fixed` (one a vertex) is true stay. Null when CGAL
/// cannot hold the surface. O(n log n) in its triangles. Any thread but the servo's; deterministic.
[[nodiscard]] std::optional<CollapsedMesh> collapseEdges(
  const TriangleMesh& surface, std::vector<bool> fixed, const SimplifyLimits& limits);

} // namespace palpate
