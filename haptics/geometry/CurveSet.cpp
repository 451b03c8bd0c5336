// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/CurveSet.h"

namespace palpate
{

TriangleMesh raiseWalls(const CurveSet& curves, double halfHeight_u)
{
  TriangleMesh walls;
  walls.vertices_W.reserve(2 * curves.points_W.size());
  for (const Eigen::Vector2d& p : curves.points_W)
  {
    walls.vertices_W.emplace_back(p.x(), p.y(), -halfHeight_u);
    walls.vertices_W.emplace_back(p.x(), p.y(), halfHeight_u);
  }
  walls.triangles.reserve(2 * curves.segments.size());
  for (const auto& [a, b] : curves.segments)
  {
    walls.triangles.push_back({ 2 * a, 2 * b, 2 * b + 1 });
    walls.triangles.push_back({ 2 * a, 2 * b + 1, 2 * a + 1 });
  }
  return walls;
}

} // namespace palpate
