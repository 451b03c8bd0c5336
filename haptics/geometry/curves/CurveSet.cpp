// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/curves/CurveSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "haptics/core/PoseMath.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

/// Rounding of single precision for a whole scene of coordinates, with slack for a rotation.
double roundingOf(const TriangleMesh& segments)
{
  constexpr double units = 4.0;
  double largest_u = 0.0;
  for (const Vec3& p_W : segments.vertices_W)
  {
    largest_u = p_W.allFinite() ? std::max(largest_u, p_W.cwiseAbs().maxCoeff()) : largest_u;
  }
  return units * static_cast<double>(std::numeric_limits<float>::epsilon()) * largest_u;
}

std::string outOfPlane(std::size_t point, double z_u)
{
  std::ostringstream text;
  text << "point " << point << " of its lines stands " << z_u
       << " scene units out of the plane z = 0; ParaView's Transform moves them there";
  return text.str();
}

/// Finite points of the segments.
std::vector<Vec3> pointsOf(const TriangleMesh& segments)
{
  std::vector<Vec3> points_W;
  for (const auto& corners : segments.triangles)
  {
    for (const std::uint32_t corner : { corners[0], corners[1] })
    {
      if (corner < segments.vertices_W.size() && segments.vertices_W[corner].allFinite())
      {
        points_W.push_back(segments.vertices_W[corner]);
      }
    }
  }
  return points_W;
}

template<class Measure>
Vec3 farthest(const std::vector<Vec3>& points_W, Measure measure)
{
  return *std::max_element(
    points_W.begin(), points_W.end(), [&](const Vec3& a, const Vec3& b) { return measure(a) < measure(b); });
}

/// Across an axis of W if the points are all at one height over it, else across three of them; zero where there is
/// none.
Vec3 normalThrough(const std::vector<Vec3>& points_W, double rounding_u)
{
  const Vec3 a = points_W.front();
  for (const int axis : { 2, 0, 1 })
  {
    const Vec3 far = farthest(points_W, [&](const Vec3& p) { return std::fabs(p[axis] - a[axis]); });
    if (std::fabs(far[axis] - a[axis]) <= rounding_u)
    {
      return Vec3::Unit(axis);
    }
  }
  const Vec3 along = (farthest(points_W, [&](const Vec3& p) { return (p - a).norm(); }) - a).normalized();
  const Vec3 aside = farthest(points_W, [&](const Vec3& p) { return (p - a).cross(along).norm(); }) - a;
  const Vec3 normal = along.cross(aside);
  return normal.norm() > rounding_u ? Vec3(normal.normalized()) : Vec3(Vec3::Zero());
}

Quat orientationAcross(Vec3 normal_W)
{
  int axis = 0;
  static_cast<void>(normal_W.cwiseAbs().maxCoeff(&axis));
  const Vec3 up = axis == 2 ? Vec3::UnitY() : Vec3::UnitZ();
  normal_W = (up.cross(normal_W))[axis == 0 ? 1 : 0] < 0.0 ? Vec3(-normal_W) : normal_W;
  Mat3 axes;
  axes.col(0) = up.cross(normal_W).normalized();
  axes.col(1) = normal_W.cross(axes.col(0));
  axes.col(2) = normal_W;
  return Quat(axes).normalized();
}

} // namespace

std::string refuseSegments(std::size_t segments)
{
  return segments <= mostSegments
           ? ""
           : "its lines have " + std::to_string(segments) + " segments; at most " + std::to_string(mostSegments) +
               " can be felt: simplify them first (ParaView's Decimate Polyline, or Image Curves with a larger " +
               "tolerance where they come from an image)";
}

std::optional<Pose> planeOf(const TriangleMesh& segments)
{
  const std::vector<Vec3> points_W = pointsOf(segments);
  if (points_W.empty())
  {
    return std::nullopt;
  }
  const double rounding_u = roundingOf(segments);
  const Vec3 normal_W = normalThrough(points_W, rounding_u);
  if (normal_W.isZero(0.0))
  {
    return std::nullopt;
  }
  Pose plane_WP;
  plane_WP.q = orientationAcross(normal_W);
  const double height_u = normal_W.dot(points_W.front());
  plane_WP.p = std::fabs(height_u) > rounding_u ? Vec3(height_u * normal_W) : Vec3(Vec3::Zero());
  const bool flat = std::all_of(points_W.begin(), points_W.end(),
    [&](const Vec3& p) { return std::fabs(normal_W.dot(p - plane_WP.p)) <= rounding_u; });
  return flat ? std::optional(plane_WP) : std::nullopt;
}

