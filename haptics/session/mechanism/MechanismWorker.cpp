// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/MechanismWorker.h"

#include <utility>

#include "haptics/core/PoseMath.h"
#include "haptics/recording/inputs/Mechanisms.h"
#include "haptics/session/mechanism/MechanismTouch.h"

namespace palpate
{

std::optional<double> MechanismTask::iterate()
{
  if (this->plan_.revision == 0)
  {
    return std::nullopt;
  }
  this->readHand();
  this->publish(this->bodies_->press(this->period_s()));
  return this->period_s();
}

void MechanismTask::step(double time_s)
{
  if (this->plan_.revision != 0)
  {
    this->readHand();
    (void)this->bodies_->at(time_s);
    this->publish(true);
  }
}

void MechanismTask::giveUp()
{
  this->links_.felt.publish(nullptr);
  this->plan_ = {};
  this->bodies_.reset();
  this->madeOf_.clear();
  this->channel_.report(
    [](MechanismStatus& status, const Order&)
    {
      status = {};
      status.problem = "not enough memory for the soft bodies of the mechanism: use a coarser mesh";
    });
}

bool MechanismTask::apply(Order order, const std::stop_token& stop, bool again)
{
  const Order before = std::exchange(this->now_, std::move(order));
  bool interrupted = false;
  if (again || !this->now_.isSame(before))
  {
    interrupted = this->build(stop);
  }
  else if (this->bodies_ && this->now_.grip != before.grip)
  {
    interrupted = this->judgeAnew(stop);
  }
  if (this->bodies_ && this->now_.choice.rate_Hz != before.choice.rate_Hz)
  {
    this->bodies_->pace(this->period_s());
  }
  return interrupted;
}

/// A mechanism that one hand can hold may be unstable in another.
bool MechanismTask::judgeAnew(const std::stop_token& stop)
{
  MechanismCheck check = this->judge();
  if (check.faults.empty() != (this->plan_.revision != 0))
  {
    return this->build(stop);
  }
  this->channel_.report([&check](MechanismStatus& status, const Order&) { status.check = std::move(check); });
  return false;
}

MechanismCheck MechanismTask::judge() const
{
  return checkMechanism(this->now_.choice.inputs->mechanism, this->bodies_->atRest(), this->now_.grip);
}

/// Factors take long: constraints that are changed leave the bodies as they are, pressed or not.
void MechanismTask::makeBodies(std::string& refusal, const std::stop_token& stop)
{
  const std::vector<MechanismSoftInput> soft = this->now_.soft();
  if (!this->bodies_ || soft != this->madeOf_)
  {
    this->links_.felt.publish(nullptr);
    this->bodies_.reset();
    this->madeOf_.clear();
    this->bodies_ = MechanismBodies::make(soft, refusal, stop);
    this->madeOf_ = this->bodies_ ? soft : std::vector<MechanismSoftInput>();
  }
}

bool MechanismTask::build(const std::stop_token& stop)
{
  MechanismStatus made;
  this->plan_ = {};
  this->published_ = false;
  if (this->now_.isActive())
  {
    this->makeBodies(made.problem, stop);
  }
  else
  {
    this->bodies_.reset();
    this->madeOf_.clear();
  }
  if (this->bodies_)
  {
    made.check = this->judge();
    made.problem = faultsOf(made.check);
  }
  if (this->bodies_ && made.problem.empty())
  {
    made.problem = this->plan();
  }
  if (this->plan_.revision == 0)
  {
    this->links_.felt.publish(nullptr);
  }
  this->channel_.report(
    [&](MechanismStatus& status, const Order& wanted)
    {
      const bool stopped = stop.stop_requested();
      made.building = this->plan_.revision != 0 || this->channel_.hasNews(); // until it is published
      status = stopped ? MechanismStatus{} : std::move(made);
      status.building = stopped ? wanted.isActive() : status.building;
    });
  return !this->bodies_ && stop.stop_requested();
}

/// Empty, or why it cannot be held.
std::string MechanismTask::plan()
{
  const MechanismPlan plan =
    planMechanism(this->now_.choice.inputs->mechanism, this->bodies_->atRest(), this->plans_ + 1);
  if (std::string refusal = refuseHeld(plan); !refusal.empty())
  {
    return refusal;
  }
  ++this->plans_;
  this->plan_ = plan;
  this->bodies_->hold(this->now_.choice.inputs->mechanism, plan);
  this->bodies_->pace(this->period_s());
  return {};
}

/// Forces of another plan are at places of its own, unless it is continued; those of the bodies' own plan are the load
/// of the next snapshots.
void MechanismTask::readHand()
{
  MechanismHand hand = this->links_.hand.read();
  const bool ofThese = hand.plan == this->plan_.revision;
  hand.pressCount = this->bodies_->knows(hand.plan) ? hand.pressCount : 0;
  this->bodies_->tell(hand);
  this->watchOverlaps(ofThese ? &hand : nullptr);
  this->watchWire(ofThese);
}

/// `ofThese`: the servo has this plan.
void MechanismTask::watchWire(bool ofThese)
{
  std::vector<Vec3> wire_W;
  if (this->plan_.wire && ofThese)
  {
    const WirePlaces& places_M = this->links_.wire.read();
    for (int i = 0; i < this->plan_.wire->wire.nodes(); ++i)
    {
      wire_W.push_back(this->plan_.wire->mouth_W * places_M[static_cast<std::size_t>(i)].p);
    }
  }
  this->channel_.report([&wire_W](MechanismStatus& status, const Order&) { status.wire_W = std::move(wire_W); });
}

/// Where the hand holds nothing of this plan no body is anywhere.
void MechanismTask::watchOverlaps(const MechanismHand* hand)
{
  std::vector<BodyPair> overlaps;
  if (hand)
  {
    overlaps =
      this->watch_.look(this->now_.choice.inputs->mechanism, this->bodies_->newestNamed(), hand->pose_W, hand->phases);
  }
  this->channel_.report([&overlaps](MechanismStatus& status, const Order&) { status.overlaps = std::move(overlaps); });
}

/// `all`: none of the bodies has failed.
void MechanismTask::publish(bool all)
{
  this->channel_.report(
    [all](MechanismStatus& status, const Order&)
    {
      status.problem = all ? ""
                           : "The stiffness matrix of a soft body is no longer positive definite (the body is "
                             "overloaded). The last shape is kept; release the body";
    });
  const bool others = this->bodies_->changed();
  if (!all || (this->published_ && !others))
  {
    return;
  }
  auto felt = std::make_shared<const FeltMechanism>(
    ++this->revision_, this->plan_, this->bodies_->newest(), this->bodies_->found(), this->bodies_->meshes());
  this->published_ = true;
  this->links_.felt.publish(std::move(felt));
  std::vector<SeenBody> seen = this->bodies_->seen(); // while the servo has it
  this->channel_.report(
    [this, &seen](MechanismStatus& status, const Order&)
    {
      ++status.snapshots;
      status.building = this->channel_.hasNews();
      status.plan = this->plan_.revision;
      status.soft = std::move(seen);
      status.atRest = this->bodies_->first();
    });
}

} // namespace palpate
