// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "haptics/core/Types.h"
#include "haptics/geometry/simplify/Simplification.h"

namespace palpate
{

/// Curves too fine for the passes of a tick: a hand that presses a curve goes on to the next segment once a pass.
struct FineLines
{
  double below_u = 0.0;  ///< a segment is fine if it is shorter [u]
  std::size_t least = 0; ///< so many of them are worth a coarser curve
};

/// Whether at least fine.least segments of the curves are fine. `plane_WP`: given for walls that stand across that
/// plane. O(segments), and no longer than until enough are counted.
[[nodiscard]] bool hasFineLines(const SurfaceTree& curves, const std::optional<Pose>& plane_WP, const FineLines& fine);

/// Curves at the coarsest level that nobody can tell from them (coarsestWithin()), as a surface: tubes, or walls, which
/// stand no lower than before and no lower than wallHalfHeight() would have them. Proven is the place of the curves,
/// not their direction: noise that is larger than the steps between its points is steep and holds a hand that slides;
/// the coarser level does not. One sentence where fewer than `leastGone` > 0 segments could go. Any thread but the
/// servo's.
[[nodiscard]] Simplification coarserSurface(
  const SurfaceTree& curves, const std::optional<Pose>& plane_WP, std::size_t leastGone, const SimplifyLimits& limits);

} // namespace palpate
