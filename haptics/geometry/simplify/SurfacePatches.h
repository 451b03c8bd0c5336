// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// Connected parts of a surface, spread over all of it: trials on them predict the result for the surface.
struct SurfacePatches
{
  TriangleMesh mesh;                    ///< of the triangles of all parts, with only their vertices
  std::vector<std::uint32_t> triangles; ///< of the surface
  std::vector<std::uint32_t> vertices;  ///< of the surface, for each vertex of `mesh`
  std::vector<bool> rim;                ///< of `mesh`: vertices that also have triangles outside the parts
};

/// Up to `count` parts of up to `size` triangles each, grown over vertices from triangles that stand evenly in the
/// tree's order, which are dense where the surface is fine. No triangle twice. Any thread; O(surface) in memory only.
[[nodiscard]] SurfacePatches patchesOf(const SurfaceTree& surface, std::size_t count, std::size_t size);

} // namespace palpate
