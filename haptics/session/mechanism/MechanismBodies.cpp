// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/MechanismBodies.h"

#include <utility>

namespace palpate
{

std::unique_ptr<MechanismBodies> MechanismBodies::make(
  const std::vector<MechanismSoftInput>& inputs, std::string& refusal, const std::stop_token& stop)
{
  std::unique_ptr<MechanismBodies> made(new MechanismBodies());
  for (const MechanismSoftInput& input : inputs)
  {
    auto maker = BodyMaker::make(*input.input, input.name, 0, refusal, stop);
    BodyHand pressed;
    pressed.tip_u = input.tip_u;
    auto first = maker ? maker->press(pressed, 0.0) : nullptr;
    if (!first)
    {
      refusal = input.name + ": " + (refusal.empty() ? "its stiffness matrix is singular" : refusal);
      return nullptr;
    }
    made->asMade_.push_back(std::make_shared<const CheckedTetras>(maker->checked()));
    made->makers_.push_back(std::move(maker));
    made->newest_.push_back(std::move(first));
    made->hands_.push_back(pressed);
    made->atRest_.push_back({ input.name, made->newest_.back().get() });
    made->given_.push_back(made->newest_.back().get());
  }
  made->first_ = made->newest_;
  made->places_.resize(made->makers_.size());
  return made;
}

void MechanismBodies::hold(const MechanismPlan& plan)
{
  this->places_.assign(this->makers_.size(), {});
  for (int i = 0; i < plan.lawCount; ++i)
  {
    const PlannedConstraint& law = plan.laws[i];
    const int softA = plan.bodies[law.a].soft;
    const int softB = plan.bodies[law.b].soft;
    if (softA >= 0)
    {
      this->places_[softA].push_back(law.place_A);
    }
    if (softB >= 0 && law.kind != ConstraintKind::Puncture) // which may be anywhere
    {
      this->places_[softB].push_back(law.place_B);
    }
  }
}

void MechanismBodies::tell(const MechanismHand& told)
{
  for (std::size_t b = 0; b < this->hands_.size(); ++b)
  {
    BodyHand& hand = this->hands_[b];
    hand.tick = told.tick;
    hand.revision = this->given_[b] != nullptr ? this->given_[b]->revision : 0;
    hand.device_W = told.hand_W;
    hand.ball_W = told.tip_W;
    hand.count = 0;
    for (const MechanismPress& press : told.pressing())
    {
      if (press.soft == static_cast<int>(b) && hand.count < BodyHand::most)
      {
        hand.forceAt[hand.count] = press.at;
        hand.force_N[hand.count++] = press.force_N;
      }
    }
    // Points without a force now are answered as well: a constraint may press there in the next tick.
    for (std::size_t i = 0; i < this->places_[b].size() && hand.count < BodyHand::most; ++i)
    {
      hand.forceAt[hand.count] = this->places_[b][i];
      hand.force_N[hand.count++] = Vec3::Zero();
    }
  }
}

void MechanismBodies::pace(double period_s)
{
  this->paced_.clear();
  for (const auto& maker : this->makers_)
  {
    this->paced_.emplace_back(*maker, period_s);
  }
}

std::span<const PressedBody* const> MechanismBodies::at(double time_s)
{
  for (std::size_t b = 0; b < this->paced_.size(); ++b)
  {
    (void)this->paced_[b].at(time_s, this->hands_[b]);
    this->newest_[b] = this->paced_[b].now() ? this->paced_[b].now() : this->newest_[b];
    this->given_[b] = this->newest_[b].get();
  }
  return this->given_;
}

bool MechanismBodies::pressEach(double period_s, int newtonSteps)
{
  bool all = true;
  for (std::size_t b = 0; b < this->makers_.size(); ++b)
  {
    auto body = this->makers_[b]->press(this->hands_[b], period_s, newtonSteps);
    all = all && body;
    this->newest_[b] = body ? std::move(body) : this->newest_[b];
    this->given_[b] = this->newest_[b].get();
  }
  return all;
}

std::span<const PressedBody* const> MechanismBodies::rest(int newtonSteps)
{
  (void)this->pressEach(0.0, newtonSteps);
  return this->given_;
}

bool MechanismBodies::press(double period_s)
{
  return this->pressEach(period_s, BodyMaker::usualSteps);
}

std::vector<MechanismSoft> MechanismBodies::newestNamed() const
{
  std::vector<MechanismSoft> named = this->atRest_;
  for (std::size_t b = 0; b < named.size(); ++b)
  {
    named[b].body = this->newest_[b].get();
  }
  return named;
}

std::vector<SeenBody> MechanismBodies::seen() const
{
  std::vector<SeenBody> bodies;
  for (std::size_t b = 0; b < this->makers_.size(); ++b)
  {
    bodies.push_back({ this->asMade_[b], std::make_shared<const BodyShape>(this->makers_[b]->shape()) });
  }
  return bodies;
}

bool MechanismBodies::changed()
{
  const bool others = this->asked_ != this->newest_;
  this->asked_ = this->newest_;
  return others;
}

} // namespace palpate
