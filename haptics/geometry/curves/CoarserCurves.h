// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// Curves by fewer of their own points.
struct CoarserCurves
{
  std::vector<std::array<std::uint32_t, 2>> segments; ///< of the same points; none when stopped
  double bound_u = 0.0;                               ///< proven: no point of either is further from the other [u]
};

/// The coarsest choice of runs (MultiresolutionCurve) within limit_u >= 0 that changes nothing of how curves hang
/// together. Segments are joined to chains from one end or junction to the next; chains keep their ends and rings at
/// least four runs. A run stays within its bound of the segment that stands for it. So two runs can change sides
/// only where they come nearer than the sum of their bounds. There both are halved until they do not, in the end down
/// to the segments that were given. So curves cross and touch where they did, in the same points, and nowhere else, and
/// no gap opens, in the plane as in space.
///
/// Pockets too small to be felt are exempt. Between two runs the chain may stay within 2 limit_u, as noise larger than
/// its steps does: of such runs only the segments that stand for them may not cross or touch. Runs that share an end
/// are not compared: their segments are straight and meet there alone, or one segment lies on the other where both set
/// out in exactly one direction.
///
/// A run that bends by more than limit_u stays as it is; points on a straight line go, however far apart. Finite
/// points, indices below their number; any thread; deterministic; O(n log n) where few runs come near each other.
[[nodiscard]] CoarserCurves coarsestWithin(std::span<const Vec3> points_W,
  std::span<const std::array<std::uint32_t, 2>> segments, double limit_u, const std::stop_token& stop = {});

} // namespace palpate
