// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate::test
{

/// A smooth random polyline in the plane z = 0: a sum of waves along a unit circle or arc, some of it fine.
[[nodiscard]] std::vector<Vec3> wavyLine(std::uint64_t seed, std::size_t points, bool ring);

/// The points at these indices.
[[nodiscard]] std::vector<Vec3> pick(const std::vector<Vec3>& points_W, const std::vector<std::uint32_t>& indices);

/// How far p is from the polyline [u]: every segment is asked.
[[nodiscard]] double distanceToPolyline(const Vec3& p_W, const std::vector<Vec3>& polyline_W);

/// Hausdorff distance of two polylines, sampled at `samples` points a segment: never more than the true one.
[[nodiscard]] double hausdorffFromBelow(const std::vector<Vec3>& a_W, const std::vector<Vec3>& b_W, int samples = 8);

} // namespace palpate::test
