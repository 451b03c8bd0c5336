// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/MechanismWorker.h"

#include <utility>

#include "haptics/session/beside/InItsMemory.h"
#include "haptics/session/mechanism/MechanismTouch.h"

namespace palpate
{
namespace
{

/// As often or not.
bool isSame(const MechanismChoice& a, const MechanismChoice& b)
{
  return a.inputs == b.inputs && a.name == b.name;
}

std::vector<MechanismSoftInput> bodiesOf(const MechanismChoice& choice)
{
  return choice.inputs ? choice.inputs->soft : std::vector<MechanismSoftInput>();
}

bool isSame(const MechanismGrip& a, const MechanismGrip& b)
{
  return a.coupling_N_per_u == b.coupling_N_per_u && a.turning_Nu_per_rad == b.turning_Nu_per_rad;
}

} // namespace

/// A session without a mechanism has no thread for one.
void MechanismWorker::take(const MechanismChoice& choice, const MechanismGrip& grip)
{
  {
    const std::lock_guard lock(this->mutex_);
    const bool told = choice.inputs || this->wanted_.choice.inputs;
    this->status_.building = this->status_.building || (choice.inputs && !isSame(choice, this->wanted_.choice));
    if (bodiesOf(choice) != bodiesOf(this->wanted_.choice))
    {
      this->building_.request_stop();
      this->building_ = std::stop_source();
    }
    this->wanted_ = { choice, grip, this->building_.get_token() };
    this->news_ = this->news_ || told;
  }
  if (choice.inputs && !this->virtualTime_ && !this->thread_.runs())
  {
    this->thread_.begin([this] { return this->run(); });
  }
}

double MechanismWorker::run()
{
  double period_s = PacedThread::idle_s;
  inItsMemory(
    [&]
    {
      this->obey();
      if (this->plan_.revision != 0)
      {
        period_s = PacedThread::periodOf(this->now_.choice.rate_Hz);
        this->listen();
        this->publish(this->bodies_->press(period_s));
      }
    },
    [this] { this->giveUp(); });
  return period_s;
}

void MechanismWorker::step(double time_s)
{
  inItsMemory(
    [&]
    {
      this->obey();
      if (this->plan_.revision != 0)
      {
        this->listen();
        (void)this->bodies_->at(time_s);
        this->publish(true);
      }
    },
    [this] { this->giveUp(); });
}

void MechanismWorker::giveUp()
{
  this->links_.felt.publish(nullptr);
  this->plan_ = {};
  this->bodies_.reset();
  this->madeOf_.clear();
  const std::lock_guard lock(this->mutex_);
  this->status_ = {};
  this->status_.problem = "the mechanism's soft bodies are too large: memory is used up; mesh them coarser";
}

void MechanismWorker::obey()
{
  if (!this->news_.exchange(false))
  {
    return;
  }
  const Order before = this->now_;
  {
    const std::lock_guard lock(this->mutex_);
    this->now_ = this->wanted_;
  }
  const Order& order = this->now_;
  if (this->stopped_ || !isSame(order.choice, before.choice))
  {
    this->build(order);
  }
  else if (this->bodies_ && !isSame(order.grip, before.grip))
  {
    this->judgeAnew(order);
  }
  if (this->bodies_ && order.choice.rate_Hz != before.choice.rate_Hz)
  {
    this->bodies_->pace(PacedThread::periodOf(order.choice.rate_Hz));
  }
}

/// What one hand can hold another cannot.
void MechanismWorker::judgeAnew(const Order& order)
{
  MechanismCheck check = this->judge(order);
  if (check.faults.empty() != (this->plan_.revision != 0))
  {
    this->build(order);
    return;
  }
  const std::lock_guard lock(this->mutex_);
  this->status_.check = std::move(check);
}

MechanismCheck MechanismWorker::judge(const Order& order) const
{
  return checkMechanism(order.choice.inputs->mechanism, this->bodies_->atRest(), order.grip);
}

/// Factors take long: laws that are changed leave the bodies as they are, pressed or not.
void MechanismWorker::makeBodies(const Order& order, std::string& refusal)
{
  const std::vector<MechanismSoftInput>& soft = order.choice.inputs->soft;
  if (!this->bodies_ || soft != this->madeOf_)
  {
    this->links_.felt.publish(nullptr);
    this->bodies_.reset();
    this->madeOf_.clear();
    this->bodies_ = MechanismBodies::make(soft, refusal, order.stop);
    this->madeOf_ = this->bodies_ ? soft : std::vector<MechanismSoftInput>();
  }
}

void MechanismWorker::build(const Order& order)
{
  MechanismStatus status;
  this->plan_ = {};
  this->published_ = false;
  if (order.choice.inputs)
  {
    this->makeBodies(order, status.problem);
  }
  else
  {
    this->bodies_.reset();
    this->madeOf_.clear();
  }
  if (this->bodies_)
  {
    status.check = this->judge(order);
    status.problem = faultsOf(status.check);
  }
  if (this->bodies_ && status.problem.empty())
  {
    status.problem = this->plan(order);
  }
  if (this->plan_.revision == 0)
  {
    this->links_.felt.publish(nullptr);
  }
  this->stopped_ = !this->bodies_ && order.stop.stop_requested();
  const std::lock_guard lock(this->mutex_);
  status.building = this->plan_.revision != 0 || this->news_; // until it is published
  if (order.stop.stop_requested())
  {
    status = {};
    status.building = this->wanted_.choice.inputs != nullptr;
  }
  this->status_ = std::move(status);
}

/// Empty, or why it cannot be held.
std::string MechanismWorker::plan(const Order& order)
{
  const MechanismPlan plan = planMechanism(order.choice.inputs->mechanism, this->bodies_->atRest(), this->plans_ + 1);
  if (std::string refusal = refuseHeld(plan); !refusal.empty())
  {
    return refusal;
  }
  ++this->plans_;
  this->plan_ = plan;
  this->bodies_->hold(plan);
  this->bodies_->pace(PacedThread::periodOf(order.choice.rate_Hz));
  return {};
}

/// Presses of another plan are on places of its own; those of the bodies' own plan are what the next packets stand on.
void MechanismWorker::listen()
{
  MechanismHand hand = this->links_.hand.read();
  const bool ofThese = hand.plan == this->plan_.revision;
  hand.pressCount = ofThese ? hand.pressCount : 0;
  this->bodies_->tell(hand);
  this->watchOverlaps(ofThese ? &hand : nullptr);
}

/// Where the hand holds nothing of this plan no body is anywhere.
void MechanismWorker::watchOverlaps(const MechanismHand* hand)
{
  std::vector<BodyPair> overlaps;
  if (hand)
  {
    overlaps =
      this->watch_.look(this->now_.choice.inputs->mechanism, this->bodies_->newestNamed(), hand->pose_W, hand->phases);
  }
  const std::lock_guard lock(this->mutex_);
  this->status_.overlaps = std::move(overlaps);
}

/// Told to the owner first: what the servo takes must be there for a recording. `all`: none of the bodies has failed.
void MechanismWorker::publish(bool all)
{
  {
    const std::lock_guard lock(this->mutex_);
    this->status_.problem =
      all ? "" : "a soft body's stiffness can no more be factored: it stays as it was; let go of it";
  }
  const bool others = this->bodies_->changed();
  if (!all || (this->published_ && !others))
  {
    return;
  }
  auto felt = std::make_shared<const FeltMechanism>(++this->revision_, this->plan_, this->bodies_->newest());
  this->published_ = true;
  this->made_.put(felt);
  this->links_.felt.publish(std::move(felt));
  std::vector<SeenBody> seen = this->bodies_->seen(); // while the servo has it
  const std::lock_guard lock(this->mutex_);
  ++this->status_.packets;
  this->status_.building = this->news_;
  this->status_.plan = this->plan_.revision;
  this->status_.soft = std::move(seen);
  this->status_.atRest = this->bodies_->first();
}

MechanismStatus MechanismWorker::status() const
{
  const std::lock_guard lock(this->mutex_);
  return this->status_;
}

} // namespace palpate
