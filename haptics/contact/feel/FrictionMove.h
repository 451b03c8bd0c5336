// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/feel/Friction.h"
#include "haptics/contact/moves/FrictionlessMove.h"

namespace palpate
{

/// One tick under friction. The motion that friction allows is computed anew at the end of each step: after a step over
/// a bend the ball is held by other planes than those by which friction was judged.
template<SceneView AnyScene>
class FrictionMove
{
public:
  FrictionMove(
    const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
    : scene_(scene), plan_(plan), p_W_(p_W), state_(state), sink_(sink)
  {
  }

  [[nodiscard]] ContactResult run() noexcept
  {
    FrictionVerdict verdict = this->judged();
    bool falls = false;
    for (int step = 0; step < mostSteps && verdict.motion != FrictionState::Sticks; ++step)
    {
      const bool slides = verdict.motion == FrictionState::Slips, fellBefore = falls;
      falls = !slides;
      this->go(verdict.pulled_W, falls && !fellBefore);
      if (slides && (this->state_.count == 0 || this->tickTo(this->p_W_).wayIsOpen()))
      {
        return this->goFreely();
      }
      if (this->isOver() || (falls && fellBefore))
      {
        return this->end(slides);
      }
      verdict = this->judged();
      if (slides && verdict.motion == FrictionState::Sticks)
      {
        return this->end(true);
      }
    }
    return verdict.motion == FrictionState::Sticks ? this->stick(verdict) : this->end(true);
  }

private:
  /// Bounds the work: where friction does not converge in so many steps, the next tick goes on.
  static constexpr int mostSteps = 16;

  [[nodiscard]] FrictionlessMove<AnyScene> tickTo(const Vec3& p_W) noexcept
  {
    return { this->scene_, this->plan_, p_W, this->state_, this->sink_ };
  }

  [[nodiscard]] FrictionVerdict judged() noexcept
  {
    return judgeFriction(this->scene_, this->plan_, this->p_W_, this->state_);
  }

  /// `landing`: no further than to the first contact, because friction decides the rest of the path.
  void go(const Vec3& to_W, bool landing) noexcept
  {
    const ContactResult before = this->result_;
    this->result_ = this->tickTo(to_W).run(landing);
    this->result_.passes += before.passes;
    this->result_.sweeps += before.sweeps;
    this->result_.work += before.work;
  }

  /// True if nothing is left to be judged, or no work to do it with.
  [[nodiscard]] bool isOver() const noexcept
  {
    return this->state_.count == 0 || this->result_.capped || this->result_.overBudget || this->result_.infeasible;
  }

  /// For a ball that has left the surface, or stands beside its supposed contact: friction has no effect.
  [[nodiscard]] ContactResult goFreely() noexcept
  {
    this->state_.count = 0;
    this->go(this->p_W_, false);
    return this->end(false);
  }

  [[nodiscard]] ContactResult stick(const FrictionVerdict& verdict) noexcept
  {
    FrictionlessMove<AnyScene> tick = this->tickTo(this->p_W_);
    if (tick.wayIsOpen() || tick.wayIsFree())
    {
      return this->goFreely();
    }
    this->result_.proxy_W = this->state_.x_W;
    this->result_.held = verdict.held;
    this->result_.heldCount = this->result_.contacts = verdict.contacts;
    this->result_.friction = FrictionState::Sticks;
    return this->result_;
  }

  [[nodiscard]] ContactResult end(bool slips) noexcept
  {
    this->state_.slips = slips;
    this->result_.friction = slips ? FrictionState::Slips : FrictionState::None;
    return this->result_;
  }

  const AnyScene& scene_;
  const ContactPlan& plan_;
  const Vec3 p_W_;
  GodObjectState& state_;
  PathSink* sink_;
  ContactResult result_;
};

/// The tick without shading.
template<SceneView AnyScene>
ContactResult moveUnshaded(
  const AnyScene& scene, const ContactPlan& plan, const Vec3& p_W, GodObjectState& state, PathSink* sink) noexcept
{
  return frictionMatters(scene, plan) ? FrictionMove(scene, plan, p_W, state, sink).run()
                                      : FrictionlessMove(scene, plan, p_W, state, sink).run();
}

} // namespace palpate
