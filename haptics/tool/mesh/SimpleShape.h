// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "haptics/geometry/mesh/TriangleMesh.h"

namespace palpate
{

/// A ball, or a needle: all that is within a radius of a point or of a piece of a line.
struct SimpleShape
{
  enum class Kind : std::uint8_t
  {
    Ball,
    Needle,
  };

  Kind kind = Kind::Ball;
  Vec3 from_B = Vec3::Zero(), to_B = Vec3::Zero(); ///< of the line; of a ball both are its centre
  double radius_u = 0.0;
  double bound_u = 0.0; ///< no point of either surface is further from the other
};

/// The ball or needle that a closed mesh is to within a share of its radius; nothing: it is neither. The bound is
/// measured, not estimated: the distance of the line to the mesh is least and most on its triangles, and as the line is
/// inside of a closed surface, each way straight out of it meets the mesh within these. Builds a tree: not for a tick.
[[nodiscard]] std::optional<SimpleShape> simpleShapeOf(const TriangleMesh& clean, double share);

/// Shape and error bound: a part of a sentence.
[[nodiscard]] std::string describe(const SimpleShape& shape);

} // namespace palpate
