// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace palpate
{

/// Points joined one after the other, as indices. Closed: its first index is also its last.
struct CurveChain
{
  std::vector<std::uint32_t> points;

  [[nodiscard]] bool closed() const noexcept
  {
    return this->points.size() > 2 && this->points.front() == this->points.back();
  }
};

/// Joins loose segments into the fewest chains that end only at free ends and where more than two segments meet. Each
/// segment is in exactly one chain; one given twice, in either order, counts once, and one from a point to itself not
/// at all. Chains with ends come before rings, each kind in the order of its first points: the order of the segments
/// plays no part. Indices must be below pointCount. O(n log n).
[[nodiscard]] std::vector<CurveChain> joinSegments(
  std::span<const std::array<std::uint32_t, 2>> segments, std::size_t pointCount);

} // namespace palpate
