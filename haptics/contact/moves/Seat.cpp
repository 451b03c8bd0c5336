// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/moves/Seat.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <tuple>

#include "haptics/contact/planes/Projection.h"
#include "haptics/contact/sweep/KeptFaces.h"
#include "haptics/contact/sweep/NearFilter.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/sweep/TreeWalk.h"
#include "haptics/contact/view/SceneView.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"
#include "haptics/geometry/tree/SurfaceData.h"

namespace palpate
{
namespace
{

/// A round moves the ball off the nearest triangle and adds at most one plane. Seating is bounded: a ball that still
/// overlaps after so many rounds is said to have no place.
constexpr int rounds = 32;

/// A ball of that radius, standing still.
SweptBall stillBall(const Vec3& x_W, double reach) noexcept
{
  SweepQuery query;
  query.from_W = query.to_W = x_W;
  query.radius_u = reach;
  query.resolution.include(x_W);
  return sweptBallOf(query);
}

/// Calls visit(surface, its index, triangle) for each triangle of a list that may come within reach.
template<SceneView AnyScene, class Visit>
void forEachListed(const AnyScene& scene, SweptBall still, const FaceList& list, Visit visit) noexcept
{
  still.r += sceneOf(scene).mostCoat_u();
  OneSurface<AnyScene> surfaces;
  forEachNear(list, NearFilter(still, list.frame()),
    [&](int i) noexcept
    {
      const FaceList::Face& face = list.face(i);
      visit(surfaces.of(scene, face.surface), face.surface, face.triangle);
    });
}

/// Calls visit(surface, its index, triangle) for each triangle of a leaf whose box comes within reach of x, or for
/// fewer that are nearer, in the same order.
template<SceneView AnyScene, class Visit>
void forEachNear(const AnyScene& scene, const Vec3& x_W, double reach, const FacesAround* around, Visit visit) noexcept
{
  // A ball is seated at the start and where ball or scene change, not in each tick: all triangles within reach count.
  constexpr std::uint32_t unbounded = std::numeric_limits<std::uint32_t>::max();
  const SweptBall still = stillBall(x_W, reach);
  if (const FaceList* const list = around != nullptr ? listAround(scene, still, *around) : nullptr)
  {
    forEachListed(scene, still, *list, visit);
    return;
  }
  const BoxTest test(still);
  std::uint32_t nodes = 0;
  const auto visitSurface = [&](std::uint32_t s) noexcept
  {
    const auto& surface = surfaceOf(scene, s);
    const SurfaceData& data = dataOf(surface);
    const auto visitLeaf = [&](std::uint32_t index) noexcept
    {
      data.forEachInLeaf(index, [&](std::uint32_t t) noexcept { visit(surface, s, t); });
      return true;
    };
    return askTree(surface, still,
      [&](const SweptBall& inSurface) noexcept
      {
        return askShape(surface, [&](const auto& shape) noexcept
          { return walkWithin(nodesOf(shape), BoxTest(inSurface), unbounded, nodes, visitLeaf); });
      });
  };
  static_cast<void>(walkWithin(sceneOf(scene).surfaceTree().nodes, test, unbounded, nodes, visitSurface));
}

/// The feature that is nearest to the ball at x.
struct Nearest
{
  double clearance = std::numeric_limits<double>::infinity(); ///< from the centre to the surface, or to its coat
  double coat = 0.0;
  Vec3 foot_W = Vec3::Zero();
  std::uint32_t surface = 0;
  std::uint32_t triangle = 0;
};

/// A way off a triangle, or a curve, for a centre that rounding cannot tell from it: to the side that the centre is on
/// exactly. A point that rests on a face is as near as that, and a face may be turned either way.
template<class AnySurface>
Vec3 acrossAt(const AnySurface& surface, std::uint32_t triangle, const Vec3& x_W, bool bySide) noexcept
{
  if (dataOf(surface).coat_u > 0.0)
  {
    const auto& [a, b, c] = cornersIn(surface, triangle);
    return (b - a).unitOrthogonal();
  }
  const Vec3 normal_W = surface.face(triangle).normal_W;
  return bySide && sideOf(surface, triangle, x_W) < 0 ? Vec3(-normal_W) : normal_W;
}

template<SceneView AnyScene>
Nearest nearestWithin(const AnyScene& scene, const Vec3& x_W, double reach, const FacesAround* around) noexcept
{
  Nearest nearest;
  const double reach2 = reach * reach;
  double within2 = reach2; // more than rounding makes of the best so far
  forEachNear(scene, x_W, reach, around,
    [&](const auto& surface, std::uint32_t s, std::uint32_t t)
    {
      const auto& [a, b, c] = cornersIn(surface, t);
      const Vec3 low_W = a.cwiseMin(b).cwiseMin(c), high_W = a.cwiseMax(b).cwiseMax(c);
      const double coat = dataOf(surface).coat_u;
      if (coat == 0.0 && (low_W - x_W).cwiseMax(x_W - high_W).cwiseMax(0.0).squaredNorm() > within2)
      {
        return; // further than the best so far, or out of reach
      }
      const Vec3 foot_W = nearestOnTriangle(x_W, a, b, c);
      const double clearance = (x_W - foot_W).norm() - coat;
      // Of triangles that are as near the one of the lowest number counts, in whatever order they come.
      if (std::tie(clearance, s, t) < std::tie(nearest.clearance, nearest.surface, nearest.triangle))
      {
        nearest = { clearance, coat, foot_W, s, t };
        within2 = std::min(reach2, (1.0 + 1e-12) * clearance * clearance);
      }
    });
  return nearest;
}

/// One plane for each triangle that was nearest once. A triangle that is nearest again gets its plane anew.
class SeatPlanes
{
public:
  void set(const Nearest& nearest, const PlaneRow& row) noexcept
  {
    int at = 0;
    while (at < this->count_ && (this->triangles_[at] != nearest.triangle || this->surfaces_[at] != nearest.surface))
    {
      ++at;
    }
    if (at == rounds)
    {
      return;
    }
    this->rows_[at] = row;
    this->triangles_[at] = nearest.triangle;
    this->surfaces_[at] = nearest.surface;
    this->count_ = std::max(this->count_, at + 1);
  }
  [[nodiscard]] std::span<const PlaneRow> rows() const noexcept
  {
    return { this->rows_.data(), static_cast<std::size_t>(this->count_) };
  }

private:
  std::array<PlaneRow, rounds> rows_;
  std::array<std::uint32_t, rounds> triangles_{};
  std::array<std::uint32_t, rounds> surfaces_{};
  int count_ = 0;
};

/// Only the nearest feature pushes: a flat patch seen from close by pushes straight out, not sideways off each
/// triangle.
template<SceneView AnyScene>
bool seatRound(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, Vec3& x_W, const FacesAround* around) noexcept
{
  const double r = plan.radius_u;
  Resolution resolution;
  resolution.include(p_W);
  resolution.include(Vec3::Constant(r + sceneOf(scene).mostCoat_u()));
  double furthest = r; // how far the ball may be moved: out of the surface in which it lies
  const double tol = resolution.tol();
  SeatPlanes planes;
  Vec3 y = Vec3::Zero();
  for (int round = 0; round < rounds; ++round)
  {
    const Vec3 x = p_W + y;
    const Nearest nearest = nearestWithin(scene, x, r, around);
    if (nearest.clearance >= r - tol)
    {
      x_W = x;
      return true;
    }
    const double distance = nearest.clearance + nearest.coat;
    const Vec3 n = distance > tol ? Vec3((x - nearest.foot_W).normalized())
                                  : acrossAt(surfaceOf(scene, nearest.surface), nearest.triangle, x, plan.seatsBySide);
    planes.set(nearest, { n, r + nearest.coat - n.dot(p_W - nearest.foot_W) });
    furthest = std::max(furthest, r + nearest.coat);
    const ProjectionResult out = projectOntoPlanes(planes.rows(), Vec3::Zero(), resolution.slack());
    y = out.y;
    if (!out.feasible || y.norm() > furthest + tol)
    {
      return false;
    }
  }
  return false;
}

/// A step of zero length hits exactly the triangles that hold the point.
template<SceneView AnyScene>
bool offEveryTriangle(const AnyScene& scene, const Vec3& x_W, SweepHit& hit) noexcept
{
  SweepQuery query;
  query.from_W = query.to_W = x_W;
  query.resolution.include(x_W);
  constexpr std::uint32_t unbounded = 1u << 20; // a point is in few boxes; a stack of more has no free place either
  hit = sweepBall(scene, query, unbounded);
  return !hit.hit && hit.freeUntil >= 1.0;
}

template<SceneView AnyScene>
bool seatPoint(const AnyScene& scene, const Vec3& p_W, Vec3& x_W) noexcept
{
  SweepHit hit;
  if (offEveryTriangle(scene, p_W, hit))
  {
    x_W = p_W;
    return true;
  }
  Resolution resolution;
  resolution.include(p_W);
  const Vec3 n = surfaceOf(scene, hit.feature.surface).face(hit.feature.a).normal_W;
  // Doubled from the least that can differ, so that the lift is at most twice the necessary one; 24 doublings bound it.
  for (double lift = resolution.del(); lift < 1e6 * resolution.tol(); lift *= 2)
  {
    for (const double side : { 1.0, -1.0 })
    {
      const Vec3 x = p_W + side * lift * n;
      SweepHit ignored;
      if (offEveryTriangle(scene, x, ignored))
      {
        x_W = x;
        return true;
      }
    }
  }
  return false;
}

} // namespace

template<SceneView AnyScene>
bool seatBall(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, Vec3& x_W, const FacesAround* around) noexcept
{
  return plan.radius_u > 0.0 ? seatRound(scene, plan, p_W, x_W, around) : seatPoint(scene, p_W, x_W);
}

template bool seatBall(const Scene&, const ContactPlan&, const Vec3&, Vec3&, const FacesAround*) noexcept;
template bool seatBall(const MovingScene&, const ContactPlan&, const Vec3&, Vec3&, const FacesAround*) noexcept;

} // namespace palpate
