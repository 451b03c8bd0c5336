// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// An edge as one of its triangles has it, with its ends in ascending order.
struct Side
{
  std::uint32_t low, high;
  std::uint32_t triangle;
  std::uint8_t k; ///< it goes from the triangle's corner of this number to the next one
  bool rising;    ///< the triangle runs from the low end to the high one

  [[nodiscard]] bool sameEdge(const Side& other) const { return this->low == other.low && this->high == other.high; }
};

/// Sides of all triangles, those of one edge next to each other. Vertices at one place count as the first of them;
/// triangles that repeat a place, or have no place for a corner, are passed over.
[[nodiscard]] std::vector<Side> sidesOf(const TriangleMesh& mesh);

/// Calls visit(first, last) for the sides of each edge.
template<class Visit>
void forEachEdge(const std::vector<Side>& sides, Visit visit)
{
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].sameEdge(sides[i]))
    {
      ++end;
    }
    visit(sides.begin() + static_cast<std::ptrdiff_t>(i), sides.begin() + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
}

/// How triangles are turned: those of a part, which hang together by edges of two, and whether each is turned as the
/// first of them.
class Turns
{
public:
  Turns(const TriangleMesh& mesh, const std::vector<Side>& sides);

  static constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> part; ///< of each triangle; none: it is passed over
  std::vector<bool> asFirst;
  std::vector<std::vector<std::uint32_t>> members; ///< of each part

private:
  using Beside = std::vector<std::vector<std::pair<std::uint32_t, bool>>>; ///< neighbours, and whether they agree

  void spread(std::uint32_t from, const Beside& beside);
};

/// The volume of a part when all of it is turned as its first triangle, six times; of no meaning for one with a rim.
[[nodiscard]] double sixVolumesOf(const TriangleMesh& mesh, const Turns& turns, std::uint32_t part);

} // namespace palpate
