// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "haptics/geometry/simplify/SimplifyLimits.h"
#include "haptics/geometry/tree/SurfaceTree.h"

namespace palpate
{

/// A surface with fewer triangles that nobody can tell from the first, or one sentence why there is none.
struct Simplification
{
  std::shared_ptr<const SurfaceTree> tree; ///< null when refused
  double bound_u = 0.0;                    ///< proven: no point of either is further from the other, <= the limit
  std::string refusal;
};

/// Collapses edges onto one of their ends in the order of Garland & Heckbert's quadrics (1997), as long as every vertex
/// that was removed stays near its replacement. Then the result is proven: all points of both surfaces lie within the
/// limit of the other one (SurfaceDistance), and the new surface crosses itself nowhere but where the first one does,
/// with the same triangles (exact predicates). Every vertex is one of the original's. Sheets closer together than twice
/// the limit are left as they are, so that they cannot merge, and so are the triangles at edges of three or more.
///
/// Refused are a surface that cannot be proven, curves, and a surface that would not lose half of its triangles, which
/// a sample of the surface says first. Where triangles are so fine that looking for other sheets would take too long, a
/// smaller limit is kept. Work in proportion to the triangles, and to a constant where the sample refuses. Any thread
/// but the servo's; deterministic.
[[nodiscard]] Simplification simplifyWithin(const SurfaceTree& surface, const SimplifyLimits& limits);

} // namespace palpate
