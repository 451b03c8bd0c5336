// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// Each edge of the triangles once, as two numbers of vertices in order.
[[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> edgesOf(const TriangleMesh& mesh);

/// The vertices of a closed surface, each a little inside of it. So faces that lie in one plane and vertices that
/// coincide with those of another body are in no special place: the edges between these vertices run in the body, and
/// each of their points that lies in another body is a point of both. `share`: of
/// the shortest edge at a vertex, that the vertex moves by. A vertex without an outer side stays. Sizes as vertices_W
/// [u].
[[nodiscard]] std::vector<Vec3> verticesInside(const TriangleMesh& mesh, double share);

} // namespace palpate
