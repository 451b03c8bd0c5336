// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "haptics/contact/moves/DepartedFaces.h"
#include "haptics/contact/planes/ContactSet.h"
#include "haptics/contact/planes/VertexFan.h"
#include "haptics/contact/sweep/KeptFaces.h"
#include "haptics/contact/sweep/Neighbourhood.h"
#include "haptics/contact/sweep/Sweep.h"
#include "haptics/contact/sweep/Work.h"
#include "haptics/contact/view/SceneView.h"

namespace palpate
{

/// In radii of the roundest thing that is touched: of a way longer than longWay the first firstPart is looked at alone.
/// Both were found by trying on a noisy sphere at 100 mm/s, where most sweeps of a tick end within the first part.
inline constexpr double longWay = 0.2;
inline constexpr double firstPart = 0.02;

/// Far from every place.
[[nodiscard]] inline Vec3 nowhere_W() noexcept
{
  return Vec3::Constant(std::numeric_limits<double>::infinity());
}

/// State shared by the moves of one tick: the ball, its contacts, and the work so far.
/// Only for the moves of a tick. Servo thread; no allocation.
template<SceneView AnyScene>
struct TickState
{
  TickState(
    const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
    : scene(scene), plan(plan), p_W(p_W), start_W(state.x_W), state(state), sink(sink),
      scale_u(plan.radius_u + sceneOf(scene).leastCoat_u()), contacts(scene, plan.radius_u, state)
  {
    this->contacts.include(p_W);
    openKept(scene, state.around);
  }

  [[nodiscard]] bool isBall() const noexcept { return this->plan.radius_u > 0.0; }
  [[nodiscard]] double tol() const noexcept { return this->contacts.resolution().tol(); }
  [[nodiscard]] double del() const noexcept { return this->contacts.resolution().del(); }
  [[nodiscard]] const Vec3& x() const noexcept { return this->state.x_W; }
  /// True if the planes that hold the ball leave no way on, or only one that rounding makes up. Two planes at a small
  /// angle give the line in which they meet far less exactly than each gives its own place. So a ball rests where this
  /// way and the last one are both within that error.
  [[nodiscard]] bool rests() const noexcept
  {
    // In passes. Far from the origin a way between planes at small angles is not over at the size of tol: a point
    // first goes on until its way is down to the rounding of one coordinate. Settled contact takes 2 or 3 passes; a
    // point that still moves after these goes to and fro.
    constexpr int patience = 12;
    const double way_u = this->solution.y.norm();
    if (!this->isBall() && this->result.passes <= patience)
    {
      return way_u <= this->del();
    }
    const double ways_u = std::max(way_u, this->lastWay_u);
    return way_u <= this->tol() || (ways_u <= this->contacts.resolution().mostError() && ways_u <= this->blur_u());
  }
  /// Error that rounding makes of the place where the planes meet that hold the ball [u]. The error is 0 while the
  /// ball still has to move along the line in which two planes meet: that distance is no error of theirs.
  [[nodiscard]] double blur_u() const noexcept;

  /// The first contact on the way. A long way of a ball is looked at in two parts: most ways end soon, and the first
  /// part is cheap.
  [[nodiscard]] SweepHit sweep(const Vec3& from_W, const Vec3& to_W) noexcept;
  /// The longest way round which there are few enough faces to gather them [u]. For a ball it is a share of the ball's
  /// radius, for a point about the size of the touched face.
  [[nodiscard]] double gatheredWay_u() const noexcept;
  /// A list that covers the way, if there is one; `work` says how much it took to make it.
  [[nodiscard]] const FaceList* listFor(const SweepQuery& query, std::uint32_t budget, std::uint32_t& work) noexcept;
  [[nodiscard]] SweepHit sweepOnce(const Vec3& from_W, const Vec3& to_W) noexcept;
  /// The same for a way past features that are known to be touched.
  [[nodiscard]] SweepHit sweepPast(
    std::span<const ActiveFeature> touched, const Vec3& from_W, const Vec3& to_W) noexcept;
  void moveTo(const Vec3& to_W) noexcept;
  /// A move over a corner: the way has two pieces, the bookkeeping is done once.
  void moveOver(const Vec3& corner_W, const Vec3& to_W) noexcept;
  /// The faces round vertex v as seen from face f, a face at v: asked for again and again while a point is near v.
  [[nodiscard]] const VertexFan& fanAt(const ActiveFeature& f, std::uint32_t v) noexcept;
  /// Counts a look round all vertices that are touched.
  void countFans() noexcept;
  /// Drops contacts that no longer hold, never `keep`.
  void settle(const ActiveFeature* keep = nullptr) noexcept;
  /// Adds a new contact, if there is one, and drops contacts that no longer hold.
  void touch(const SweepHit& hit) noexcept;
  void forgetContacts() noexcept;

  const AnyScene& scene;
  const ContactPlan& plan;
  const Vec3 p_W;
  const Vec3 start_W; ///< where the ball was before
  GodObjectState& state;
  PathSink* sink;
  const double scale_u; ///< ball and thinnest curve: the scale for long and short paths
  ContactSet<AnyScene> contacts;
  DepartedFaces left;
  Vec3 reconsideredAt_W = nowhere_W(); ///< where the holders of a point at a vertex were last looked for
  int reconsidered = 0;                ///< how often they were looked for there
  double lastWay_u = 0.0;              ///< length of the last move
  bool crowded = false;                ///< the faces around are too many for a list
  std::optional<VertexFan> fan;        ///< the last one that fanAt() was asked for; large, and most ticks ask for none
  std::uint32_t fanVertex = SurfaceData::none, fanSurface = SurfaceData::none;
  ProjectionResult solution;
  ContactResult result;
  bool startedAnew = false;
  bool bypassed = false;
};

template<SceneView AnyScene>
SweepHit TickState<AnyScene>::sweep(const Vec3& from_W, const Vec3& to_W) noexcept
{
  const double length = (to_W - from_W).norm();
  if (length > longWay * this->scale_u && this->isBall())
  {
    const double part = firstPart * this->scale_u / length;
    SweepHit hit = this->sweepOnce(from_W, from_W + part * (to_W - from_W));
    if (hit.hit || hit.freeUntil < 1.0)
    {
      hit.t *= part;
      hit.freeUntil = hit.freeUntil < 1.0 ? hit.freeUntil * part : 1.0;
      return hit;
    }
  }
  return this->sweepOnce(from_W, to_W);
}

template<SceneView AnyScene>
double TickState<AnyScene>::gatheredWay_u() const noexcept
{
  if (this->isBall() || this->contacts.count() == 0)
  {
    return longWay * this->scale_u;
  }
  const ActiveFeature& f = this->contacts.features().front();
  const auto& [a, b, c] = cornersIn(this->contacts.surface(f), f.a);
  return std::max((b - a).cwiseAbs().maxCoeff(), (c - a).cwiseAbs().maxCoeff());
}

template<SceneView AnyScene>
SweepHit TickState<AnyScene>::sweepOnce(const Vec3& from_W, const Vec3& to_W) noexcept
{
  const auto touched = this->isBall() ? this->contacts.features() : std::span<const ActiveFeature>();
  return this->sweepPast(touched, from_W, to_W);
}

template<SceneView AnyScene>
const FaceList* TickState<AnyScene>::listFor(
  const SweepQuery& query, std::uint32_t budget, std::uint32_t& work) noexcept
{
  const SweptBall m = sweptBallOf(query);
  FacesAround& around = this->state.around;
  const FaceList* const kept = keptFor(this->scene, m, around, work);
  // Half of the ticks need one sweep only: gathering the surroundings is worthwhile from the second on.
  if (kept != nullptr || this->crowded || this->result.sweeps == 0 || m.length > this->gatheredWay_u())
  {
    return kept;
  }
  this->crowded = !gatherFaces(
    this->scene, Moments::Now, reachFor(m), query.resolution, FaceList::capacity, budget, work, around.near);
  return this->crowded ? nullptr : &around.near;
}

template<SceneView AnyScene>
SweepHit TickState<AnyScene>::sweepPast(
  std::span<const ActiveFeature> touched, const Vec3& from_W, const Vec3& to_W) noexcept
{
  SweepQuery query;
  query.from_W = from_W;
  query.to_W = to_W;
  query.radius_u = this->plan.radius_u;
  query.resolution = this->contacts.resolution();
  query.resolution.include(to_W);
  query.touched = touched;
  const std::uint32_t left = this->plan.workBudget - std::min(this->plan.workBudget, this->result.work);
  std::uint32_t listing = 0;
  const FaceList* const list = this->listFor(query, left, listing);
  SweepHit hit = list != nullptr ? sweepListed(this->scene, query, *list, left - std::min(left, listing))
                                 : sweepBall(this->scene, query, left - std::min(left, listing));
  hit.work += listing;
  ++this->result.sweeps;
  this->result.work += hit.work;
  this->result.overBudget |= hit.freeUntil < 1.0;
  return hit;
}

template<SceneView AnyScene>
void TickState<AnyScene>::moveTo(const Vec3& to_W) noexcept
{
  const Vec3 from_W = this->x();
  this->moveOver(from_W, to_W);
}

template<SceneView AnyScene>
void TickState<AnyScene>::moveOver(const Vec3& corner_W, const Vec3& to_W) noexcept
{
  if (this->sink != nullptr)
  {
    if (corner_W != this->x())
    {
      this->sink->segment(this->x(), corner_W);
    }
    this->sink->segment(corner_W, to_W);
  }
  const Vec3 from_W = this->x();
  const Vec3 moved = to_W - from_W;
  this->lastWay_u = moved.norm();
  this->state.x_W = to_W;
  this->contacts.include(to_W);
  this->contacts.advanceFaces(from_W, moved);
  if (this->lastWay_u > 4 * this->tol()) // less is no progress: rounding moves a ball as far
  {
    for (int i = 0; i < this->contacts.count(); ++i)
    {
      this->contacts.feature(i).stuck = false;
    }
  }
}

template<SceneView AnyScene>
double TickState<AnyScene>::blur_u() const noexcept
{
  const auto normal = [this](std::size_t k)
  { return this->contacts.plane(this->contacts.features()[static_cast<std::size_t>(this->solution.active[k])]).n; };
  if (this->solution.count < 2)
  {
    return 0.0;
  }
  const Vec3 a = normal(0), b = normal(1), ab = a.cross(b);
  if (this->solution.count == 2)
  {
    const bool goesAlong = std::fabs(ab.dot(this->solution.y)) > this->tol() * ab.norm();
    return goesAlong ? 0.0 : 2 * this->del() / ab.norm();
  }
  const Vec3 c = normal(2), bc = b.cross(c), ca = c.cross(a);
  return this->del() * (ab.norm() + bc.norm() + ca.norm()) / std::fabs(a.dot(bc));
}

template<SceneView AnyScene>
const VertexFan& TickState<AnyScene>::fanAt(const ActiveFeature& f, std::uint32_t v) noexcept
{
  if (v != this->fanVertex || f.surface != this->fanSurface || !this->fan || !this->fan->has(f))
  {
    this->fan = fanAround(this->contacts.surface(f), f, v, FreeEdge::Ends);
    this->fanVertex = v;
    this->fanSurface = f.surface;
  }
  return *this->fan;
}

template<SceneView AnyScene>
void TickState<AnyScene>::countFans() noexcept
{
  for (const ActiveFeature& f : this->contacts.features())
  {
    this->result.work += fanOf(this->contacts.surface(f), f) / work::fanSteps;
  }
}

template<SceneView AnyScene>
void TickState<AnyScene>::settle(const ActiveFeature* keep) noexcept
{
  this->countFans();
  this->contacts.relinearise(keep);
  for (int i = this->left.count() - 1; i >= 0; --i)
  {
    if (!this->contacts.supported(this->left[i].face))
    {
      this->left.remove(i);
    }
  }
}

template<SceneView AnyScene>
void TickState<AnyScene>::touch(const SweepHit& hit) noexcept
{
  if (hit.hit)
  {
    this->contacts.add(hit.feature);
  }
  this->settle(hit.hit ? &hit.feature : nullptr);
}

template<SceneView AnyScene>
void TickState<AnyScene>::forgetContacts() noexcept
{
  this->state.count = 0;
  this->left.clear();
}

} // namespace palpate
