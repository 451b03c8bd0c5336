// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/path/PathTouch.h"

#include <limits>
#include <optional>
#include <utility>

#include "haptics/tick/SoftProxy.h"

namespace palpate
{

PathTouch::PathTouch(std::shared_ptr<const Scene> scene, const HapticParameters& parameters, double first_s)
  : scene_(std::move(scene)), parameters_(parameters)
{
  this->parameters_.safety = SafetyLimits::none();
  this->parameters_.softLate_s = std::numeric_limits<double>::infinity();
  this->parameters_.softBalances = false;
  this->parameters_.contact.seatsBySide = true;
  this->input_.scene = this->scene_.get();
  this->input_.dt_s = first_s;
}

void PathTouch::feel(std::shared_ptr<const FieldSource> field)
{
  this->field_.setSource(std::move(field));
  this->knowsSlope_ = false;
}

void PathTouch::followField(const Pose& hand_D)
{
  const Vec3 hand_W = this->parameters_.map.toScene(hand_D.p);
  FieldPlan& plan = this->parameters_.field;
  const auto next = this->field_.follow(hand_W, std::numeric_limits<double>::infinity(), plan, true);
  if (!next)
  {
    return;
  }
  this->brick_ = *next;
  this->input_.brick = this->brick_.get();
  const bool first = this->brick_ && !std::exchange(this->knowsSlope_, true);
  takeFromData(plan, this->field_.made(), first);
}

std::string PathTouch::detentText() const
{
  return this->springs_N_per_u_ > 0.0 ? palpate::detentText(this->parameters_.field, this->springs_N_per_u_) : "";
}

std::string PathTouch::latticeText() const
{
  const Vec3 hand_W = this->parameters_.map.toScene(this->input_.sample.pose_D.p);
  return palpate::latticeText(this->parameters_.field, this->field_.made(), hand_W);
}

std::string PathTouch::whyNothingOfField() const
{
  if (!this->field_.hasSource() || this->metField_)
  {
    return "";
  }
  const std::string& problem = this->field_.made().problem;
  return problem.empty() ? "the path is nowhere among its values" : problem;
}

void PathTouch::press(std::unique_ptr<BodyMaker> body, double rate_Hz)
{
  this->maker_ = std::move(body);
  this->maker_->touch(this->scene_);
  this->softScratch_ = std::make_unique<SoftScratch>();
  this->input_.softScratch = this->softScratch_.get();
  this->bodyHand_.radius_u = this->parameters_.contact.radius_u;
  if (rate_Hz > 0.0)
  {
    this->paced_.emplace(*this->maker_, 1.0 / rate_Hz);
    return;
  }
  this->parameters_.sceneBlend_s = 0.0; // each turn begins with another surface, and none is blended into the next
}

void PathTouch::takeBody(const PressedBody* body)
{
  const Scene* const before = this->input_.scene;
  this->input_.body = body;
  this->input_.scene = body != nullptr ? body->scene.get() : this->scene_.get();
  this->input_.previousScene = this->input_.scene != before && before != this->scene_.get() ? before : nullptr;
}

TickOutput PathTouch::compute()
{
  if (this->maker_ && !this->paced_)
  {
    return this->computeAtRest();
  }
  if (this->paced_)
  {
    this->takeBody(this->paced_->at(this->input_.sample.time_s, this->bodyHand_));
  }
  const TickOutput output = renderTick(this->input_, this->parameters_, this->state_);
  this->bodyHand_ = bodyHandOf(this->input_, output, this->state_);
  return output;
}

/// Body and contact take turns until the force stays: each turn begins where the tick before ended.
TickOutput PathTouch::computeAtRest()
{
  constexpr int mostTurns = 40;
  constexpr int stepsToRest = 20;
  constexpr double stays = 1e-9; // of the force
  const RendererState start = this->state_;
  const std::shared_ptr<const PressedBody> before = this->atRest_;
  TickOutput output;
  Vec3 force_N = Vec3::Zero();
  for (int turn = 0; turn < mostTurns; ++turn)
  {
    this->bodyHand_.tick = this->input_.tick;
    const auto body = this->maker_->press(this->bodyHand_, 0.0, stepsToRest);
    this->atRest_ = body ? body : this->atRest_;
    this->state_ = start;
    this->input_.scene = before ? before->scene.get() : nullptr;
    this->takeBody(this->atRest_.get());
    output = renderTick(this->input_, this->parameters_, this->state_);
    this->bodyHand_ = bodyHandOf(this->input_, output, this->state_);
    const double change_N = (output.state.rendered_D - force_N).norm();
    force_N = output.state.rendered_D;
    if (change_N <= stays * force_N.norm())
    {
      break;
    }
  }
  this->maker_->lookThrough(); // turns that come before the rest are not felt
  return output;
}

HapticState PathTouch::next(double time_s, const Pose& hand_D)
{
  this->followField(hand_D);
  this->input_.dt_s = this->begun_ ? time_s - this->input_.sample.time_s : this->input_.dt_s;
  this->input_.tick += this->begun_ ? 1 : 0;
  this->bodyHand_.ball_W = this->begun_ ? this->bodyHand_.ball_W : this->parameters_.map.toScene(hand_D.p);
  this->begun_ = true;
  this->input_.sample.time_s = time_s;
  this->input_.sample.pose_D = hand_D;
  HapticState state = this->compute().state;
  this->springs_N_per_u_ = state.stiffness_N_per_m / this->parameters_.map.scale_u_per_m;
  this->metField_ = this->metField_ || (this->brick_ && !state.field.outside);
  if (!this->scene_ && this->brick_)
  {
    return ofFieldAlone(state);
  }
  state.contacts += state.field.contacts;
  return state;
}

} // namespace palpate
