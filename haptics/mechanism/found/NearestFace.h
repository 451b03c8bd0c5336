// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/tree/SurfaceData.h"
#include "haptics/geometry/tree/TreeWalk.h"
#include "haptics/mechanism/sided/SidedSurface.h"

namespace palpate
{

/// How far a place is outside of a box.
[[nodiscard]] inline double outsideOf(const Box& box, const Vec3& x)
{
  return (box.low_W - x).cwiseMax(x - box.high_W).cwiseMax(0.0).norm();
}

/// The nearest place of a surface.
struct NearestFace
{
  std::uint32_t triangle = SurfaceData::none;
  Vec3 p = Vec3::Zero();
  double away_u = std::numeric_limits<double>::infinity();
  double above = 0.0;         ///< along the outer normal of the triangle that decides the side: the steepest one
  Vec3 normal = Vec3::Zero(); ///< outer, unit, of that triangle

  /// Of a mesh's size, or of a distance: below that the direction from one surface to the other is rounding.
  static constexpr double rounding = 1e-9;
};

/// The nearest place within `reach_u` on those triangles that count, by their outer normals. `slack_u`: the vertices
/// may be so far from where the tree has them.
template<class Counts>
[[nodiscard]] NearestFace nearestFace(const SidedSurface& surface, const std::vector<Vec3>& vertices, const Vec3& x,
  double reach_u, double slack_u, const Counts& counts)
{
  const SurfaceData& data = surface.tree->data();
  NearestFace best;
  best.away_u = reach_u;
  const auto look = [&](std::uint32_t t)
  {
    const auto& [a, b, c] = data.corners(t);
    const Vec3 p = nearestOnTriangle(x, vertices[a], vertices[b], vertices[c]);
    const double away_u = (x - p).norm();
    if (away_u > best.away_u * (1.0 + NearestFace::rounding) + std::numeric_limits<double>::min())
    {
      return;
    }
    const Vec3 normal = surface.areaOf(t, vertices).normalized();
    if (!counts(normal))
    {
      return;
    }
    const double above = normal.dot(x - p);
    const bool nearer = away_u < best.away_u * (1.0 - NearestFace::rounding) || best.triangle == SurfaceData::none;
    if (nearer || std::abs(above) > std::abs(best.above))
    {
      best = { t, p, std::min(away_u, best.away_u), above, normal };
    }
  };
  const auto entriesOf = [&](const TreeNode& node) {
    return std::array<double, 2>{ outsideOf(boxOf(node, 0), x) - slack_u, outsideOf(boxOf(node, 1), x) - slack_u };
  };
  const auto reaches = [&](double entry) { return entry <= best.away_u; };
  walkNearestFirst(
    data.nodes, 0.0, entriesOf, reaches, reaches, [&](std::uint32_t leaf) { data.forEachInLeaf(leaf, look); });
  return best;
}

} // namespace palpate
