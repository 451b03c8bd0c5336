// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/geometry/measure/RayWalk.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/geometry/mesh/ExactPredicates.h"
#include "haptics/geometry/tree/SegmentTriangle.h"
#include "haptics/geometry/tree/TreeWalk.h"

namespace palpate
{
namespace
{

/// The part of a ray that can meet a surface: from its beginning to a point beyond the surface's box.
struct Ray
{
  Vec3 from_W;
  Vec3 direction_W;
  Vec3 beyond_W;
  double rounding_u; ///< more than a coordinate of a point of it is off

  Ray(const SurfaceData& surface, const Vec3& from, const Vec3& direction) : from_W(from), direction_W(direction)
  {
    const Vec3 size_W = surface.high_W - surface.low_W;
    const double away_u = (surface.low_W + 0.5 * size_W - from).norm();
    this->beyond_W = from + 2.0 * (away_u + size_W.norm()) * direction;
    this->rounding_u = 1e-15 * (from.cwiseAbs().maxCoeff() + 2.0 * (away_u + size_W.norm()));
  }

  [[nodiscard]] bool meets(const Vec3& low_W, const Vec3& high_W) const noexcept
  {
    double entry = 0.0, exit = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
    {
      const double low = low_W[k] - 4.0 * this->rounding_u - this->from_W[k];
      const double high = high_W[k] + 4.0 * this->rounding_u - this->from_W[k];
      if (std::abs(this->direction_W[k]) < 1e-290) // its inverse could be infinite
      {
        if (low > 0.0 || high < 0.0)
        {
          return false;
        }
        continue;
      }
      const double a = low / this->direction_W[k], b = high / this->direction_W[k];
      entry = std::max(entry, std::min(a, b) * (1.0 - 1e-12));
      exit = std::min(exit, std::max(a, b) * (1.0 + 1e-12));
    }
    return entry <= exit;
  }
};

/// Calls visit(triangle) for each triangle of the leaves whose box the ray meets.
template<class Visit>
void forEachNear(const SurfaceData& surface, const Ray& ray, Visit visit)
{
  forEachMeeting(
    surface, [&ray](const Box& box) { return ray.meets(box.low_W, box.high_W); }, visit);
}

/// How a segment passes a triangle.
enum class Passing
{
  Misses,
  Through,
  OnEdge, ///< exactly through an edge or a vertex, or in the plane
  Begins, ///< begins on it
};

Passing passingOf(const Vec3& p, const Vec3& q, const FaceRecord& face)
{
  const auto& [a, b, c] = face.corner_W;
  const int atStart = orientation(a, b, c, p), atEnd = orientation(a, b, c, q);
  if (atStart == 0 && atEnd == 0)
  {
    return meetsInPlane(p, q, face) ? Passing::OnEdge : Passing::Misses;
  }
  if (atStart == atEnd || !linePassesThrough(p, q, face))
  {
    return Passing::Misses;
  }
  if (atStart == 0)
  {
    return Passing::Begins;
  }
  const bool inside = orientation(p, q, a, b) != 0 && orientation(p, q, b, c) != 0 && orientation(p, q, c, a) != 0;
  return inside ? Passing::Through : Passing::OnEdge;
}

/// Along one ray; Unknown if it meets an edge or a vertex.
PointSide sideAlong(const SurfaceData& surface, const Ray& ray)
{
  std::size_t passed = 0;
  PointSide special = PointSide::Outside; // nothing special was met
  forEachNear(surface, ray,
    [&](std::uint32_t triangle)
    {
      const Passing passing = passingOf(ray.from_W, ray.beyond_W, surface.face(triangle));
      passed += passing == Passing::Through ? 1 : 0;
      if (passing == Passing::Begins)
      {
        special = PointSide::On;
      }
      else if (passing == Passing::OnEdge && special == PointSide::Outside)
      {
        special = PointSide::Unknown;
      }
    });
  return special != PointSide::Outside ? special : passed % 2 == 1 ? PointSide::Inside : PointSide::Outside;
}

} // namespace

std::optional<RayHit> firstHit(const SurfaceTree& surface, const Vec3& from_W, const Vec3& direction_W, double after_u)
{
  const SurfaceData& data = surface.data();
  const Ray ray(data, from_W, direction_W);
  std::optional<RayHit> best;
  forEachNear(data, ray,
    [&](std::uint32_t triangle)
    {
      const FaceRecord face = data.face(triangle);
      const double slope = face.normal_W.dot(direction_W);
      if (slope == 0.0 || !linePassesThrough(ray.from_W, ray.beyond_W, face))
      {
        return;
      }
      const double way_u = face.normal_W.dot(face.corner_W[0] - from_W) / slope;
      if (way_u > after_u && (!best || way_u < best->way_u))
      {
        best = RayHit{ triangle, way_u, from_W + way_u * direction_W };
      }
    });
  return best;
}

PointSide sideOf(const SurfaceTree& surface, const Vec3& x_W)
{
  const SurfaceData& data = surface.data();
  if ((x_W.array() < data.low_W.array()).any() || (x_W.array() > data.high_W.array()).any())
  {
    return PointSide::Outside;
  }
  constexpr int most = 16;
  for (int i = 0; i < most; ++i) // directions that no modeller chooses
  {
    const Vec3 direction_W = Vec3(0.5377 + 0.1 * i, 0.3188 - 0.17 * i, 0.7821 - 0.23 * i).normalized();
    if (const PointSide side = sideAlong(data, Ray(data, x_W, direction_W)); side != PointSide::Unknown)
    {
      return side;
    }
  }
  return PointSide::Unknown;
}

PointSide sideOf(const SurfaceTree& surface, const Vec3& x_W, const Vec3& direction_W)
{
  return sideAlong(surface.data(), Ray(surface.data(), x_W, direction_W));
}

bool isClosed(const SurfaceTree& surface)
{
  const SurfaceData& data = surface.data();
  const auto evenAt = [&data](std::uint32_t i, std::uint32_t j)
  {
    std::size_t around = 0;
    data.forEachAtEdge(i, j, [&around](std::uint32_t) { ++around; });
    return around % 2 == 0;
  };
  return data.coat_u == 0.0 && std::all_of(data.mesh.triangles.begin(), data.mesh.triangles.end(),
                                 [&](const std::array<std::uint32_t, 3>& t)
                                 { return evenAt(t[0], t[1]) && evenAt(t[1], t[2]) && evenAt(t[2], t[0]); });
}

} // namespace palpate