PlaneCurves curvesInPlane(const TriangleMesh& segments, const Pose& plane_WP)
{
  PlaneCurves found;
  found.refusal = refuseSegments(segments.triangles.size());
  if (!found.refusal.empty())
  {
    return found;
  }
  const double most_u = roundingOf(segments);
  found.curves.points_W.reserve(segments.vertices_W.size());
  for (const Vec3& p_W : segments.vertices_W)
  {
    const Vec3 p_P = into(plane_WP, p_W);
    if (std::fabs(p_P.z()) > most_u && found.refusal.empty())
    {
      found.refusal = outOfPlane(found.curves.points_W.size(), p_P.z());
    }
    found.curves.points_W.emplace_back(p_P.head<2>());
  }
  for (const auto& corners : segments.triangles)
  {
    if (!isSegment(corners) || std::max(corners[0], corners[1]) >= segments.vertices_W.size())
    {
      found.refusal = "the lines refer to points that do not exist";
      break;
    }
    found.curves.segments.push_back({ corners[0], corners[1] });
  }
  if (found.refusal.empty() && found.curves.segments.empty())
  {
    found.refusal = "it has no lines";
  }
  return found;
}

TriangleMesh raiseWalls(const CurveSet& curves, double halfHeight_u, const Pose& plane_WP)
{
  TriangleMesh walls;
  walls.vertices_W.reserve(2 * curves.points_W.size());
  for (const Eigen::Vector2d& p : curves.points_W)
  {
    walls.vertices_W.push_back(plane_WP * Vec3(p.x(), p.y(), -halfHeight_u));
    walls.vertices_W.push_back(plane_WP * Vec3(p.x(), p.y(), halfHeight_u));
  }
  walls.triangles.reserve(2 * curves.segments.size());
  for (const auto& [a, b] : curves.segments)
  {
    walls.triangles.push_back({ 2 * a, 2 * b, 2 * b + 1 });
    walls.triangles.push_back({ 2 * a, 2 * b + 1, 2 * a + 1 });
  }
  return walls;
}

LoweredWalls lowerWalls(const TriangleMesh& walls, const Pose& plane_WP)
{
  LoweredWalls lowered;
  std::vector<bool> below;
  below.reserve(walls.vertices_W.size());
  lowered.curves.points_W.reserve(walls.vertices_W.size());
  for (const Vec3& p_W : walls.vertices_W)
  {
    const Vec3 p_P = into(plane_WP, p_W);
    below.push_back(p_P.z() < 0.0);
    lowered.curves.points_W.emplace_back(p_P.head<2>());
    lowered.halfHeight_u = std::max(lowered.halfHeight_u, p_P.z());
  }
  for (const auto& corners : walls.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::uint32_t i = corners[k], j = corners[(k + 1) % 3];
      if (below[i] && below[j])
      {
        lowered.curves.segments.push_back({ i, j });
      }
    }
  }
  return lowered;
}

double wallHalfHeight(const CurveSet& curves, double radius_u)
{
  double sum_u = 0.0;
  std::size_t count = 0;
  for (const auto& [a, b] : curves.segments)
  {
    const double length_u = (curves.points_W[a] - curves.points_W[b]).norm();
    sum_u += length_u > 0.0 && std::isfinite(length_u) ? length_u : 0.0;
    count += length_u > 0.0 && std::isfinite(length_u) ? 1 : 0;
  }
  const double mean_u = count > 0 ? sum_u / static_cast<double>(count) : 1.0;
  int exponent = 0;
  static_cast<void>(std::frexp(std::max(0.5 * mean_u, 2.0 * radius_u), &exponent));
  return std::ldexp(1.0, exponent);
}

} // namespace palpate
