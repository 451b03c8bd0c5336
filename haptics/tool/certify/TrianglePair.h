// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "haptics/core/Types.h"

namespace palpate
{

using Corners = std::array<Vec3, 3>;

/// Gap along a direction n: positive if all of `above` lies further along n than all of `below`. Two triangles
/// that touch have no such direction, so that a positive gap is a proof, however n was found.
[[nodiscard]] inline double gapAlong(const Vec3& n, const Corners& above, const Corners& below) noexcept
{
  const double low = std::min({ n.dot(above[0]), n.dot(above[1]), n.dot(above[2]) });
  return low - std::max({ n.dot(below[0]), n.dot(below[1]), n.dot(below[2]) });
}

/// Distance of the axis-aligned boxes of two triangles along the best of the three axes: a lower bound of theirs.
[[nodiscard]] inline double boxesApart_u(const Corners& a, const Corners& b) noexcept
{
  const Vec3 lowA = a[0].cwiseMin(a[1]).cwiseMin(a[2]), highA = a[0].cwiseMax(a[1]).cwiseMax(a[2]);
  const Vec3 lowB = b[0].cwiseMin(b[1]).cwiseMin(b[2]), highB = b[0].cwiseMax(b[1]).cwiseMax(b[2]);
  return (lowA - highB).cwiseMax(lowB - highA).maxCoeff();
}

/// The nearest points of two triangles.
struct NearestPair
{
  Vec3 n = Vec3::UnitZ();  ///< unit, from the scene to the tool
  double distance_u = 0.0; ///< 0: they meet, and n has no meaning
  Vec3 onTool_W = Vec3::Zero();
  Vec3 onScene_W = Vec3::Zero();
};

/// From corners against triangles and edges against edges. Where a face or two edges have the nearest points, n is
/// their normal: the difference of points that are very near has few digits. Triangles that intersect may get
/// any n.
[[nodiscard]] NearestPair nearestPair(const Corners& tool_W, const Corners& scene_W) noexcept;

} // namespace palpate
