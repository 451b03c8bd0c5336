// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "haptics/core/Types.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// A path over a surface, or one sentence why there is none.
struct SurfacePath
{
  std::vector<Vec3> points_W; ///< from the beginning to the end; straight between them, within one triangle each time
  double length_u = 0.0;
  std::string problem;
};

/// The shortest path over the triangles of a surface between its points nearest to two places; exact but for rounding
/// (Xin & Wang 2009, as CGAL has it). Before that, the shortest path along edges bounds which triangles can matter:
/// those that are no further from both places together. Seconds for 100 000 triangles that matter. Any thread.
[[nodiscard]] SurfacePath shortestPath(const SurfaceTree& surface, const Vec3& from_W, const Vec3& to_W);

} // namespace palpate
