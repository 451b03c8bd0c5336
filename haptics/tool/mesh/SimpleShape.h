// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// A ball, or a needle: all points within a radius of a point or of a line segment.
struct SimpleShape
{
  enum class Kind : std::uint8_t
  {
    Ball,
    Needle,
  };

  Kind kind = Kind::Ball;
  Vec3 from_B = Vec3::Zero(), to_B = Vec3::Zero(); ///< ends of the segment; of a ball both are its centre
  double radius_u = 0.0;
  double bound_u = 0.0; ///< largest distance of a point of either surface from the other
};

/// The ball or needle that a closed mesh is to within a share of its radius; nothing: it is neither. The bound is
/// measured, not estimated: the least and the largest distance of the line from the mesh's triangles. As the line is
/// inside of a closed surface, each ray straight out of it meets the mesh between these. Builds a tree: not for a tick.
[[nodiscard]] std::optional<SimpleShape> simpleShapeOf(const TriangleMesh& clean, double share);

/// Shape and error bound: a part of a sentence.
[[nodiscard]] std::string describe(const SimpleShape& shape);

} // namespace palpate
