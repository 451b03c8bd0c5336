// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// The order in which CGAL's AABB tree of the mesh stores its triangles: each half of a node is contiguous, the left
/// one with floor(n / 2) triangles. `threads`: from 2 on the two halves of the root are ordered at the same time, with
/// the same result. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> hierarchyOrder(const TriangleMesh& mesh, unsigned threads);

} // namespace palpate
