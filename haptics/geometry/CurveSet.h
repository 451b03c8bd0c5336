// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "haptics/geometry/TriangleMesh.h"

namespace palpate
{

/// Line segments in the plane z = 0, in scene units: a plane world.
struct CurveSet
{
  std::vector<Eigen::Vector2d> points_W;
  std::vector<std::array<std::uint32_t, 2>> segments;
};

/// The plane world as walls: each segment becomes a rectangle from z = -halfHeight_u to +halfHeight_u. A ball that is
/// led in the plane z = 0 meets the walls as a disc meets the lines and never leaves the plane: the walls' normals and
/// the feet of its contacts have no z, exactly. So one god-object serves two dimensions and three.
/// halfHeight_u > 0 must exceed the ball's radius. Indices are checked by cleanMesh().
[[nodiscard]] TriangleMesh raiseWalls(const CurveSet& curves, double halfHeight_u);

} // namespace palpate
