// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/GodObject.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "haptics/contact/ContactSet.h"
#include "haptics/contact/Friction.h"
#include "haptics/contact/LeftFaces.h"
#include "haptics/contact/Neighbourhood.h"
#include "haptics/contact/PlanFor.h"
#include "haptics/contact/PosedSurface.h"
#include "haptics/contact/Roll.h"
#include "haptics/contact/Seat.h"
#include "haptics/contact/Shading.h"
#include "haptics/contact/SurfaceResponse.h"
#include "haptics/contact/Sweep.h"
#include "haptics/contact/VertexDescent.h"

namespace palpate
{
namespace
{

/// Passes beyond the cap, used only while the ball touches nothing: they bring it back to contact.
constexpr std::uint32_t settlingPasses = 2;
/// In radii of the roundest thing that is touched: of a way longer than longWay the first firstPart is looked at alone; mostly it ends there.
constexpr double longWay = 0.2;
constexpr double firstPart = 0.02;
/// Attempts to stop a point just before what it hits, each a little further off.
constexpr int stopAttempts = 6;

/// What limits a straight slide: how far every holding feature supports it, and which one ends first.
struct Slide
{
  double t = 1.0;
  int ends = -1;              ///< index of the feature that is left at t, or -1
  ActiveFeature successor;    ///< the edge or vertex over which it is left
  std::uint32_t lastFace = 0; ///< the face from which that edge was reached
};

template<class SceneView>
class Tick
{
public:
  Tick(const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
    : scene_(scene), plan_(plan), p_W_(p_W), start_W_(state.x_W), state_(state), sink_(sink),
      scale_u_(plan.radius_u + sceneOf(scene).leastCoat_u()), contacts_(scene, plan.radius_u, state)
  {
    this->contacts_.include(p_W);
  }

  /// `landing`: ends as soon as anything is touched.
  ContactResult run(bool landing = false) noexcept
  {
    this->contacts_.relinearise();
    for (std::uint32_t pass = 0;; ++pass)
    {
      this->result_.passes = static_cast<int>(pass) + 1;
      this->project();
      this->reconsiderVertex();
      if (this->result_.infeasible && !this->startedAnew_)
      {
        this->startAnew();
        continue;
      }
      if (!this->result_.infeasible && this->solution_.y.norm() <= this->tol() && this->lookAgain())
      {
        continue;
      }
      if (this->result_.infeasible || this->solution_.y.norm() <= this->tol())
      {
        break;
      }
      if (pass >= this->plan_.passCap + settlingPasses || (pass >= this->plan_.passCap && this->contacts_.count() > 0))
      {
        this->result_.capped = true;
        break;
      }
      if (this->round() && this->roll())
      {
        continue;
      }
      if (!this->slide() || (landing && this->contacts_.count() > 0))
      {
        break;
      }
    }
    this->result_.proxy_W = this->state_.x_W;
    this->keepHeld();
    return this->result_;
  }

  /// True if a point may go straight towards the device, whatever planes it carries with it.
  [[nodiscard]] bool wayIsFree() noexcept { return !this->round() && this->isFree(this->p_W_ - this->x()); }

private:
  [[nodiscard]] bool round() const noexcept { return this->plan_.radius_u > 0.0; }
  [[nodiscard]] double tol() const noexcept { return this->contacts_.resolution().tol(); }
  [[nodiscard]] double del() const noexcept { return this->contacts_.resolution().del(); }
  [[nodiscard]] const Vec3& x() const noexcept { return this->state_.x_W; }

  void keepHeld() noexcept
  {
    for (int k = 0; k < this->solution_.count; ++k)
    {
      if (this->solution_.lambda[k] > this->tol() && this->solution_.active[k] < this->contacts_.count())
      {
        this->result_.held[static_cast<std::size_t>(this->result_.heldCount++)] = {
          this->contacts_.feature(this->solution_.active[k]), this->solution_.lambda[k]
        };
      }
    }
    this->result_.contacts = this->result_.heldCount;
  }

  /// Planes that contradict each other are no place to be: what holds the ball is found anew by sweeps, once a tick.
  void startAnew() noexcept
  {
    this->state_.count = 0;
    this->left_.clear();
    this->result_.infeasible = false;
    this->startedAnew_ = true;
  }

  /// Nearest point under the touched planes and those left faces that turn out to obstruct it.
  void project() noexcept
  {
    bool again = true;
    while (again)
    {
      this->solution_ = this->contacts_.solve(this->p_W_ - this->x(), this->contacts_.lift());
      again = false;
      for (int i = 0; i < this->left_.count() && !again; ++i)
      {
        if (this->obstructs(this->left_[i].face, this->solution_.y))
        {
          this->contacts_.add(this->left_[i].face);
          this->left_.remove(i);
          again = true;
        }
      }
    }
    this->result_.infeasible = !this->solution_.feasible;
  }

  /// A left face obstructs if the way dips into its plane and leads back over it.
  [[nodiscard]] bool obstructs(const ActiveFeature& f, const Vec3& y) const noexcept
  {
    const auto& s = this->contacts_.surface(f);
    if (f.side * s.face(f.a).normal_W.dot(y) >= 0.0)
    {
      return false;
    }
    for (int k = 0; k < 3; ++k)
    {
      if (outsideOfEdge(s, f.a, k, this->x()) > -8 * this->del() && outwardNormal(s, f.a, k).dot(y) > 0.0)
      {
        return false;
      }
    }
    return true;
  }

  /// A long way of a ball is looked at in two parts: mostly it ends soon, and the first part is cheap.
  [[nodiscard]] SweepHit sweep(const Vec3& from_W, const Vec3& to_W) noexcept
  {
    const double length = (to_W - from_W).norm();
    if (length > longWay * this->scale_u_ && this->round())
    {
      const double part = firstPart * this->scale_u_ / length;
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

  [[nodiscard]] SweepHit sweepOnce(const Vec3& from_W, const Vec3& to_W) noexcept
  {
    SweepQuery query;
    query.from_W = from_W;
    query.to_W = to_W;
    query.radius_u = this->plan_.radius_u;
    query.resolution = this->contacts_.resolution();
    query.resolution.include(to_W);
    if (this->round())
    {
      query.touched = this->contacts_.features();
    }
    const std::uint32_t left = this->plan_.nodeBudget - std::min(this->plan_.nodeBudget, this->result_.nodes);
    // Half of the ticks need one sweep only: gathering what is around pays from the second on.
    const bool gather = this->result_.sweeps >= 1 && (to_W - from_W).norm() <= longWay * this->scale_u_;
    const SweepHit hit = sweepBall(this->scene_, query, left, gather ? &this->near_ : nullptr);
    ++this->result_.sweeps;
    this->result_.nodes += hit.nodes;
    this->result_.overBudget |= hit.freeUntil < 1.0;
    return hit;
  }

  void moveTo(const Vec3& to_W) noexcept
  {
    const Vec3 start_W = this->x();
    this->moveOver(start_W, to_W);
  }

  /// A move over a corner: the way has two pieces, the bookkeeping is done once.
  void moveOver(const Vec3& corner_W, const Vec3& to_W) noexcept
  {
    if (this->sink_ != nullptr)
    {
      if (corner_W != this->x())
      {
        this->sink_->segment(this->x(), corner_W);
      }
      this->sink_->segment(corner_W, to_W);
    }
    const Vec3 from_W = this->x();
    const Vec3 moved = to_W - from_W;
    this->state_.x_W = to_W;
    this->contacts_.include(to_W);
    this->contacts_.advanceFaces(from_W, moved);
    if (moved.norm() > 4 * this->tol())
    {
      for (int i = 0; i < this->contacts_.count(); ++i)
      {
        this->contacts_.feature(i).stuck = false;
      }
    }
  }

  void settle(const ActiveFeature* keep = nullptr) noexcept
  {
    this->contacts_.relinearise(keep);
    for (int i = this->left_.count() - 1; i >= 0; --i)
    {
      if (!this->contacts_.supported(this->left_[i].face))
      {
        this->left_.remove(i);
      }
    }
  }

  /// Rolls round an edge or a vertex if that brings the ball nearer to the device; false if a plain slide is due.
  [[nodiscard]] bool roll() noexcept
  {
    double turn = 2.0;
    for (const double mostTurn : { 1.0, 0.2, 0.04 })
    {
      if (mostTurn >= turn)
      {
        continue; // the last plan turned less than that already
      }
      const RollPlan plan =
        RollPlanner<SceneView>(this->contacts_, this->x(), this->p_W_, this->plan_.radius_u, this->solution_, mostTurn)
          .plan();
      if (!plan.worthwhile)
      {
        return false;
      }
      if (this->tryRoll(plan))
      {
        return true;
      }
      turn = plan.turn;
    }
    return false;
  }

  [[nodiscard]] bool tryRoll(const RollPlan& plan) noexcept
  {
    const Vec3 corner_W = this->x() + plan.first;
    Vec3 end_W = this->x() + plan.second;
    const SweepHit first = this->sweep(this->x(), corner_W);
    if (first.hit && first.t * plan.first.norm() <= this->tol())
    {
      this->contacts_.add(first.feature); // it is touched already: the next projection takes it into account
      return true;
    }
    if (first.freeUntil < 1.0)
    {
      return false;
    }
    if (first.hit)
    {
      end_W = this->x() + first.t * plan.first;
      return this->commitRoll(end_W, end_W, first, 0.0);
    }
    const SweepHit second = this->sweep(corner_W, end_W);
    if (second.freeUntil < 1.0)
    {
      return false;
    }
    if (second.hit)
    {
      end_W = corner_W + second.t * (end_W - corner_W);
    }
    return this->commitRoll(corner_W, end_W, second, plan.tolerance_u2);
  }

  /// True if the ball would lie deeper than rounding in a touched feature, which sweeps leave out.
  [[nodiscard]] bool wouldOverlap(const Vec3& end_W) const noexcept
  {
    for (const ActiveFeature& f : this->contacts_.features())
    {
      const bool under = f.kind != FeatureKind::Face || projectsInside(this->contacts_.surface(f), f.a, end_W, 0.0);
      if (under && planeOf(this->contacts_.surface(f), f, end_W, this->plan_.radius_u).gap < -this->tol())
      {
        return true;
      }
    }
    return false;
  }

  /// Takes the way over the corner if it ends nearer to the device.
  [[nodiscard]] bool commitRoll(
    const Vec3& corner_W, const Vec3& end_W, const SweepHit& hit, double tolerance_u2) noexcept
  {
    if (this->wouldOverlap(corner_W) || this->wouldOverlap(end_W))
    {
      return false;
    }
    if ((end_W - this->p_W_).squaredNorm() >= (this->x() - this->p_W_).squaredNorm() + tolerance_u2)
    {
      return false;
    }
    this->moveOver(corner_W, end_W);
    this->touch(hit);
    return true;
  }

  /// Adds what was hit, if anything, and drops what no longer holds.
  void touch(const SweepHit& hit) noexcept
  {
    if (hit.hit)
    {
      this->contacts_.add(hit.feature);
    }
    this->settle(hit.hit ? &hit.feature : nullptr);
  }

  /// How far feature i supports a slide along y, and what a ball comes to lie on there.
  [[nodiscard]] Slide limitBy(int i, const Vec3& y) noexcept
  {
    const ActiveFeature& f = this->contacts_.feature(i);
    const auto& s = this->contacts_.surface(f);
    Slide slide{ 1.0, i, f };
    if (f.kind == FeatureKind::Face)
    {
      const FaceExit exit = walkFace(s, f.a, this->x(), y, this->del());
      slide.t = exit.t;
      slide.successor = { f.surface, exit.i, exit.j, FeatureKind::Edge, 1, false };
      slide.lastFace = exit.triangle;
      return slide;
    }
    slide.t = exitRound(s, f, this->x(), y, this->plan_.radius_u, this->del());
    if (f.kind == FeatureKind::Edge)
    {
      const std::uint32_t end = edgeLine(s, f.a, f.b).unit.dot(y) > 0.0 ? f.b : f.a;
      slide.successor = { f.surface, end, 0, FeatureKind::Vertex, 1, false };
    }
    return slide;
  }

  [[nodiscard]] Slide limitSlide() noexcept
  {
    Slide least;
    const Vec3& y = this->solution_.y;
    for (int k = 0; k < this->solution_.count; ++k)
    {
      const int i = this->solution_.active[k];
      const ActiveFeature& f = this->contacts_.feature(i);
      if (this->solution_.lambda[k] <= 0.0)
      {
        continue;
      }
      Slide slide = this->limitBy(i, y);
      if (f.stuck && slide.t * y.norm() <= 4 * this->tol())
      {
        const FaceRecord& face = this->contacts_.surface(f).face(f.a);
        slide = { 1e-4 * (face.corner_W[1] - face.corner_W[0]).norm() / y.norm(), -1, f };
      }
      if (slide.t < least.t)
      {
        least = slide;
      }
    }
    return least;
  }

  /// A point at a vertex is held by half-spaces, of which on a saddle not each is an obstacle, and which of them it
  /// brought along depends on its way there. What holds it is found anew from the surface itself, once at each place.
  void reconsiderVertex() noexcept
  {
    if (this->round() || this->solution_.count == 0 || this->x() == this->reconsideredAt_W_)
    {
      return;
    }
    for (int k = 0; k < this->solution_.count; ++k)
    {
      const ActiveFeature f = this->contacts_.feature(this->solution_.active[static_cast<std::size_t>(k)]);
      const auto& s = this->contacts_.surface(f);
      const std::uint32_t v = cornerAt(s, f, this->x(), this->tol());
      if (v == SurfaceData::none)
      {
        continue;
      }
      this->reconsideredAt_W_ = this->x();
      const std::optional<Descent> descent = descendFromVertex(s, f, v, this->x(), this->p_W_ - this->x());
      if (descent && descent->gain > this->tol())
      {
        this->state_.count = 0;
        this->left_.clear();
        for (int i = 0; i < descent->count; ++i)
        {
          this->contacts_.add(descent->faces[static_cast<std::size_t>(i)]);
        }
        this->project();
      }
      return;
    }
  }

  /// A point that rests in a corner of planes may be held by one of a face that is not there: it stands beside the face
  /// by less than rounding. Where it has not moved in a tick the planes are found anew from the faces themselves, in exact
  /// arithmetic; in a tick that moves this would cost more than it could find.
  [[nodiscard]] bool lookAgain() noexcept
  {
    constexpr double hardly = 1e-6; // of the way to the device; nothing here may depend on rounding
    const double moved = (this->x() - this->start_W_).norm(), left = (this->p_W_ - this->x()).norm();
    if (this->round() || this->solution_.count < 2 || this->startedAnew_ || moved > hardly * left)
    {
      return false;
    }
    this->startAnew();
    return true;
  }

  /// True if a point may go along y for more than what rounding makes of a way into a plane.
  [[nodiscard]] bool isFree(const Vec3& y) noexcept
  {
    const double much = 64 * this->tol(), way = y.norm();
    if (way <= much)
    {
      return false;
    }
    const SweepHit hit = this->sweepOnce(this->x(), this->x() + y);
    return (hit.hit ? hit.t : hit.freeUntil) * way > much;
  }

  /// Slides under the touched planes to the last supported point or to the next obstacle. False: the tick is over.
  [[nodiscard]] bool slide() noexcept
  {
    const Slide limit = this->limitSlide();
    const bool straight = this->solution_.count == 0 && limit.t >= 1.0;
    const Vec3 to_W = straight ? this->p_W_ : Vec3(this->x() + limit.t * this->solution_.y);
    const SweepHit hit = this->sweep(this->x(), to_W);
    if (hit.freeUntil < 1.0 && !hit.hit)
    {
      if (this->round())
      {
        this->moveTo(this->x() + hit.freeUntil * (to_W - this->x()));
        this->settle();
      }
      return false;
    }
    if (hit.hit)
    {
      this->round() ? this->stopBall(hit, to_W) : this->stopPoint(hit, to_W);
      return !this->result_.overBudget;
    }
    this->moveTo(to_W);
    if (limit.ends >= 0)
    {
      this->leave(limit);
    }
    this->settle();
    return !(this->contacts_.count() == 0 && this->x() == this->p_W_);
  }

  /// A ball that slides off a face lies on its edge, off an edge on its end; a point comes over the next face.
  void leave(const Slide& limit) noexcept
  {
    const ActiveFeature left = this->contacts_.feature(limit.ends);
    this->contacts_.remove(limit.ends);
    if (this->round())
    {
      this->contacts_.add(limit.successor);
      return;
    }
    this->left_.add(left, this->x());
    const auto& s = this->contacts_.surface(left);
    ActiveFeature next = left;
    next.a = s.neighbour(limit.lastFace, limit.successor.a, limit.successor.b);
    if (next.a != SurfaceData::none)
    {
      next.side = static_cast<std::int8_t>(sideOf(s, next.a, this->x()));
      if (next.side != 0)
      {
        this->contacts_.add(next); // settle() drops it again where it does not hold
      }
    }
  }

  void stopBall(const SweepHit& hit, const Vec3& to_W) noexcept
  {
    this->moveTo(this->x() + hit.t * (to_W - this->x()));
    this->touch(hit);
  }

  /// Stops a point just before what it hits. Each committed way is one that the exact sweep found free.
  void stopPoint(const SweepHit& hit, const Vec3& to_W) noexcept
  {
    const Vec3 wanted = hit.t * (to_W - this->x());
    this->returnStuck(hit.feature, wanted);
    SweepHit next = hit;
    double lift = this->contacts_.lift();
    for (int attempt = 0; attempt < stopAttempts; ++attempt, lift *= 2)
    {
      this->contacts_.add(next.feature);
      const ProjectionResult stop = this->contacts_.solve(wanted, lift);
      if (!stop.feasible)
      {
        break;
      }
      const Vec3 end_W = this->x() + stop.y;
      next = this->sweep(this->x(), end_W);
      if (next.freeUntil < 1.0)
      {
        break;
      }
      if (!next.hit)
      {
        this->moveTo(end_W);
        this->settle(&hit.feature);
        return;
      }
    }
  }

  /// A face left here and hit again without progress comes back, with all that were left after it.
  void returnStuck(const ActiveFeature& f, const Vec3& wanted) noexcept
  {
    for (int i = 0; i < this->left_.count(); ++i)
    {
      const LeftFaces::Entry& entry = this->left_[i];
      const double near = 4 * this->tol();
      if (entry.face.surface == f.surface && entry.face.a == f.a && (this->x() - entry.leftAt_W).norm() <= near &&
          wanted.norm() <= near)
      {
        for (int j = i; j < this->left_.count(); ++j)
        {
          ActiveFeature back = this->left_[j].face;
          back.stuck = true;
          this->contacts_.add(back);
        }
        this->left_.clear();
        return;
      }
    }
  }

  const SceneView& scene_;
  const ContactPlan& plan_;
  const Vec3 p_W_;
  const Vec3 start_W_; ///< where the ball was before
  GodObjectState& state_;
  PathSink* sink_;
  const double scale_u_; ///< ball and thinnest curve: what a way is long or short against
  ContactSet<SceneView> contacts_;
  LeftFaces left_;
  Vec3 reconsideredAt_W_ = Vec3::Constant(std::numeric_limits<double>::infinity());
  Neighbourhood near_;
  ProjectionResult solution_;
  ContactResult result_;
  bool startedAnew_ = false;
};

/// A ball in the air first lands; where it lands friction decides what becomes of the rest of the way.
template<class SceneView>
ContactResult moveUnderFriction(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  FrictionVerdict verdict = judgeFriction(scene, plan, p_W, state);
  ContactResult landing;
  if (verdict.motion == FrictionMotion::None)
  {
    landing = Tick(scene, plan, p_W, state, sink).run(true);
    if (state.count == 0 || landing.capped || landing.overBudget || landing.infeasible)
    {
      return landing;
    }
    verdict = judgeFriction(scene, plan, p_W, state);
  }
  if (verdict.motion == FrictionMotion::Sticks && Tick(scene, plan, p_W, state, sink).wayIsFree())
  {
    state.count = 0; // it stands beside what seems to hold it
    return Tick(scene, plan, p_W, state, sink).run();
  }
  ContactResult result;
  result.proxy_W = state.x_W;
  result.held = verdict.held;
  result.heldCount = result.contacts = verdict.contacts;
  if (verdict.motion != FrictionMotion::Sticks)
  {
    result = Tick(scene, plan, verdict.pulled_W, state, sink).run();
    if (state.count == 0)
    {
      result = Tick(scene, plan, p_W, state, sink).run(); // it left the surface: nothing drags any more
    }
  }
  result.friction = verdict.motion;
  result.passes += landing.passes;
  result.sweeps += landing.sweeps;
  result.nodes += landing.nodes;
  return result;
}

template<class SceneView>
ContactResult moveUnshaded(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  return frictionMatters(scene, plan) ? moveUnderFriction(scene, plan, p_W, state, sink)
                                      : Tick(scene, plan, p_W, state, sink).run();
}

/// What holds the ball where it is, for a device at p.
template<class SceneView>
void holdShaded(const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state,
  ContactResult& result) noexcept
{
  ContactSet<SceneView> contacts(scene, plan.radius_u, state);
  contacts.include(p_W);
  contacts.relinearise();
  result.proxy_W = state.x_W;
  result.heldCount = result.contacts =
    listHeld(contacts, contacts.solve(p_W - state.x_W, contacts.lift()), result.held);
}

/// A few rounds bring the ball to where the shaded force is at rest.
template<class SceneView>
ContactResult moveShaded(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  constexpr int mostRounds = 4;
  ContactResult result;
  const auto add = [&result](ContactResult more)
  {
    more.passes += result.passes;
    more.sweeps += result.sweeps;
    more.nodes += result.nodes;
    result = more;
  };
  bool slipping = false, settled = false;
  for (int round = 0; round < mostRounds && !settled; ++round)
  {
    const ShadedStep step = judgeShading(scene, plan, p_W, slipping, state);
    slipping = step.motion == FrictionMotion::Slips;
    if (!step.touches)
    {
      add(moveUnshaded(scene, plan, p_W, state, sink));
    }
    else if (!step.rests)
    {
      add(Tick(scene, plan, step.target_W, state, sink).run());
      result.friction = step.motion;
    }
    else
    {
      result.friction = step.motion;
    }
    settled = (step.touches ? step.rests : state.count == 0) || result.capped || result.overBudget;
  }
  holdShaded(scene, plan, p_W, state, result);
  return result;
}

template<class SceneView>
ContactResult move(
  const SceneView& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  if (!state.placed)
  {
    state.count = 0;
    if (!seatBall(scene, plan.radius_u, p_W, state.x_W))
    {
      ContactResult refused;
      refused.proxy_W = p_W;
      refused.seatFailed = true;
      return refused;
    }
    state.placed = true;
    state.device_W = p_W;
  }
  ContactResult result =
    plan.shading ? moveShaded(scene, plan, p_W, state, sink) : moveUnshaded(scene, plan, p_W, state, sink);
  result.pull_W = result.proxy_W - p_W;
  result.held_u2 = result.pull_W.squaredNorm();
  if (sceneOf(scene).hasMaterials())
  {
    const Response response = respond(scene, plan, result, p_W, p_W - state.device_W);
    result.pull_W = response.pull_W;
    result.held_u2 = response.held_u2;
  }
  state.device_W = p_W;
  return result;
}

} // namespace

ContactResult moveGodObject(
  const Scene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  if (scene.moves())
  {
    return moveGodObject(MovingScene(scene, 1.0), plan, p_W, state, sink);
  }
  return move(scene, planFor(sceneOf(scene), plan), p_W, state, sink);
}

ContactResult moveGodObject(
  const MovingScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  return move(scene, planFor(sceneOf(scene), plan), p_W, state, sink);
}

} // namespace palpate
