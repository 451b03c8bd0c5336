// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/session/mechanism/MechanismWorker.h"

#include <new>
#include <utility>

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
    this->wanted_ = { choice, grip };
    this->news_ = this->news_ || told;
  }
  if (choice.inputs && !this->virtualTime_ && !this->thread_.runs())
  {
    this->thread_.begin([this] { return this->run(); });
  }
}

double MechanismWorker::run()
{
  this->obey();
  const bool felt = this->plan_.revision != 0;
  const double period_s = felt ? PacedThread::periodOf(this->now_.choice.rate_Hz) : PacedThread::idle_s;
  if (felt)
  {
    this->inItsMemory(
      [&]
      {
        this->listen();
        this->publish(this->bodies_->press(period_s));
      });
  }
  return period_s;
}

void MechanismWorker::step(double time_s)
{
  this->obey();
  if (this->plan_.revision != 0)
  {
    this->inItsMemory(
      [&]
      {
        this->listen();
        (void)this->bodies_->at(time_s);
        this->publish(true);
      });
  }
}

/// No room in memory for a factor is no reason to end the program that asked for it.
template<class Work>
void MechanismWorker::inItsMemory(const Work& work)
{
  try
  {
    work();
  }
  catch (const std::bad_alloc&)
  {
    this->links_.felt.publish(nullptr);
    this->plan_ = {};
    this->bodies_.reset();
    this->madeOf_.clear();
    const std::lock_guard lock(this->mutex_);
    this->status_ = {};
    this->status_.problem = "the mechanism's soft bodies are too large: memory is used up; mesh them coarser";
  }
}

void MechanismWorker::obey()
{
  if (!this->news_.exchange(false))
  {
    return;
  }
  Order order;
  {
    const std::lock_guard lock(this->mutex_);
    order = this->wanted_;
  }
  if (!isSame(order.choice, this->now_.choice))
  {
    this->inItsMemory([&] { this->build(order); });
  }
  else if (this->bodies_ && !isSame(order.grip, this->now_.grip))
  {
    MechanismCheck check = this->judge(order);
    if (check.faults.empty() != (this->plan_.revision != 0)) // what one hand can hold another cannot
    {
      this->inItsMemory([&] { this->build(order); });
    }
    else
    {
      const std::lock_guard lock(this->mutex_);
      this->status_.check = std::move(check);
    }
  }
  if (this->bodies_ && order.choice.rate_Hz != this->now_.choice.rate_Hz)
  {
    this->bodies_->pace(PacedThread::periodOf(order.choice.rate_Hz));
  }
  this->now_ = std::move(order);
}

MechanismCheck MechanismWorker::judge(const Order& order) const
{
  return checkMechanism(order.choice.inputs->mechanism, this->bodies_->atRest(), order.grip);
}

/// Factors take long: laws that are changed leave the bodies as they are, pressed or not.
void MechanismWorker::makeBodies(const MechanismInputs& inputs, std::string& refusal)
{
  if (!this->bodies_ || inputs.soft != this->madeOf_)
  {
    this->links_.felt.publish(nullptr);
    this->bodies_.reset();
    this->madeOf_.clear();
    this->bodies_ = MechanismBodies::make(inputs.soft, refusal);
    this->madeOf_ = this->bodies_ ? inputs.soft : std::vector<MechanismSoftInput>();
  }
}

void MechanismWorker::build(const Order& order)
{
  MechanismStatus status;
  this->plan_ = {};
  this->published_ = false;
  if (order.choice.inputs)
  {
    this->makeBodies(*order.choice.inputs, status.problem);
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
  const std::lock_guard lock(this->mutex_);
  status.building = this->plan_.revision != 0 || this->news_; // until it is published
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
  hand.pressCount = hand.plan == this->plan_.revision ? hand.pressCount : 0;
  this->bodies_->tell(hand);
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
