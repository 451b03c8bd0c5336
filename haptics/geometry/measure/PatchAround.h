// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// Triangles that have a point within `radius_u` of a place and that the triangle nearest to the place reaches over
/// edges of such triangles: the far wall of a thin plate is not among them. The nearest comes first; none if it is
/// further away. Vertices at one place count as one; triangles without finite corners are passed over. O(n log n).
[[nodiscard]] std::vector<std::uint32_t> patchAround(const TriangleMesh& mesh, const Vec3& centre_W, double radius_u);

} // namespace palpate
