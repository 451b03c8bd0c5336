// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "haptics/geometry/tree/BoxTree.h"

namespace palpate
{

/// Moves the half of the things whose points come first along the longest side of the points' bounding box to the
/// front, ties by number, and returns the size of that half. `placeOf(i)`: a point of thing i, finite. O(n).
template<class PlaceOf>
std::size_t splitAtMedian(std::span<std::uint32_t> things, const PlaceOf& placeOf)
{
  Box box = Box::empty();
  for (const std::uint32_t i : things)
  {
    box.include(placeOf(i));
  }
  Eigen::Index axis = 0;
  (box.high_W - box.low_W).maxCoeff(&axis);
  const std::size_t half = things.size() / 2;
  std::vector<std::pair<double, std::uint32_t>> keys(things.size()); // side by side, as each is looked at several times
  std::ranges::transform(things, keys.begin(), [&](std::uint32_t i) { return std::pair(placeOf(i)[axis], i); });
  std::ranges::nth_element(keys, keys.begin() + static_cast<std::ptrdiff_t>(half));
  std::ranges::transform(keys, things.begin(), &std::pair<double, std::uint32_t>::second);
  return half;
}

} // namespace palpate
