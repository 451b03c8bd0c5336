// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "haptics/contact/moves/HoldingPlanes.h"
#include "haptics/contact/moves/RollMove.h"
#include "haptics/contact/moves/SlideMove.h"
#include "haptics/contact/moves/TickState.h"
#include "haptics/contact/moves/VertexMove.h"

namespace palpate
{

/// Passes beyond the cap, used only while the ball touches nothing. A ball that the cap stops in mid-air would feel
/// like lost contact; these passes bring the ball back to the surface.
inline constexpr std::uint32_t settlingPasses = 2;

/// The god-object without friction and shading: pass after pass the ball is projected, rolled or slid until it rests.
template<SceneView AnyScene>
class FrictionlessMove
{
public:
  FrictionlessMove(
    const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
    : tick_(scene, plan, p_W, state, sink)
  {
  }

  /// `landing`: ends as soon as anything is touched.
  ContactResult run(bool landing = false) noexcept
  {
    this->tick_.contacts.relinearise();
    for (std::uint32_t pass = 0;; ++pass)
    {
      this->tick_.result.passes = static_cast<int>(pass) + 1;
      project(this->tick_);
      this->leaveBorders();
      if (pass == 0 && this->standsBeside())
      {
        this->tick_.forgetContacts();
        continue;
      }
      reconsiderVertex(this->tick_);
      if (this->tick_.result.infeasible || this->tick_.rests())
      {
        if (this->goesOn())
        {
          continue;
        }
        break;
      }
      if (this->isCapped(pass))
      {
        break;
      }
      if (this->tick_.isBall() && rollBall(this->tick_))
      {
        continue;
      }
      if (!slideOn(this->tick_) || (landing && this->tick_.contacts.count() > 0))
      {
        break;
      }
    }
    this->comeIfFree();
    this->tick_.result.proxy_W = this->tick_.x();
    this->keepHeld();
    return this->tick_.result;
  }

  /// True if nothing at all lies between ball and device, touched or not: the supposed contacts do not hold the ball.
  [[nodiscard]] bool wayIsOpen() noexcept
  {
    if (this->tick_.x() == this->tick_.p_W || this->oneIsInTheWay())
    {
      return false;
    }
    const SweepHit hit = this->tick_.sweepPast({}, this->tick_.x(), this->tick_.p_W);
    return !hit.hit && hit.freeUntil >= 1.0;
  }

  /// True if a point may go straight towards the device, past every plane that it carries with it, for more than
  /// rounding makes of a way into a plane.
  [[nodiscard]] bool wayIsFree() noexcept
  {
    const Vec3 y = this->tick_.p_W - this->tick_.x();
    // A way that meets a plane at an angle a is tol deep after tol / sin a: at one degree after some 60 tol.
    const double much = 64 * this->tick_.tol(), way = y.norm();
    if (this->tick_.isBall() || way <= much)
    {
      return false;
    }
    const SweepHit hit = this->tick_.sweepOnce(this->tick_.x(), this->tick_.x() + y);
    return (hit.hit ? hit.t : hit.freeUntil) * way > much;
  }

private:
  /// True if one of the features that hold the ball is in the ball's way. Mostly one is, and then no sweep is needed.
  [[nodiscard]] bool oneIsInTheWay() const noexcept
  {
    const SweepQuery query = straightQuery(this->tick_.x(), this->tick_.p_W);
    const auto held = this->tick_.contacts.features();
    return std::any_of(held.begin(), held.end(),
      [&](const ActiveFeature& f)
      { return this->tick_.isBall() ? this->sinksInto(f) : meetsFace(this->tick_.scene, f, query); });
  }

  /// True if a ball on its straight way surely sinks deeper into face f than rounding, while still over the face.
  [[nodiscard]] bool sinksInto(const ActiveFeature& f) const noexcept
  {
    if (f.kind != FeatureKind::Face)
    {
      return false;
    }
    const FeaturePlane plane = this->tick_.contacts.plane(f);
    const Vec3 way = this->tick_.p_W - this->tick_.x();
    const double needs = plane.gap + 4 * this->tick_.tol(), sinks = -plane.n.dot(way);
    return sinks > needs &&
           projectsInside(this->tick_.contacts.surface(f), f.a, this->tick_.x() + needs / sinks * way, 0.0);
  }

  /// Leaves a face for its edge, and the edge for its end. Only once at a place: a ball that comes back there has gone
  /// in a circle.
  void leaveBorders() noexcept
  {
    if ((this->tick_.x() - this->bordersLeftAt_W_).norm() <= 4 * this->tick_.tol())
    {
      return;
    }
    for (int i = 0; i < 2 && leaveBorder(this->tick_); ++i)
    {
      this->bordersLeftAt_W_ = this->tick_.x();
      project(this->tick_);
    }
  }

  /// True if a point carries planes, and none of them is in its way.
  [[nodiscard]] bool standsBeside() noexcept
  {
    return !this->tick_.isBall() && this->tick_.solution.count > 0 && mayPassBesideAll(this->tick_) &&
           this->wayIsFree();
  }

  /// True if a seeming rest turns out to be none. Planes that contradict each other are no place to be.
  [[nodiscard]] bool goesOn() noexcept
  {
    if (this->tick_.result.infeasible ? startAnew(this->tick_) : lookAgain(this->tick_))
    {
      return true;
    }
    return this->tick_.startedAnew && goRoundVertex(this->tick_);
  }

  /// Planes say to within rounding where a point is held. Between planes at a sharp angle, or at a vertex that was met
  /// exactly, rounding decides wrongly. So no tick leaves a point where exact arithmetic sees nothing in its way.
  void comeIfFree() noexcept
  {
    if (!this->tick_.isBall() && !this->tick_.result.overBudget && this->wayIsOpen())
    {
      this->tick_.forgetContacts();
      this->tick_.solution = {};
      this->tick_.result.infeasible = false;
      this->tick_.moveTo(this->tick_.p_W);
    }
  }

  [[nodiscard]] bool isCapped(std::uint32_t pass) noexcept
  {
    const std::uint32_t cap = this->tick_.plan.passCap;
    this->tick_.result.capped = pass >= cap + settlingPasses || (pass >= cap && this->tick_.contacts.count() > 0);
    return this->tick_.result.capped;
  }

  void keepHeld() noexcept
  {
    const ProjectionResult& solution = this->tick_.solution;
    ContactResult& result = this->tick_.result;
    for (int k = 0; k < solution.count; ++k)
    {
      if (solution.lambda[k] > this->tick_.tol() && solution.active[k] < this->tick_.contacts.count())
      {
        result.held[static_cast<std::size_t>(result.heldCount++)] = { this->tick_.contacts.feature(solution.active[k]),
          solution.lambda[k] };
      }
    }
    result.contacts = result.heldCount;
  }

  TickState<AnyScene> tick_;
  Vec3 bordersLeftAt_W_ = nowhere_W();
};

} // namespace palpate
