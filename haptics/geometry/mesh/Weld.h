// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "haptics/core/Types.h"

namespace palpate
{

/// Finite vertices in the order of (x, y, z) without repeats, and where each raw vertex went.
struct Weld
{
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
  std::vector<Vec3> vertices_W;        ///< [u]
  std::vector<std::uint32_t> newIndex; ///< of each raw vertex; nowhere: it is not finite
  std::vector<std::uint32_t> source;   ///< the first raw vertex of each
};

/// Welds exactly equal vertices [u]. `threads`: from 2 on the work is shared by two, with the same result. O(n) to
/// O(n log n).
[[nodiscard]] Weld weld(const std::vector<Vec3>& raw_W, unsigned threads);

} // namespace palpate
