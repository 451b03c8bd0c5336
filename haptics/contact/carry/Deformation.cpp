// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/carry/Deformation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "haptics/contact/carry/NearestPassing.h"
#include "haptics/contact/carry/PassingTriangles.h"
#include "haptics/contact/moves/Seat.h"
#include "haptics/contact/sweep/BoxTest.h"
#include "haptics/contact/sweep/KeptFaces.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/sweep/TreeWalk.h"
#include "haptics/contact/view/Resolution.h"
#include "haptics/geometry/mesh/NearestOnTriangle.h"

namespace palpate
{
namespace
{

SweepQuery freeQuery(const Vec3& from_W, const Vec3& to_W, double radius_u) noexcept
{
  SweepQuery query = straightQuery(from_W, to_W, radius_u);
  query.resolution.include(Vec3::Constant(radius_u));
  return query;
}

} // namespace

template<SceneView AnyScene>
SweepHit sweepStraight(const AnyScene& scene, const ContactPlan& plan, double radius_u, const Vec3& from_W,
  const Vec3& to_W, const FacesAround* around) noexcept
{
  const SweepQuery query = freeQuery(from_W, to_W, radius_u);
  const FaceList* const list = around != nullptr ? listAround(scene, sweptBallOf(query), *around) : nullptr;
  return list != nullptr ? sweepListed(scene, query, *list, plan.workBudget) : sweepBall(scene, query, plan.workBudget);
}

namespace
{

/// A point of a surface: a triangle and the weights of its corners.
struct SurfacePoint
{
  std::uint32_t triangle = 0;
  Vec3 weights = Vec3::Zero();
};

/// Weights of the nearest point of a triangle; a corner or an edge has exact zeros.
Vec3 weightsAt(const FaceRecord& face, const Vec3& x_W) noexcept
{
  const auto& [a, b, c] = face.corner_W;
  const Vec3 foot_W = nearestOnTriangle(x_W, a, b, c), &n = face.normal_W;
  Vec3 weights(n.dot((c - b).cross(foot_W - b)), n.dot((a - c).cross(foot_W - c)), n.dot((b - a).cross(foot_W - a)));
  const double all = n.dot((b - a).cross(c - a));
  constexpr double zero = 1e-12; // far above the rounding of a product of lengths, far below any share that moves
  weights = weights.unaryExpr([all](double w) { return w > zero * all ? w : 0.0; });
  return weights / weights.sum();
}

Vec3 pointOf(const FaceRecord& face, const Vec3& weights) noexcept
{
  return weights[0] * face.corner_W[0] + weights[1] * face.corner_W[1] + weights[2] * face.corner_W[2];
}

/// Calls visit(triangle) for each triangle that holds a point of one of them.
template<class View, class Visit>
void forEachHolding(const View& s, const SurfacePoint& point, Visit visit) noexcept
{
  const auto& corners = s.corners(point.triangle);
  std::array<std::uint32_t, 3> on{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (point.weights[static_cast<Eigen::Index>(k)] > 0.0)
    {
      on[count++] = corners[k];
    }
  }
  if (count == 3)
  {
    visit(point.triangle);
  }
  else if (count == 2)
  {
    s.forEachAtEdge(on[0], on[1], visit);
  }
  else
  {
    s.forEachAround(on[0], visit);
  }
}

/// Takes a vector from a unit vector's frame to another's by the least turn.
Vec3 turnedAlong(const Vec3& from, const Vec3& to, const Vec3& v) noexcept
{
  const Vec3 axis = from.cross(to);
  const double cosine = from.dot(to);
  constexpr double opposite = -0.999; // within 3 degrees of a half turn its axis is lost
  return cosine < opposite ? Vec3(v.norm() * to) : Vec3(v + axis.cross(v) + axis.cross(axis.cross(v)) / (1.0 + cosine));
}

/// A ball and one surface before and after its vertices moved.
template<SceneView AnyScene>
class Advection
{
public:
  Advection(const AnyScene& from, const AnyScene& to, std::uint32_t before, std::uint32_t now, const ContactPlan& plan,
    const Vec3& x_W, FacesAround& around) noexcept
    : from_(from), to_(to), before_(surfaceOf(from, before)), now_(surfaceOf(to, now)), surface_(before), plan_(plan),
      x_W_(x_W), around_(around)
  {
    this->resolution_.include(x_W);
  }

