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
/// least four runs. A run stays within its bound of the segment that stands for it, so two of them can change which
/// side of each other they are on only where they come nearer than the sum of their bounds; there both are halved until
/// that is over, in the end down to the segments they were given as. So curves cross and touch where they did, in the
/// same points, and nowhere else, and no gap opens, in the plane as in space.
///
/// Exempt is what makes no more than a pocket that nobody feels: runs of a chain that has not left the distance
/// 2 limit_u between them, as noise does that is larger than its steps, need only not cross or touch by what stands for
/// them. Runs that share an end are not compared: what stands for them is straight, so it meets there alone, or one
/// lies on the other where they set out in exactly one direction.
///
/// What bends by more than limit_u stays as it is; points on a straight way go, however far apart. Finite points,
/// indices below their number; any thread; deterministic; O(n log n) where few runs come near each other.
[[nodiscard]] CoarserCurves coarsestWithin(std::span<const Vec3> points_W,
  std::span<const std::array<std::uint32_t, 2>> segments, double limit_u, const std::stop_token& stop = {});

} // namespace palpate
