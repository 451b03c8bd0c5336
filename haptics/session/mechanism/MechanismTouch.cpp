// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/MechanismTouch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/core/PoseMath.h"

namespace palpate
{
namespace
{

constexpr double usualTick_s = 1e-3;

std::string refuseHold(const MechanismHold& hold)
{
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  const auto notNegative = [](double value) { return value >= 0.0 && std::isfinite(value); };
  if (!positive(hold.stiffness_N_per_m) || !positive(hold.scale_u_per_m))
  {
    return "the stiffness that a mechanism is held with and its scale must be finite numbers above 0";
  }
  return notNegative(hold.turning_N_m_per_rad) && notNegative(hold.lowRate_Hz)
           ? ""
           : "the turning stiffness that a mechanism is held with [N m/rad] and the low rate [Hz] must be finite "
             "numbers, 0 or above";
}

} // namespace

MechanismHold usualHold(double unit_m) noexcept
{
  MechanismHold hold;
  hold.scale_u_per_m = 1.0 / unit_m;
  hold.turning_N_m_per_rad = 1.0;
  return hold;
}

std::string refuseHeld(const MechanismPlan& plan)
{
  return plan.held < 0 ? "the hand holds no body of the mechanism: make one of them a held rod" : "";
}

MechanismGrip gripOf(const MechanismHold& hold) noexcept
{
  return { hold.stiffness_N_per_m / hold.scale_u_per_m, hold.turning_N_m_per_rad * hold.scale_u_per_m };
}

const char* wordsOf(ConstraintChange change) noexcept
{
  switch (change)
  {
    case ConstraintChange::Punctured:
      return "punctured";
    case ConstraintChange::Withdrawn:
      return "withdrawn";
    case ConstraintChange::Broken:
      return "broken";
    case ConstraintChange::TornOut:
      return "torn out";
  }
  return "";
}

std::string faultsOf(const MechanismCheck& check)
{
  std::string all;
  for (const std::string& fault : check.faults)
  {
    all += (all.empty() ? "" : "; ") + fault;
  }
  return all;
}

MechanismTouch::MechanismTouch(
  const Mechanism& mechanism, const MechanismHold& hold, std::unique_ptr<MechanismBodies> bodies)
  : mechanism_(mechanism), hold_(hold), grip_(gripOf(hold)), bodies_(std::move(bodies))
{
}

std::unique_ptr<MechanismTouch> MechanismTouch::make(
  const MechanismInputs& inputs, const MechanismHold& hold, std::string& refusal)
{
  refusal = refuseHold(hold);
  auto bodies = refusal.empty() ? MechanismBodies::make(inputs.soft, refusal) : nullptr;
  if (!bodies)
  {
    return nullptr;
  }
  std::unique_ptr<MechanismTouch> touch(new MechanismTouch(inputs.mechanism, hold, std::move(bodies)));
  touch->check_ = checkMechanism(inputs.mechanism, touch->bodies_->atRest(), touch->grip_);
  refusal = faultsOf(touch->check_);
  if (!refusal.empty())
  {
    return nullptr;
  }
  touch->plan_ = planMechanism(inputs.mechanism, touch->bodies_->atRest(), 1);
  refusal = refuseHeld(touch->plan_);
  if (!refusal.empty())
  {
    return nullptr;
  }
  touch->bodies_->hold(inputs.mechanism, touch->plan_);
  if (hold.lowRate_Hz > 0.0)
  {
    touch->bodies_->pace(1.0 / hold.lowRate_Hz);
  }
  return touch;
}

MechanismHand MechanismTouch::handOf(const MechanismInput& input, const MechanismResult& result) const
{
  const Pose& held_W = input.hand_W;
  const double length_u = this->plan_.held >= 0 ? this->plan_.bodies[this->plan_.held].length_u : 0.0;
  MechanismHand hand;
  hand.tick = input.tick;
  hand.plan = this->plan_.revision;
  hand.hand_W = held_W.p;
  hand.tip_W = held_W * (length_u * Vec3::UnitZ());
  hand.press(result);
  return hand;
}

MechanismResult MechanismTouch::compute(MechanismInput& input)
{
  if (this->hold_.lowRate_Hz == 0.0)
  {
    return this->computeAtRest(input);
  }
  input.soft = this->bodies_->at(this->time_s_);
  input.found = this->newestFound();
  return this->tick_.step(input);
}

/// Bodies and constraints take turns until the force stays: each turn begins where the tick before ended, or where the
/// mesh came to in this one.
MechanismResult MechanismTouch::computeAtRest(MechanismInput& input)
{
  constexpr int mostTurns = 40;
  constexpr int stepsToRest = 20;
  constexpr double stays = 1e-9; // of the force
  MechanismState start = this->tick_.state();
  MechanismResult result;
  Vec3 force_N = Vec3::Zero();
  for (int turn = 0; turn < mostTurns; ++turn)
  {
    this->tick_.restore(start);
    input.soft = this->bodies_->rest(stepsToRest);
    input.found = this->newestFound();
    result = this->tick_.step(input);
    this->bodies_->tell(this->handOf(input, result));
    if (result.ahead)
    {
      start = this->tick_.state(); // the mesh goes as far as contacts were looked for, and on from there
      continue;
    }
    const double change_N = (result.exact_W.force - force_N).norm();
    force_N = result.exact_W.force;
    if (change_N <= stays * force_N.norm())
    {
      break;
    }
  }
  return result;
}

/// The held body is where the hand is, the others are where they begin, before any tick.
void MechanismTouch::begin(const MechanismInput& input, const Pose& hand_W)
{
  MechanismHand hand = this->handOf(input, {});
  std::ranges::transform(this->plan_.bodies, hand.pose_W.begin(), &PlannedBody::pose_W);
  hand.pose_W[static_cast<std::size_t>(this->plan_.held)] = input.hand_W;
  this->bodies_->tell(hand);
  if (this->mechanism_.findsContacts)
  {
    this->begunIn_ = overlapsOfHeld(this->mechanism_, this->bodies_->atRest(), hand_W);
  }
}

const FoundContacts* MechanismTouch::newestFound() const noexcept
{
  const FoundContacts& found = this->bodies_->found();
  return found.answer != 0 ? &found : nullptr;
}

MechanismResult MechanismTouch::next(double time_s, const Pose& hand_W)
{
  MechanismInput input;
  input.tick = ++this->count_;
  input.dt_s = this->count_ > 1 ? time_s - this->time_s_ : usualTick_s;
  input.plan = &this->plan_;
  input.hand_W = heldBy(hand_W, this->plan_);
  input.grip = this->grip_;
  input.meshes = this->bodies_->meshes().get();
  this->time_s_ = time_s;
  if (this->count_ == 1)
  {
    this->begin(input, hand_W);
  }
  MechanismResult result = this->compute(input);
  const MechanismHand hand = this->handOf(input, result);
  this->bodies_->tell(hand);
  (void)this->watch_.look(this->mechanism_, this->bodies_->newestNamed(), hand.pose_W, hand.phases);
  result.wrench_W.torque /= this->hold_.scale_u_per_m;
  result.exact_W.torque /= this->hold_.scale_u_per_m;
  return result;
}

} // namespace palpate
