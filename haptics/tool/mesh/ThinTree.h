// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"
#include "haptics/tool/mesh/BoxedMesh.h"

namespace palpate
{

/// A tree of oriented boxes around triangles.
struct ThinTree
{
  std::vector<BoxedMesh::Node> nodes;
  std::vector<std::uint32_t> order; ///< the triangle of the mesh that stands at each place of the tree
};

/// Large nodes are cut in two halves, small ones where the boxes of both parts are thinnest.
[[nodiscard]] ThinTree buildThinTree(const TriangleMesh& mesh);

} // namespace palpate
