// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/simplify/CoarserSurface.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "haptics/geometry/curves/CoarserCurves.h"
#include "haptics/geometry/curves/CurveSet.h"

namespace palpate
{
namespace
{

using Segment = std::array<std::uint32_t, 2>;

Simplification refuse(std::string why)
{
  Simplification refused;
  refused.refusal = std::move(why);
  return refused;
}

struct Lines
{
  std::vector<Vec3> points_W;
  std::vector<Segment> segments;
  double halfHeight_u = 0.0; ///< of walls
};

Lines linesOf(const SurfaceTree& curves, const std::optional<Pose>& plane_WP)
{
  Lines lines;
  if (plane_WP)
  {
    LoweredWalls lowered = lowerWalls(curves.mesh(), *plane_WP);
    lines.segments = std::move(lowered.curves.segments);
    lines.halfHeight_u = lowered.halfHeight_u;
    lines.points_W.reserve(lowered.curves.points_W.size());
    for (const Eigen::Vector2d& p : lowered.curves.points_W)
    {
      lines.points_W.emplace_back(p.x(), p.y(), 0.0);
    }
    return lines;
  }
  lines.points_W = curves.mesh().vertices_W;
  lines.segments.reserve(curves.mesh().triangles.size());
  for (const auto& corners : curves.mesh().triangles)
  {
    lines.segments.push_back({ corners[0], corners[1] });
  }
  return lines;
}

CleanResult meshOf(const Lines& lines, const std::vector<Segment>& segments, const std::optional<Pose>& plane_WP)
{
  if (plane_WP)
  {
    CurveSet curves;
    curves.segments = segments;
    curves.points_W.reserve(lines.points_W.size());
    for (const Vec3& p : lines.points_W)
    {
      curves.points_W.emplace_back(p.head<2>());
    }
    return cleanMesh(raiseWalls(curves, std::max(lines.halfHeight_u, wallHalfHeight(curves, 0.0)), *plane_WP));
  }
  TriangleMesh mesh;
  mesh.vertices_W = lines.points_W;
  mesh.triangles.reserve(segments.size());
  for (const auto& [a, b] : segments)
  {
    mesh.triangles.push_back({ a, b, b });
  }
  return cleanSegments(mesh);
}

/// Of a segment, or of the one that the triangle of a wall stands on [u].
double lengthOf(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners, const Vec3& up_W)
{
  double length_u = 0.0;
  for (const std::size_t k : { 1U, 2U })
  {
    const Vec3 side_W = mesh.vertices_W[corners[k]] - mesh.vertices_W[corners[0]];
    length_u = std::max(length_u, (side_W - up_W.dot(side_W) * up_W).norm());
  }
  return length_u;
}

} // namespace

bool hasFineLines(const SurfaceTree& curves, const std::optional<Pose>& plane_WP, const FineLines& fine)
{
  const Vec3 up_W = plane_WP ? Vec3(plane_WP->q * Vec3::UnitZ()) : Vec3(Vec3::Zero());
  const std::size_t enough = (plane_WP ? 2 : 1) * fine.least;
  std::size_t count = 0;
  for (std::size_t i = 0; i < curves.mesh().triangles.size() && count < enough; ++i)
  {
    count += lengthOf(curves.mesh(), curves.mesh().triangles[i], up_W) < fine.below_u ? 1 : 0;
  }
  return count >= enough;
}

Simplification coarserSurface(
  const SurfaceTree& curves, const std::optional<Pose>& plane_WP, std::size_t leastGone, const SimplifyLimits& limits)
{
  const Lines lines = linesOf(curves, plane_WP);
  const CoarserCurves coarser = coarsestWithin(lines.points_W, lines.segments, limits.limit_u, limits.stop);
  if (limits.stop.stop_requested())
  {
    return refuse("the simplification was stopped");
  }
  if (coarser.segments.size() + leastGone > lines.segments.size())
  {
    return refuse("its lines are no finer than a hand feels, or too near each other");
  }
  CleanResult clean = meshOf(lines, coarser.segments, plane_WP);
  Simplification found;
  found.tree = std::make_shared<const SurfaceTree>(std::move(clean.mesh), curves.coat_u());
  found.bound_u = coarser.bound_u;
  return found;
}

} // namespace palpate