  /// Where the ball is now, or nothing if no triangle can have come over it or another surface keeps them apart.
  [[nodiscard]] std::optional<Vec3> run() noexcept
  {
    const double reach = this->plan_.radius_u + 4 * this->resolution_.tol();
    const std::optional<NearestPassing> nearest = nearestPassing(
      this->from_, this->before_, this->now_, this->surface_, this->x_W_, reach, this->plan_, this->around_);
    if (!nearest || !this->look(*nearest))
    {
      return std::nullopt;
    }
    openKept(this->to_, this->around_);
    pickAround(this->to_, this->x_W_, this->plan_.radius_u, this->around_);
    const FaceRecord face = this->now_.face(this->at_.triangle);
    for (const Vec3& corner : face.corner_W)
    {
      this->resolution_.include(corner);
    }
    return stopBefore(this->to_, this->plan_, 0.0, this->above(face),
      pointOf(face, this->at_.weights) + this->offset(face), &this->around_);
  }

  /// A triangle could have come over the ball behind another surface, which does not hold it up.
  [[nodiscard]] bool keptApart() const noexcept { return this->keptApart_; }

private:
  /// Finds the point of the old surface that the ball sees in the direction of that triangle, and on which side it is.
  [[nodiscard]] bool look(const NearestPassing& nearest) noexcept
  {
    const SweepHit seen = this->firstTowards(nearest);
    this->keptApart_ = seen.hit && seen.feature.surface != this->surface_;
    if (this->keptApart_)
    {
      return false;
    }
    this->at_.triangle = seen.hit ? seen.feature.a : nearest.triangle;
    this->at_.weights = weightsAt(this->before_.face(this->at_.triangle), this->x_W_);
    this->apart_W_ = this->x_W_ - this->nearestOn(this->at_.triangle);
    this->touches_ = this->apart_W_.norm() <= 16 * this->resolution_.tol();
    if (!this->touches_)
    {
      this->faceBall();
    }
    this->side_ = sideOf(this->before_, this->at_.triangle, this->x_W_);
    return this->side_ != 0;
  }

  /// The first face on the way to the nearest point. A face that is further from the ball than that point is not on it.
  [[nodiscard]] SweepHit firstTowards(const NearestPassing& nearest) const noexcept
  {
    if (nearest.alikeCount == 1)
    {
      return {}; // that triangle itself, if any
    }
    constexpr double beyond = 1.0 + 1e-6; // the foot itself is met, whatever rounding does to it
    const Vec3 to_W = this->x_W_ + beyond * (this->nearestOn(nearest.triangle) - this->x_W_);
    return nearest.alikeCount > 1
             ? sweepFaces(this->from_, freeQuery(this->x_W_, to_W, 0.0), { nearest.alike.data(), nearest.alikeCount })
             : sweepStraight(this->from_, this->plan_, 0.0, this->x_W_, to_W, &this->around_);
  }

  [[nodiscard]] Vec3 nearestOn(std::uint32_t triangle) const noexcept
  {
    const auto [a, b, c] = cornersIn(this->before_, triangle);
    return nearestOnTriangle(this->x_W_, a, b, c);
  }

  /// Over an edge or a corner the triangle that faces the ball most has it on its free side; the others may not.
  void faceBall() noexcept
  {
    double most = 0.0;
    std::uint32_t facing = this->at_.triangle;
    forEachHolding(this->before_, this->at_,
      [&](std::uint32_t t)
      {
        const double along = std::abs(this->before_.face(t).normal_W.dot(this->apart_W_));
        if (along > most)
        {
          most = along;
          facing = t;
        }
      });
    if (facing != this->at_.triangle)
    {
      this->at_ = { facing, weightsAt(this->before_.face(facing), this->x_W_) };
    }
  }

  /// From the point of the new surface to the ball.
  [[nodiscard]] Vec3 offset(const FaceRecord& face) const noexcept
  {
    const double distance = this->apart_W_.norm();
    if (this->touches_)
    {
      return this->side_ * std::max(distance, this->resolution_.del()) * face.normal_W;
    }
    Vec3 old = Vec3::Zero(), fresh = Vec3::Zero();
    forEachHolding(this->before_, this->at_,
      [&](std::uint32_t t)
      {
        const Vec3 n = this->before_.face(t).normal_W;
        old += n.dot(this->apart_W_) * n;
        fresh += n.dot(this->apart_W_) * this->now_.face(t).normal_W;
      });
    constexpr double told = 1e-6; // a shorter sum of normals is the rounding of opposite ones
    const bool decided = old.norm() > told * distance && fresh.norm() > told * distance;
    return decided ? turnedAlong(old.normalized(), fresh.normalized(), this->apart_W_)
                   : Vec3(this->side_ * distance * face.normal_W);
  }

