// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/PathTouch.h"

#include <limits>
#include <optional>
#include <utility>

#include "haptics/field/UsualGradient.h"

namespace palpate
{

PathTouch::PathTouch(std::shared_ptr<const Scene> scene, const HapticParameters& parameters, double first_s)
  : scene_(std::move(scene)), parameters_(parameters)
{
  this->parameters_.safety = SafetyLimits::none();
  this->parameters_.contact.seatsBySide = true;
  this->input_.scene = this->scene_.get();
  this->input_.dt_s = first_s;
}

void PathTouch::feel(std::shared_ptr<const FieldSource> field)
{
  this->field_.setSource(std::move(field));
  this->knowsSlope_ = false;
}

/// What a detent's strength is said for is looked up in the first brick, as a session does it: no brick changes the
/// feel.
void PathTouch::followField(const Pose& hand_D)
{
  const Vec3 hand_W = this->parameters_.map.toScene(hand_D.p);
  const FieldPlan& plan = this->parameters_.field;
  const std::optional<double> level = plan.isosurface ? std::optional(plan.isovalue) : std::nullopt;
  const auto next = this->field_.follow(hand_W, std::numeric_limits<double>::infinity(), level, true);
  if (!next)
  {
    return;
  }
  this->brick_ = *next;
  this->input_.brick = this->brick_.get();
  if (this->brick_ && !std::exchange(this->knowsSlope_, true))
  {
    const double slope_per_u = usualGradient(*this->brick_);
    double& kept_per_u = this->parameters_.field.detent.slope_per_u;
    kept_per_u = slope_per_u > 0.0 ? slope_per_u : kept_per_u;
  }
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

HapticState PathTouch::next(double time_s, const Pose& hand_D)
{
  this->followField(hand_D);
  this->input_.dt_s = this->begun_ ? time_s - this->input_.sample.time_s : this->input_.dt_s;
  this->input_.tick += this->begun_ ? 1 : 0;
  this->begun_ = true;
  this->input_.sample.time_s = time_s;
  this->input_.sample.pose_D = hand_D;
  HapticState state = renderTick(this->input_, this->parameters_, this->state_).state;
  this->metField_ = this->metField_ || (this->brick_ && !state.field.outside);
  if (!this->scene_ && this->brick_)
  {
    return ofFieldAlone(state);
  }
  state.contacts += state.field.contacts;
  return state;
}

} // namespace palpate
