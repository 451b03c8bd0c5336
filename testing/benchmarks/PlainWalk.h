// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate::test
{

/// A tree of boxes as a textbook has it: median splits along the longest side, leaves of four triangles, a segment
/// against boxes and triangles in plain double precision. Costs of ticks are compared with it, so it does not change: a
/// library would get faster with its releases.
class PlainWalk
{
public:
  explicit PlainWalk(const TriangleMesh& mesh);

  /// The fraction of the segment, 0..1, at which the segment first meets the mesh; above 1 where it does not.
  [[nodiscard]] double firstHit(const Vec3& from_W, const Vec3& to_W) const;

private:
  struct Node
  {
    Vec3 low_W, high_W;
    std::uint32_t first, count; ///< of a leaf's triangles; without any: the children are `first` and `first` + 1
  };
  void split(std::uint32_t node, std::uint32_t first, std::uint32_t count);
  [[nodiscard]] double hitTriangle(std::uint32_t triangle, const Vec3& from_W, const Vec3& way_W) const;

  TriangleMesh mesh_;
  std::vector<Node> nodes_;
};

} // namespace palpate::test
