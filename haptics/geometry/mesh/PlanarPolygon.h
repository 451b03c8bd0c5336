// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <vector>

namespace palpate
{

/// A polygon seen along one coordinate of space, w; finite.
struct PlanarPolygon
{
  struct Point
  {
    double u, v, w;
    auto operator<=>(const Point&) const = default;
  };
  std::vector<Point> points;        ///< one a corner
  std::vector<std::uint32_t> place; ///< for each corner the first one at the same point of space
  bool mirrored = false;            ///< it runs clockwise in (u, v)
};

/// Takes the numbers of three corners of a polygon.
using TakeTriangle = std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>;

} // namespace palpate