  /// Just above the inside of the new triangle, on the ball's side of it exactly.
  [[nodiscard]] Vec3 above(const FaceRecord& face) const noexcept
  {
    constexpr double inward = 1e-4; // of the triangle: off its border, and no way to speak of
    const Vec3 inside_W = pointOf(face, (1.0 - inward) * this->at_.weights + Vec3::Constant(inward / 3.0));
    Vec3 above_W = inside_W;
    constexpr int doublings = 20; // a million times the rounding of coordinates
    double lift = this->resolution_.del();
    for (int i = 0; i < doublings && sideOf(this->now_, this->at_.triangle, above_W) != this->side_; ++i, lift *= 2)
    {
      above_W = inside_W + this->side_ * lift * face.normal_W;
    }
    return above_W;
  }

  const AnyScene& from_;
  const AnyScene& to_;
  decltype(surfaceOf(std::declval<const AnyScene&>(), 0u)) before_, now_;
  std::uint32_t surface_;
  const ContactPlan& plan_;
  Vec3 x_W_;
  FacesAround& around_;
  Resolution resolution_;
  SurfacePoint at_;
  Vec3 apart_W_ = Vec3::Zero(); ///< from the nearest point of the old surface to the ball
  bool keptApart_ = false;
  bool touches_ = false; ///< so close that rounding decides about the direction
  int side_ = 0;
};

/// A curve has no sides. The ball goes with the nearest point of the curve and is swept from there back to its old
/// place, so that the curve pushes the ball along.
template<SceneView AnyScene>
std::optional<Vec3> carryWithCurve(const AnyScene& from, const AnyScene& to, std::uint32_t before, std::uint32_t now,
  const ContactPlan& plan, const Vec3& x_W, FacesAround& around) noexcept
{
  const auto &was = surfaceOf(from, before), &is = surfaceOf(to, now);
  Resolution resolution;
  resolution.include(x_W);
  const double reach = plan.radius_u + dataOf(is).coat_u + 4 * resolution.tol();
  const std::optional<NearestPassing> nearest = nearestPassing(from, was, is, before, x_W, reach, plan, around);
  if (!nearest)
  {
    return std::nullopt;
  }
  const FaceRecord old = was.face(nearest->triangle), fresh = is.face(nearest->triangle);
  const Vec3 along = old.corner_W[1] - old.corner_W[0];
  const double at = std::clamp((x_W - old.corner_W[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  const auto pointAt = [at](const FaceRecord& face)
  { return Vec3((1.0 - at) * face.corner_W[0] + at * face.corner_W[1]); };
  openKept(to, around);
  pickAround(to, x_W, plan.radius_u, around);
  return stopBefore(to, plan, plan.radius_u, x_W + pointAt(fresh) - pointAt(old), x_W, &around);
}

/// Whether a straight way goes through a surface, as it was, other than the one that made the ball go it.
template<SceneView AnyScene>
bool passesAnother(
  const AnyScene& from, const ContactPlan& plan, std::uint32_t carrier, const Vec3& from_W, const Vec3& to_W) noexcept
{
  bool passes = false;
  std::uint32_t left = plan.workBudget;
  const auto visit = [&](std::uint32_t i) noexcept
  {
    const auto& surface = surfaceOf(from, i);
    const SweepQuery query = straightQuery(inFrame(surface, from_W), inFrame(surface, to_W), 0.0);
    const auto met = [&](const auto& shape) noexcept { return sweepSurface(shape, i, query, left); };
    if (i != carrier)
    {
      const SweepHit hit = askShape(surface, met);
      passes = hit.hit;
      left -= std::min(left, hit.work);
    }
    return !passes && left > 0;
  };
  std::uint32_t work = 0;
  const SweptBall way = sweptBallOf(straightQuery(from_W, to_W, 0.0));
  static_cast<void>(walkWithin(sceneOf(from).surfaceTree().nodes, BoxTest(way), plan.workBudget, work, visit));
  return passes;
}

/// A face whose plane passed the ball beside the triangle no longer holds the ball.
template<SceneView AnyScene>
void dropTurnedFaces(const AnyScene& to, GodObjectState& state) noexcept
{
  const auto begin = state.features.begin();
  const auto turned = [&](const ActiveFeature& f)
  { return f.kind == FeatureKind::Face && sideOf(surfaceOf(to, f.surface), f.a, state.x_W) != f.side; };
  state.count = static_cast<int>(std::remove_if(begin, begin + state.count, turned) - begin);
}

} // namespace

bool verticesMoved(const Scene& from, std::uint32_t before, const Scene& to, std::uint32_t now) noexcept
{
  return from.surfaces()[before].tree->contentHash() != to.surfaces()[now].tree->contentHash();
}

bool verticesMoved(const MovingScene& from, std::uint32_t before, const MovingScene& to, std::uint32_t now) noexcept
{
  const Surface &was = from.scene().surfaces()[before], &is = to.scene().surfaces()[now];
  const bool rested = !was.from || from.share() >= 1.0, rests = !is.from || to.share() >= 1.0;
  const bool alike = rested && rests ? true : was.from == is.from && from.share() == to.share();
  return !alike || verticesMoved(from.scene(), before, to.scene(), now);
}

std::uint32_t successorOf(
  const std::vector<Surface>& before, std::uint32_t i, const std::vector<Surface>& after) noexcept
{
  const Surface& old = before[i];
  const auto same = [&old](const Surface& s) { return s.tree->contentHash() == old.tree->contentHash(); };
  const auto bent = [&old](const Surface& s)
  { return s.tree->topologyHash() == old.tree->topologyHash() && s.name == old.name; };
  if (i < after.size() && (same(after[i]) || bent(after[i])))
  {
    return i;
  }
  auto found = std::find_if(after.begin(), after.end(), same);
  if (found == after.end())
  {
    found = std::find_if(after.begin(), after.end(), bent);
  }
  return static_cast<std::uint32_t>(found - after.begin());
}

std::optional<std::uint32_t> nearestTriangle(
  const SurfaceData& surface, const Vec3& x_W, double reach_u, std::uint32_t budget) noexcept
{
  return PassingTriangles(surface, surface, x_W, x_W, reach_u, budget).nearest();
}

template<SceneView AnyScene>
Vec3 stopBefore(const AnyScene& scene, const ContactPlan& plan, double radius_u, const Vec3& free_W, const Vec3& to_W,
  const FacesAround* around) noexcept
{
  const SweepHit hit = sweepStraight(scene, plan, radius_u, free_W, to_W, around);
  if (!hit.hit)
  {
    return free_W + hit.freeUntil * (to_W - free_W);
  }
  // A point must stop short of its obstacle, and the path to where it stops be free exactly.
  // Shares of the path: from the rounding of a path, in few steps, to the whole of it.
  for (double shortOf = 1e-9; shortOf < 1.0; shortOf *= 8)
  {
    const Vec3 stop_W = free_W + std::max(0.0, hit.t - shortOf) * (to_W - free_W);
    if (!sweepStraight(scene, plan, radius_u, free_W, stop_W, around).hit)
    {
      return stop_W;
    }
  }
  return free_W;
}

template<SceneView AnyScene>
bool carryWithVertices(
  const AnyScene& from, const AnyScene& to, const ContactPlan& plan, GodObjectState& state) noexcept
{
  const Vec3 start_W = state.x_W;
  const std::vector<Surface>&before = sceneOf(from).surfaces(), &after = sceneOf(to).surfaces();
  std::optional<std::uint32_t> carrier;
  bool keptApart = false;
  for (std::uint32_t i = 0; state.placed && i < before.size(); ++i)
  {
    const std::uint32_t now = successorOf(before, i, after);
    if (now == after.size() || !verticesMoved(from, i, to, now))
    {
      continue;
    }
    std::optional<Vec3> carried_W;
    if (after[now].tree->coat_u() > 0.0)
    {
      carried_W = carryWithCurve(from, to, i, now, plan, state.x_W, state.around);
    }
    else
    {
      Advection advection(from, to, i, now, plan, state.x_W, state.around);
      carried_W = advection.run();
      keptApart = keptApart || advection.keptApart();
    }
    if (carried_W)
    {
      state.x_W = *carried_W;
      carrier = i;
    }
  }
  if (carrier)
  {
    static_cast<void>(seatBall(to, plan, Vec3(state.x_W), state.x_W, &state.around));
  }
  dropTurnedFaces(to, state);
  return keptApart || (carrier && passesAnother(from, plan, *carrier, start_W, state.x_W));
}

template SweepHit sweepStraight(
  const Scene&, const ContactPlan&, double, const Vec3&, const Vec3&, const FacesAround*) noexcept;
template SweepHit sweepStraight(
  const MovingScene&, const ContactPlan&, double, const Vec3&, const Vec3&, const FacesAround*) noexcept;
template Vec3 stopBefore(
  const Scene&, const ContactPlan&, double, const Vec3&, const Vec3&, const FacesAround*) noexcept;
template Vec3 stopBefore(
  const MovingScene&, const ContactPlan&, double, const Vec3&, const Vec3&, const FacesAround*) noexcept;
template bool carryWithVertices(const Scene&, const Scene&, const ContactPlan&, GodObjectState&) noexcept;
template bool carryWithVertices(const MovingScene&, const MovingScene&, const ContactPlan&, GodObjectState&) noexcept;

} // namespace palpate
